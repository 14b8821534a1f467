package lightning.render.match;

import lightning.scene.Contribution;

/**
 * Factor of a light's intensity, or of the red, green and blue of its light.
 *
 * @param light the light or environment
 * @param red   factor, ≥ 0; equal in all channels if the color stays
 */
public record LightFactor(Contribution light, double red, double green, double blue) {
    /** Returns whether the light keeps its color. */
    public boolean isGray() {
        return red == green && green == blue;
    }
}
