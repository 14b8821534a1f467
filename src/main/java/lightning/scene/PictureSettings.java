package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import java.util.Optional;
import lightning.base.text.RefusalException;
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
 * @param reflectionRays rays by which a point collects blurred reflections: one of {@link #REFLECTION_RAY_COUNTS}
 */
@RecordBuilder
public record PictureSettings(int width, int height, int depth, SamplingSettings sampling, Optional<IndirectSettings> indirect,
        ViewSettings view, int reflectionRays) implements PictureSettingsBuilder.With {
    public static final SceneAttribute<PictureSettings, Integer> DEPTH = new SceneAttribute<>("depth", "depth", "reflection bounces",
            NumericKind.integer(0, SceneLimits.MAX_DEPTH), 3, "reflection bounces", PictureSettings::depth, PictureSettings::withDepth);

    /** Allowed numbers of rays of blurred reflections, ascending. All are squares of even numbers. */
    public static final List<Integer> REFLECTION_RAY_COUNTS = List.of(4, 16, 64, 256);
    public static final SceneAttribute<PictureSettings, Integer> REFLECTION_RAYS =
            new SceneAttribute<>("reflection_rays", "reflection rays",
                    NumericKind.integer(REFLECTION_RAY_COUNTS.getFirst(), REFLECTION_RAY_COUNTS.getLast())
                            .withCheck(PictureSettings::checkReflectionRays),
                    16, "4, 16, 64 or 256 for each point with blurred reflections", PictureSettings::reflectionRays,
                    PictureSettings::withReflectionRays);

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
        this(width, height, depth, sampling, indirect, ViewSettings.DEFAULT, REFLECTION_RAYS.initial());
    }

    public PictureSettings {
        SceneLimits.checkRange("size: width", width, 1, SceneLimits.MAX_SIZE);
        SceneLimits.checkRange("size: height", height, 1, SceneLimits.MAX_SIZE);
        DEPTH.check(depth);
        checkReflectionRays("reflection_rays", reflectionRays);
    }

    private static void checkReflectionRays(String name, int rays) {
        if (!REFLECTION_RAY_COUNTS.contains(rays)) {
            throw new RefusalException(name + " must be 4, 16, 64 or 256, was " + rays);
        }
    }

    public PictureSettings withSize(int newWidth, int newHeight) {
        return with(p -> p.width(newWidth).height(newHeight));
    }

    /** Returns whether both give the same linear image: they differ in the view at most. */
    public boolean hasSameImage(PictureSettings o) {
        return equals(o.withView(view));
    }
}
