package lightning.scene;

import lightning.math.Rgb;

/**
 * What surrounds the shapes.
 *
 * @param ambience   the factor on every material's ambient colour, ≥ 0
 * @param background the linear colour where a ray hits nothing, ≥ 0
 */
public record World(double ambience, Rgb background) {
    public static final World DEFAULT = new World(1, Rgb.BLACK);

    public World {
        Limits.range("ambience", ambience, 0, Limits.MAX_AMBIENCE);
        Limits.range("background", background, Limits.MAX_EMISSION);
    }

    public World withAmbience(double newAmbience) {
        return new World(newAmbience, background);
    }
}
