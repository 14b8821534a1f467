package lightning.shot;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import lightning.base.text.Messages;
import lightning.render.cache.CacheMetadata;
import lightning.render.cache.CacheSerializer;
import lightning.render.cache.PixelCache;
import lightning.render.relight.MemoryEstimate;
import org.jspecify.annotations.Nullable;

/**
 * Two-level cache of frames. Frames nearest to the focus stay in memory, the others are moved to disk, and dropped if the disk is full.
 * Any thread may call, but only one at a time for each frame.
 */
final class FrameStore implements AutoCloseable {
    private final long memory;
    /** Null without a disk cache. */
    private final @Nullable FrameDiskCache diskCache;
    private final boolean pinned;
    private final Map<Integer, StoredFrame> frames = new TreeMap<>();
    private long bytes;
    private int focus;

    /** Cached frame that no job uses: in memory, on disk, or in both while it is moved. */
    private static final class StoredFrame {
        final int frame;
        final CacheMetadata outline;
        final long bytes;
        /** Null if it is on disk only. */
        @Nullable
        PixelCache cache;
        FrameDiskCache.@Nullable CacheFile rows;
        FrameDiskCache.@Nullable CacheFile colors;
        boolean evicting;

        StoredFrame(int frame, PixelCache cache) {
            this.frame = frame;
            this.cache = cache;
            outline = CacheMetadata.of(cache);
            bytes = MemoryEstimate.usedBytes(cache);
        }
    }

    /**
     * @param memory    bytes for frames in memory
     * @param diskCache closed with this
     * @param pinned    true to reject new frames instead of evicting cached ones
     */
    FrameStore(long memory, @Nullable FrameDiskCache diskCache, boolean pinned) {
        this.memory = memory;
        this.diskCache = diskCache;
        this.pinned = pinned;
    }

    /** Returns whether cached frames are never evicted. */
    boolean isPinned() {
        return pinned;
    }

    /** Returns the bytes still available. */
    synchronized long freeBytes() {
        long half = Long.MAX_VALUE / 2;
        return Math.min(half, memory - bytes) + (diskCache == null ? 0 : Math.min(half, diskCache.freeBytes()));
    }

    /** Returns the cache of a frame; null for none. */
    @Nullable
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
                rows = requireNonNull(stored.rows);
                colors = requireNonNull(stored.colors);
            }
            try {
                return requireNonNull(diskCache).read(stored.outline, rows, colors);
            } catch (IOException e) {
                if (dropUnreadable(stored, e)) {
                    return null;
                }
            }
        }
    }

    /** Drops an unreadable frame, unless it was stored again meanwhile. */
    private synchronized boolean dropUnreadable(StoredFrame stored, IOException e) {
        if (frames.get(stored.frame) != stored) {
            return false;
        }
        requireNonNull(diskCache).reportProblem(Messages.tr("cannot read a cached frame: {0}", e.getMessage()));
        remove(stored.frame);
        return true;
    }

    /**
     * Stores a frame in place of its old cache, if there is space.
     *
     * @param previous result of {@link #get}
     * @return false if a pinned frame would have to be evicted; the frame is then not cached
     */
    boolean put(int frame, PixelCache cache, @Nullable PixelCache previous) {
        StoredFrame stored = new StoredFrame(frame, cache);
        synchronized (this) {
            StoredFrame old = frames.put(frame, stored);
            bytes += stored.bytes;
            if (old != null) {
                bytes -= old.cache != null && !old.evicting ? old.bytes : 0;
                if (previous != null && old.rows != null && !isBeingWritten(old)
                        && CacheSerializer.hasSameRows(previous, cache)) {
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

    /** Returns the next frame to evict from memory, marked as leaving; null if all fit. */
    private synchronized @Nullable StoredFrame evictFarthest() {
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

    /** Writes a frame to disk, or drops it; only the thread that stored the frame waits for it. Returns whether it succeeded. */
    private boolean writeToDisk(StoredFrame stored) {
        PixelCache cache = requireNonNull(stored.cache);
        FrameDiskCache.CacheFile rows =
                diskCache == null || stored.rows != null ? stored.rows : diskCache.writeRows(cache);
        FrameDiskCache.CacheFile colors = diskCache == null || rows == null ? null : diskCache.writeColors(cache);
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

    /** Returns whether its files are being written; the writer then takes care of them. */
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
                    : new CacheUsage(0, 0, 1, requireNonNull(stored.rows).bytes() + requireNonNull(stored.colors).bytes()));
        }
        return sum;
    }

    /** Returns the first disk problem; null for none. */
    @Nullable
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
