package lightning.layer;

import lightning.base.text.RefusalException;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;

/**
 * Content of an OpenEXR file in addition to the image.
 *
 * @param type type of colors and normals, HALF or FLOAT; all other channels are FLOAT. A file of halves has no residual layer
 * @param layers layers, with surface data
 * @param grouped whether the lights of a light group share their layers
 * @param matteLevels ids that the mattes of a pixel have room for, even; 0 for no mattes
 * @param primaries color space of the image and its layers
 */
public record ExrContent(ExrType type, Layers layers, boolean grouped, int matteLevels, ExrPrimaries primaries) {
    /** Choice of layers. */
    public enum Layers {
        /** None. */
        NONE,
        /** Those of lights that are on. */
        LIT,
        /** Those of all lights, so that all frames of a shot have the same. */
        ALL
    }

    /** Levels of mattes that most programs use. */
    public static final int DEFAULT_MATTE_LEVELS = 6;
    /** Maximum number of levels, for 100 numbered layers of two. */
    public static final int MAX_MATTE_LEVELS = 64;

    public ExrContent {
        if (matteLevels < 0 || matteLevels > MAX_MATTE_LEVELS || matteLevels % 2 != 0) {
            throw new RefusalException("levels must be even and at most " + MAX_MATTE_LEVELS + ", was " + matteLevels);
        }
    }

    /** Creates content in Rec. 709. */
    public ExrContent(ExrType type, Layers layers, boolean grouped, int matteLevels) {
        this(type, layers, grouped, matteLevels, ExrPrimaries.REC_709);
    }

    /** Returns layers without mattes. */
    public static ExrContent layers(ExrType type) {
        return new ExrContent(type, Layers.LIT, false, 0);
    }

    /** Returns the image in halves, and mattes. */
    public static ExrContent mattes(int levels) {
        return mattes(levels, ExrPrimaries.REC_709);
    }

    /** Returns the image in halves of a color space, and mattes. */
    public static ExrContent mattes(int levels, ExrPrimaries primaries) {
        return new ExrContent(ExrType.HALF, Layers.NONE, false, levels, primaries);
    }
}
