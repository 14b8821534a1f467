package lightning.format.exr;

/** Order of bytes that compresses well: even bytes before odd ones, each as its difference from the one before. */
final class BytePrediction {
    /** Difference that stands for equal bytes. */
    private static final int NO_DIFFERENCE = 128;

    private BytePrediction() {}

    static byte[] encode(byte[] raw) {
        byte[] predicted = new byte[raw.length];
        int half = (raw.length + 1) / 2;
        for (int i = 0; i < raw.length; i++) {
            predicted[(i & 1) * half + i / 2] = raw[i];
        }
        for (int i = raw.length - 1; i > 0; i--) {
            predicted[i] = (byte) (predicted[i] - predicted[i - 1] + NO_DIFFERENCE);
        }
        return predicted;
    }

    /**
     * Inverse of {@link #encode}.
     *
     * @param predicted overwritten
     */
    static byte[] decode(byte[] predicted) {
        for (int i = 1; i < predicted.length; i++) {
            predicted[i] = (byte) (predicted[i - 1] + predicted[i] - NO_DIFFERENCE);
        }
        byte[] raw = new byte[predicted.length];
        int half = (raw.length + 1) / 2;
        for (int i = 0; i < raw.length; i++) {
            raw[i] = predicted[(i & 1) * half + i / 2];
        }
        return raw;
    }
}
