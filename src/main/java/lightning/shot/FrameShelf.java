package lightning.shot;

import java.util.Map;
import java.util.TreeMap;
import lightning.cache.PixelCache;
import lightning.relight.MemoryNeed;

/** The caches of frames, as many as have room: those nearest to the focus stay. Any thread may call. */
final class FrameShelf {
    private final long memory;
    private final Map<Integer, Resting> frames = new TreeMap<>();
    private long bytes;
    private int focus;

    /** A frame that nobody works on. */
    private record Resting(PixelCache cache, long bytes) {}

    /** @param memory bytes that frames may take */
    FrameShelf(long memory) {
        this.memory = memory;
    }

    /** What is kept of a frame; null for nothing. */
    synchronized PixelCache get(int frame) {
        Resting resting = frames.get(frame);
        return resting == null ? null : resting.cache;
    }

    /** Keeps a frame in place of what was kept of it, if there is room. */
    synchronized void put(int frame, PixelCache cache) {
        remove(frame);
        long more = MemoryNeed.of(cache);
        frames.put(frame, new Resting(cache, more));
        bytes += more;
        while (bytes > memory) {
            remove(farthest());
        }
    }

    private int farthest() {
        int farthest = -1;
        for (int frame : frames.keySet()) {
            farthest = farthest < 0 || Math.abs(frame - focus) >= Math.abs(farthest - focus) ? frame : farthest;
        }
        return farthest;
    }

    synchronized void remove(int frame) {
        Resting gone = frames.remove(frame);
        bytes -= gone == null ? 0 : gone.bytes;
    }

    synchronized void focus(int frame) {
        focus = frame;
    }

    synchronized KeptBytes bytes() {
        return new KeptBytes(frames.size(), bytes, 0, 0);
    }

    synchronized void clear() {
        frames.clear();
        bytes = 0;
    }
}
