package lightning.scene.asset;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.text.RefusalException;
import lightning.scene.value.SceneLimits;

/**
 * Texture with its repetition and placement over a shape's texture coordinates.
 *
 * @param file    name as written in the scene file
 * @param repeatU repetitions around the shape, not 0 (negative mirrors it)
 * @param repeatV repetitions along the shape, not 0
 * @param image   the decoded image
 * @param wrap    continuation of the image beyond its edges
 * @param placement rotation and offset of the repeated image
 */
@RecordBuilder
public record TextureMap(String file, double repeatU, double repeatV, Texture image, TextureWrap wrap, TexturePlacement placement)
        implements TextureMapBuilder.With {
    public TextureMap {
        // The only placement without effect, so that a look-up compares references.
        placement = placement.isNone() ? TexturePlacement.NONE : placement;
        checkRepeat(repeatU, repeatV);
    }

    /** Creates a map whose image repeats endlessly. */
    public TextureMap(String file, double repeatU, double repeatV, Texture image) {
        this(file, repeatU, repeatV, image, TextureWrap.REPEAT);
    }

    /** Creates a map whose image is neither rotated nor moved. */
    public TextureMap(String file, double repeatU, double repeatV, Texture image, TextureWrap wrap) {
        this(file, repeatU, repeatV, image, wrap, TexturePlacement.NONE);
    }

    /** Returns whether both look the same on every surface; the file name does not matter. */
    public boolean hasSameTexels(TextureMap o) {
        return repeatU == o.repeatU && repeatV == o.repeatV && wrap.equals(o.wrap) && placement.equals(o.placement)
                && image.equals(o.image);
    }

    /** @throws IllegalArgumentException if a map may not have these repetitions */
    public static void checkRepeat(double u, double v) {
        checkRepeat("repeat u", u);
        checkRepeat("repeat v", v);
    }

    private static void checkRepeat(String name, double value) {
        SceneLimits.checkRange(name, value, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
        if (Math.abs(value) < 1e-6) {
            throw new RefusalException(name + " must be at least 1e-6 in absolute value, was " + SceneLimits.format(value));
        }
    }
}
