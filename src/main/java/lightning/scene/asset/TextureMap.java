package lightning.scene.asset;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.value.SceneLimits;

/**
 * Texture with its repetition over a shape's texture coordinates.
 *
 * @param file    name as written in the scene file
 * @param repeatU repetitions around the shape, not 0 (negative mirrors it)
 * @param repeatV repetitions along the shape, not 0
 * @param image   the decoded image
 * @param wrap    continuation of the image beyond its edges
 */
@RecordBuilder
public record TextureMap(String file, double repeatU, double repeatV, Texture image, TextureWrap wrap) implements TextureMapBuilder.With {
    public TextureMap {
        checkRepeat("repeat u", repeatU);
        checkRepeat("repeat v", repeatV);
    }

    /** Creates a map whose image repeats endlessly. */
    public TextureMap(String file, double repeatU, double repeatV, Texture image) {
        this(file, repeatU, repeatV, image, TextureWrap.REPEAT);
    }

    /** Returns whether both look the same on every surface; the file name does not matter. */
    public boolean hasSameTexels(TextureMap o) {
        return repeatU == o.repeatU && repeatV == o.repeatV && wrap.equals(o.wrap) && image.equals(o.image);
    }

    private static void checkRepeat(String name, double value) {
        SceneLimits.checkRange(name, value, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
        if (Math.abs(value) < 1e-6) {
            throw new IllegalArgumentException(name + " must be at least 1e-6 in absolute value, was " + SceneLimits.format(value));
        }
    }
}
