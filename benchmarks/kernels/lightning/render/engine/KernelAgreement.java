package lightning.render.engine;

/** A kernel is timed only where it gives what the readable code gives. */
public final class KernelAgreement {
    private KernelAgreement() {}

    /** @throws IllegalStateException if a kernel's answer for ray or row {@code index} is not the readable code's */
    public static void requireEqual(boolean same, String description, int index) {
        if (!same) {
            throw new IllegalStateException(description + " " + index + ": the kernel disagrees with the readable code; it is not timed");
        }
    }

    /** Requires the same bits. */
    public static void requireEqual(float kernel, float reference, String description, int index) {
        requireEqual(Float.floatToRawIntBits(kernel) == Float.floatToRawIntBits(reference), description, index);
    }
}
