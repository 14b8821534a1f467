package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.value.SceneLimits;

/**
 * View transform of a scene: how its linear image is shown. It does not affect the image itself.
 *
 * @param exposure stops, −64 to 64; one more doubles the brightness
 */
@RecordBuilder
public record ViewSettings(ViewCurve curve, double exposure) implements ViewSettingsBuilder.With {
    /** Largest absolute exposure, stops. */
    public static final double MAX_EXPOSURE = 64;
    public static final ViewSettings DEFAULT = new ViewSettings(ViewCurve.SRGB, 0);

    public ViewSettings {
        SceneLimits.checkRange("exposure", exposure, -MAX_EXPOSURE, MAX_EXPOSURE);
    }
}
