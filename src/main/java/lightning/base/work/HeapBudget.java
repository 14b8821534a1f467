package lightning.base.work;

/** The memory that there is to work with. */
public final class HeapBudget {
    /** The part of the heap that pictures may take: an edit's new columns and the collector need the rest. */
    private static final double HEAP_FRACTION = 0.8;

    private HeapBudget() {}

    /** The bytes that pictures may take in this Java. */
    public static long availableBytes() {
        return (long) (HEAP_FRACTION * Runtime.getRuntime().maxMemory());
    }
}
