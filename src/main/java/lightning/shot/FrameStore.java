package lightning.shot;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import lightning.base.text.Messages;
import lightning.render.cache.CacheMetadata;
import lightning.render.cache.CacheSerializer;
import lightning.render.cache.PixelCache;
import lightning.render.relight.MemoryEstimate;

/**
 * The caches of frames: in memory as far as they have room there, those nearest to the focus; the others on disk; and where that has no
 * room either, nowhere. Any thread may call, of one frame one at a time.
 */
final class FrameStore implements AutoCloseable {
    private final long memory;
    /** Null where nothing is kept on disk. */
    private final FrameDiskCache diskCache;
    private final boolean pinned;
    private final Map<Integer, StoredFrame> frames = new TreeMap<>();
    private long bytes;
    private int focus;

    /** A frame that nobody works on: in memory, on disk, or in both while it goes from one to the other. */
    private static final class StoredFrame {
        final int frame;
        final CacheMetadata outline;
        final long bytes;
        /** Null where it is on disk alone. */
        PixelCache cache;
        FrameDiskCache.CacheFile rows;
        FrameDiskCache.CacheFile colors;
        boolean evicting;

        StoredFrame(int frame, PixelCache cache) {
            this.frame = frame;
            this.cache = cache;
            outline = CacheMetadata.of(cache);
            bytes = MemoryEstimate.usedBytes(cache);
        }
    }

    /**
     * @param memory bytes that frames may take in memory
     * @param diskCache closed with this; null for none
     * @param pinned   whether what is kept stays: a frame that comes finds no room, in place of those that go
     */
    FrameStore(long memory, FrameDiskCache diskCache, boolean pinned) {
        this.memory = memory;
        this.diskCache = diskCache;
        this.pinned = pinned;
    }

    /** Whether what is kept stays. */
    boolean isPinned() {
        return pinned;
    }

    /** Bytes that frames may still take. */
    synchronized long freeBytes() {
        long half = Long.MAX_VALUE / 2;
        return Math.min(half, memory - bytes) + (diskCache == null ? 0 : Math.min(half, diskCache.freeBytes()));
    }

    /** What is kept of a frame; null for nothing. */
    PixelCache get(int frame) {
        while (true) {
            StoredFrame stored;
            FrameDiskCache.CacheFile rows;
            FrameDiskCache.CacheFile colors;
            synchronized (this) {
                stored = frames.get(frame);
                if (stored == null || stored.cache != null) {
                    return stored == null ? null : stored.cache;
                }
                rows = stored.rows;
                colors = stored.colors;
            }
            try {
                return diskCache.read(stored.outline, rows, colors);
            } catch (IOException e) {
                if (dropUnreadable(stored, e)) {
                    return null;
                }
            }
        }
    }

    /** What cannot be read is nothing any more, unless somebody put the frame there anew meanwhile. */
    private synchronized boolean dropUnreadable(StoredFrame stored, IOException e) {
        if (frames.get(stored.frame) != stored) {
            return false;
        }
        diskCache.reportProblem(Messages.tr("cannot read a cached frame: {0}", e.getMessage()));
        remove(stored.frame);
        return true;
    }

    /**
     * Keeps a frame in place of what was kept of it, if there is room.
     *
     * @param previous what {@link #get} gave of it; may be null
     * @return whether nothing had to go for it that should stay; else nothing is kept of the frame
     */
    boolean put(int frame, PixelCache cache, PixelCache previous) {
        StoredFrame stored = new StoredFrame(frame, cache);
        synchronized (this) {
            StoredFrame old = frames.put(frame, stored);
            bytes += stored.bytes;
            if (old != null) {
                bytes -= old.cache != null && !old.evicting ? old.bytes : 0;
                if (previous != null && old.rows != null && !isBeingWritten(old) && CacheSerializer.hasSameRows(previous, cache)) {
                    stored.rows = old.rows;
                    old.rows = null;
                }
                deleteFiles(old);
            }
        }
        for (StoredFrame evicted = evictFarthest(); evicted != null; evicted = evictFarthest()) {
            if (!writeToDisk(evicted) && pinned) {
                remove(frame);
                return false;
            }
        }
        return true;
    }

    /** The frame that must leave memory next, which is about to; null where all have room. */
    private synchronized StoredFrame evictFarthest() {
        if (bytes <= memory) {
            return null;
        }
        StoredFrame farthest = null;
        for (StoredFrame frame : frames.values()) {
            boolean inMemory = frame.cache != null && !frame.evicting;
            if (inMemory && (farthest == null || Math.abs(frame.frame - focus) >= Math.abs(farthest.frame - focus))) {
                farthest = frame;
            }
        }
        if (farthest != null) {
            farthest.evicting = true;
            bytes -= farthest.bytes;
        }
        return farthest;
    }

    /** Nobody waits for the disk but who put the frame here. Returns whether the disk took it. */
    private boolean writeToDisk(StoredFrame stored) {
        FrameDiskCache.CacheFile rows = diskCache == null || stored.rows != null ? stored.rows : diskCache.writeRows(stored.cache);
        FrameDiskCache.CacheFile colors = rows == null ? null : diskCache.writeColors(stored.cache);
        synchronized (this) {
            stored.rows = rows;
            stored.colors = colors;
            if (pinned && colors == null && frames.get(stored.frame) == stored) {
                stored.evicting = false;
                bytes += stored.bytes;
                return false;
            }
            stored.cache = null;
            if (frames.get(stored.frame) != stored) {
                deleteFiles(stored);
            } else if (colors == null) {
                frames.remove(stored.frame);
                deleteFiles(stored);
            }
            return colors != null;
        }
    }

    /** Whether its files are being written: whoever does that looks after them. */
    private static boolean isBeingWritten(StoredFrame stored) {
        return stored.evicting && stored.cache != null;
    }

    /** Removes the files. */
    private void deleteFiles(StoredFrame stored) {
        if (diskCache != null && !isBeingWritten(stored)) {
            diskCache.remove(stored.rows);
            diskCache.remove(stored.colors);
        }
    }

    synchronized void remove(int frame) {
        StoredFrame removed = frames.remove(frame);
        if (removed != null) {
            bytes -= removed.cache != null && !removed.evicting ? removed.bytes : 0;
            deleteFiles(removed);
        }
    }

    synchronized void focus(int frame) {
        focus = frame;
    }

    synchronized CacheUsage usage() {
        CacheUsage sum = CacheUsage.NONE;
        for (StoredFrame stored : frames.values()) {
            sum = sum.plus(stored.cache != null ? new CacheUsage(1, stored.bytes, 0, 0)
                    : new CacheUsage(0, 0, 1, stored.rows.bytes() + stored.colors.bytes()));
        }
        return sum;
    }

    /** What went wrong on disk first; null for nothing. */
    String problem() {
        return diskCache == null ? null : diskCache.problem();
    }

    @Override
    public synchronized void close() {
        frames.clear();
        bytes = 0;
        if (diskCache != null) {
            diskCache.close();
        }
    }
}
