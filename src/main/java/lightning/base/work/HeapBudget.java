package lightning.base.work;

/** Memory available for rendering. */
public final class HeapBudget {
    /** Fraction of the heap for images; an edit's new columns and the garbage collector need the rest. */
    private static final double HEAP_FRACTION = 0.8;

    private HeapBudget() {}

    /** Returns the bytes that images may use in this JVM. */
    public static long availableBytes() {
        return (long) (HEAP_FRACTION * Runtime.getRuntime().maxMemory());
    }
}
