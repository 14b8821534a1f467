package lightning.shot.cluster;

import lightning.shot.cluster.wire.Message;

/**
 * Size of the parts in which a link carries files and films. Grows and shrinks with the time that a part takes, so that a part arrives well
 * before its request is repeated, and other messages do not wait long for it.
 *
 * <p>Links from 32 kB/s need no repeated request: the first part takes them two seconds.
 */
final class PartSize {
    private static final int MIN_BYTES = 1 << 14;
    private static final int FIRST_BYTES = 1 << 16;
    private static final long FAST_NANOSECONDS = 250_000_000L;
    private static final long SLOW_NANOSECONDS = 1_000_000_000L;

    private int bytes = FIRST_BYTES;

    /** Returns the maximum bytes of the next part. */
    synchronized int bytes() {
        return bytes;
    }

    /**
     * Adapts the size to the time that a part took.
     *
     * @param part bytes of the part; a part below the maximum says nothing about a larger one
     */
    synchronized void adapt(int part, long nanoseconds) {
        if (nanoseconds > SLOW_NANOSECONDS) {
            shrink();
        } else if (nanoseconds < FAST_NANOSECONDS && part >= bytes) {
            bytes = Math.min(Message.PART_BYTES, 2 * bytes);
        }
    }

    /** Halves the size, after a part whose request was repeated. */
    synchronized void shrink() {
        bytes = Math.max(MIN_BYTES, bytes / 2);
    }
}
