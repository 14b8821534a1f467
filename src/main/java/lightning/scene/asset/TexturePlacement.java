package lightning.scene.asset;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.value.SceneLimits;

/**
 * Rotation and offset of an image on a surface, after its repetition: coordinates (u, v) of the surface show the image at
 * {@code rotation(repeatU · u, repeatV · v) + (offsetU, offsetV)}, as in glTF, USD and Blender. So a positive offset moves the image to the
 * left and down, and a positive rotation turns it clockwise.
 *
 * @param offsetU  in images, to the right
 * @param offsetV  in images, up
 * @param rotation degrees, from u to v
 */
@RecordBuilder
public record TexturePlacement(double offsetU, double offsetV, double rotation) implements TexturePlacementBuilder.With {
    /** Neither rotation nor offset. */
    public static final TexturePlacement NONE = new TexturePlacement(0, 0, 0);
    /** Largest rotation in degrees, in both directions. */
    public static final double MAX_ROTATION = 360;

    public TexturePlacement {
        SceneLimits.checkRange("offset u", offsetU, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
        SceneLimits.checkRange("offset v", offsetV, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
        SceneLimits.checkRange("rotation", rotation, -MAX_ROTATION, MAX_ROTATION);
    }

    /** Returns whether the image is neither rotated nor moved. */
    public boolean isNone() {
        return offsetU == 0 && offsetV == 0 && rotation == 0;
    }

    /** Returns the cosine of the rotation, the same on every machine. */
    public double cosine() {
        return StrictMath.cos(Math.toRadians(rotation));
    }

    /** Returns the sine of the rotation, the same on every machine. */
    public double sine() {
        return StrictMath.sin(Math.toRadians(rotation));
    }
}
