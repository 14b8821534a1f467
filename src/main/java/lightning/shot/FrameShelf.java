package lightning.shot;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import lightning.base.text.Texts;
import lightning.render.cache.CacheColumns;
import lightning.render.cache.CacheOutline;
import lightning.render.cache.PixelCache;
import lightning.render.relight.MemoryNeed;

/**
 * The caches of frames: in memory as far as they have room there, those nearest to the focus; the others on disk; and where that has no
 * room either, nowhere. Any thread may call, of one frame one at a time.
 */
final class FrameShelf implements AutoCloseable {
    private final long memory;
    /** Null where nothing is kept on disk. */
    private final FrameFolder folder;
    private final boolean firm;
    private final Map<Integer, Resting> frames = new TreeMap<>();
    private long bytes;
    private int focus;

    /** A frame that nobody works on: in memory, on disk, or in both while it goes from one to the other. */
    private static final class Resting {
        final int frame;
        final CacheOutline outline;
        final long bytes;
        /** Null where it is on disk alone. */
        PixelCache cache;
        FrameFolder.Part rows;
        FrameFolder.Part colors;
        boolean leaves;

        Resting(int frame, PixelCache cache) {
            this.frame = frame;
            this.cache = cache;
            outline = CacheOutline.of(cache);
            bytes = MemoryNeed.of(cache);
        }
    }

    /**
     * @param memory bytes that frames may take in memory
     * @param folder closed with this; null for none
     * @param firm   whether what is kept stays: a frame that comes finds no room, in place of those that go
     */
    FrameShelf(long memory, FrameFolder folder, boolean firm) {
        this.memory = memory;
        this.folder = folder;
        this.firm = firm;
    }

    /** Whether what is kept stays. */
    boolean isFirm() {
        return firm;
    }

    /** Bytes that frames may still take. */
    synchronized long room() {
        long half = Long.MAX_VALUE / 2;
        return Math.min(half, memory - bytes) + (folder == null ? 0 : Math.min(half, folder.room()));
    }

    /** What is kept of a frame; null for nothing. */
    PixelCache get(int frame) {
        while (true) {
            Resting resting;
            FrameFolder.Part rows;
            FrameFolder.Part colors;
            synchronized (this) {
                resting = frames.get(frame);
                if (resting == null || resting.cache != null) {
                    return resting == null ? null : resting.cache;
                }
                rows = resting.rows;
                colors = resting.colors;
            }
            try {
                return folder.read(resting.outline, rows, colors);
            } catch (IOException e) {
                if (isUnreadable(resting, e)) {
                    return null;
                }
            }
        }
    }

    /** What cannot be read is nothing any more, unless somebody put the frame there anew meanwhile. */
    private synchronized boolean isUnreadable(Resting resting, IOException e) {
        if (frames.get(resting.frame) != resting) {
            return false;
        }
        folder.tell(Texts.of("a frame's file could not be read: {0}", e.getMessage()));
        remove(resting.frame);
        return true;
    }

    /**
     * Keeps a frame in place of what was kept of it, if there is room.
     *
     * @param before what {@link #get} gave of it; may be null
     * @return whether nothing had to go for it that should stay; else nothing is kept of the frame
     */
    boolean put(int frame, PixelCache cache, PixelCache before) {
        Resting resting = new Resting(frame, cache);
        synchronized (this) {
            Resting old = frames.put(frame, resting);
            bytes += resting.bytes;
            if (old != null) {
                bytes -= old.cache != null && !old.leaves ? old.bytes : 0;
                if (before != null && old.rows != null && !isUnderWay(old) && CacheColumns.shareRows(before, cache)) {
                    resting.rows = old.rows;
                    old.rows = null;
                }
                drop(old);
            }
        }
        for (Resting far = farthest(); far != null; far = farthest()) {
            if (!toDisk(far) && firm) {
                remove(frame);
                return false;
            }
        }
        return true;
    }

    /** The frame that must leave memory next, which is about to; null where all have room. */
    private synchronized Resting farthest() {
        if (bytes <= memory) {
            return null;
        }
        Resting farthest = null;
        for (Resting resting : frames.values()) {
            boolean stays = resting.cache != null && !resting.leaves;
            if (stays && (farthest == null || Math.abs(resting.frame - focus) >= Math.abs(farthest.frame - focus))) {
                farthest = resting;
            }
        }
        if (farthest != null) {
            farthest.leaves = true;
            bytes -= farthest.bytes;
        }
        return farthest;
    }

    /** Nobody waits for the disk but who put the frame here. Returns whether the disk took it. */
    private boolean toDisk(Resting resting) {
        FrameFolder.Part rows = folder == null || resting.rows != null ? resting.rows : folder.writeRows(resting.cache);
        FrameFolder.Part colors = rows == null ? null : folder.writeColors(resting.cache);
        synchronized (this) {
            resting.rows = rows;
            resting.colors = colors;
            if (firm && colors == null && frames.get(resting.frame) == resting) {
                resting.leaves = false;
                bytes += resting.bytes;
                return false;
            }
            resting.cache = null;
            if (frames.get(resting.frame) != resting) {
                drop(resting);
            } else if (colors == null) {
                frames.remove(resting.frame);
                drop(resting);
            }
            return colors != null;
        }
    }

    /** Whether its files are being written: whoever does that looks after them. */
    private static boolean isUnderWay(Resting resting) {
        return resting.leaves && resting.cache != null;
    }

    /** Removes the files. */
    private void drop(Resting resting) {
        if (folder != null && !isUnderWay(resting)) {
            folder.remove(resting.rows);
            folder.remove(resting.colors);
        }
    }

    synchronized void remove(int frame) {
        Resting gone = frames.remove(frame);
        if (gone != null) {
            bytes -= gone.cache != null && !gone.leaves ? gone.bytes : 0;
            drop(gone);
        }
    }

    synchronized void focus(int frame) {
        focus = frame;
    }

    synchronized KeptBytes bytes() {
        KeptBytes sum = KeptBytes.NONE;
        for (Resting resting : frames.values()) {
            sum = sum.plus(resting.cache != null ? new KeptBytes(1, resting.bytes, 0, 0)
                    : new KeptBytes(0, 0, 1, resting.rows.bytes() + resting.colors.bytes()));
        }
        return sum;
    }

    /** What went wrong on disk first; null for nothing. */
    String problem() {
        return folder == null ? null : folder.problem();
    }

    @Override
    public synchronized void close() {
        frames.clear();
        bytes = 0;
        if (folder != null) {
            folder.close();
        }
    }
}
