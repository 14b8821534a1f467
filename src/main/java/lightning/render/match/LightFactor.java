package lightning.render.match;

/**
 * Factor of a light's intensity, or of the red, green and blue of its light.
 *
 * @param light name of the light, or {@code environment}
 * @param red   factor, ≥ 0; equal in all channels if the color stays
 */
public record LightFactor(String light, double red, double green, double blue) {
    /** Returns whether the light keeps its color. */
    public boolean isGray() {
        return red == green && green == blue;
    }
}
