package lightning.render.engine;

/** A kernel is timed only where it gives what the readable code gives. */
public final class Agreement {
    private Agreement() {}

    /** @throws IllegalStateException if a kernel's answer for ray or row {@code index} is not the readable code's */
    public static void require(boolean same, String what, int index) {
        if (!same) {
            throw new IllegalStateException(what + " " + index + ": the kernel disagrees with the readable code; it is not timed");
        }
    }

    /** Requires the same bits. */
    public static void require(float kernel, float readable, String what, int index) {
        require(Float.floatToRawIntBits(kernel) == Float.floatToRawIntBits(readable), what, index);
    }
}
