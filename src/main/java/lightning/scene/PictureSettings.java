package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.SceneLimits;

/**
 * Image settings of a scene.
 *
 * @param width    pixels
 * @param height   pixels
 * @param depth    maximum reflection bounces, 0 to 10
 * @param sampling samples per pixel
 * @param indirect diffuse indirect light; empty for none
 * @param view     view transform, which does not affect the linear image
 */
@RecordBuilder
public record PictureSettings(int width, int height, int depth, SamplingSettings sampling, Optional<IndirectSettings> indirect,
        ViewSettings view) implements PictureSettingsBuilder.With {
    public static final SceneAttribute<PictureSettings, Integer> DEPTH = new SceneAttribute<>("depth", "depth", "reflection bounces",
            NumericKind.integer(0, SceneLimits.MAX_DEPTH), 3, "reflection bounces", PictureSettings::depth, PictureSettings::withDepth);

    public static final PictureSettings DEFAULT = new PictureSettings(200, 200, DEPTH.initial());

    /** Creates settings with one sample per pixel. */
    public PictureSettings(int width, int height, int depth) {
        this(width, height, depth, SamplingSettings.DEFAULT);
    }

    /** Creates settings without indirect light. */
    public PictureSettings(int width, int height, int depth, SamplingSettings sampling) {
        this(width, height, depth, sampling, Optional.empty());
    }

    /** Creates settings with the default view. */
    public PictureSettings(int width, int height, int depth, SamplingSettings sampling, Optional<IndirectSettings> indirect) {
        this(width, height, depth, sampling, indirect, ViewSettings.DEFAULT);
    }

    public PictureSettings {
        SceneLimits.checkRange("size: width", width, 1, SceneLimits.MAX_SIZE);
        SceneLimits.checkRange("size: height", height, 1, SceneLimits.MAX_SIZE);
        DEPTH.check(depth);
    }

    public PictureSettings withSize(int newWidth, int newHeight) {
        return new PictureSettings(newWidth, newHeight, depth, sampling, indirect, view);
    }

    /** Returns whether both give the same linear image: they differ in the view at most. */
    public boolean hasSameImage(PictureSettings o) {
        return equals(o.withView(view));
    }
}
