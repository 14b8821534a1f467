package lightning.render.engine;

/** Checks that a measured kernel agrees with the scalar code. */
public final class KernelAgreement {
    private KernelAgreement() {}

    /** @throws IllegalStateException if a kernel's result for ray or row {@code index} differs from the scalar code */
    public static void requireEqual(boolean same, String description, int index) {
        if (!same) {
            throw new IllegalStateException(description + " " + index + ": the kernel disagrees with the scalar code");
        }
    }

    /** Requires equal bits. */
    public static void requireEqual(float kernel, float reference, String description, int index) {
        requireEqual(Float.floatToRawIntBits(kernel) == Float.floatToRawIntBits(reference), description, index);
    }
}
