package lightning.render.gather.ray;

import lightning.scene.GatherSettings;

/** Memory of paths while they are built. Thread-safe. The number of surfels is known only then, because each bounce may find more. */
public final class PathMemory {
    private final GatherSettings settings;
    private final long available;
    private long used;

    /** @param available bytes that paths may use */
    public PathMemory(GatherSettings settings, long available) {
        this.settings = settings;
        this.available = available;
    }

    /**
     * Reserves memory for further elements.
     *
     * @param bytes bytes of each
     * @throws PathsTooLargeException if it does not fit
     */
    public synchronized void reserve(long count, long bytes) {
        used += count * bytes;
        if (used > available) {
            throw new PathsTooLargeException(settings, used, available);
        }
    }
}
