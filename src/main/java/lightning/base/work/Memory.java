package lightning.base.work;

/** The memory that there is to work with. */
public final class Memory {
    /** The part of the heap that pictures may take: an edit's new columns and the collector need the rest. */
    private static final double SHARE = 0.8;

    private Memory() {}

    /** The bytes that pictures may take in this Java. */
    public static long available() {
        return (long) (SHARE * Runtime.getRuntime().maxMemory());
    }
}
