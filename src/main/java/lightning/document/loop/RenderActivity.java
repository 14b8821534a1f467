package lightning.document.loop;

/**
 * Work on an image since its current stage started.
 *
 * @param stage       stage of the image
 * @param rays        rays that were cast
 * @param nanoseconds time that passed, including time without rays
 * @param rayNanoseconds time in which the rays were cast
 */
public record RenderActivity(Stage stage, long rays, long nanoseconds, long rayNanoseconds) {
    public static final RenderActivity NONE = new RenderActivity(Stage.CENTERS, 0, 0, 0);

    /** Stage of an image. */
    public enum Stage {
        /** Coarse images, then one sample in each pixel. */
        CENTERS,
        /** Indirect light, added to a picture that shows direct light. */
        INDIRECT,
        /** Finer samples for anti-aliasing. */
        SAMPLES
    }

    /** Returns the rays per second; 0 if unknown. */
    public double raysPerSecond() {
        return rayNanoseconds == 0 ? 0 : rays * 1e9 / rayNanoseconds;
    }
}
