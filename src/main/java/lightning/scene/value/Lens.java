package lightning.scene.value;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.text.RefusalException;

/**
 * Thin lens of a camera: points off the plane of focus are blurred.
 *
 * @param aperture      radius of the opening, scene units; 0 for a pinhole, through which everything is sharp
 * @param focus         distance of the plane of focus along the view direction, scene units; 0 for the plane through the camera's target
 * @param blades        blades of the diaphragm, 3…16, which give the opening as many corners; 0 for a round opening
 * @param bladeRotation counterclockwise rotation of the opening as the photographer sees it, degrees; at 0 a corner is on top
 */
@RecordBuilder
public record Lens(double aperture, double focus, int blades, double bladeRotation) implements LensBuilder.With {
    /** Pinhole. */
    public static final Lens PINHOLE = new Lens(0, 0, 0, 0);
    public static final int MIN_BLADES = 3;
    public static final int MAX_BLADES = 16;

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public Lens {
        SceneLimits.checkRange("aperture", aperture, 0, SceneLimits.MAX_EXTENT);
        SceneLimits.checkRange("focus", focus, 0, SceneLimits.MAX_COORDINATE);
        checkBlades("blades", blades);
        SceneLimits.checkRange("blade_rotation", bladeRotation, -SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION);
    }

    /** @throws IllegalArgumentException if no lens has as many blades */
    public static void checkBlades(String name, int blades) {
        if (blades != 0 && (blades < MIN_BLADES || blades > MAX_BLADES)) {
            throw new RefusalException(
                    name + " must be 0 or from " + MIN_BLADES + " to " + MAX_BLADES + ", was " + blades);
        }
    }

    /** Returns whether anything may be blurred. */
    public boolean isOpen() {
        return aperture > 0;
    }

    /** Returns whether both lenses let the same rays through. */
    public boolean hasSameRays(Lens o) {
        return equals(o) || !isOpen() && !o.isOpen();
    }
}
