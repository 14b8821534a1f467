package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.SceneLimits;

/**
 * Diffuse indirect light of an image: light that surfaces pass on to other surfaces.
 *
 * @param bounces    diffuse bounces between a light and the surface that is seen, 1 to 8
 * @param rays       rays by which a gather point collects light: 16, 64, 256 or 1024
 * @param spacing    distance of gather points on open surfaces, pixels, 2 to 64; in pictures larger than {@link #FULL_HD}, pixels of a
 *                   picture of that size, so that they do not become finer than anyone sees
 * @param background true if the background lights the scene where a ray leaves it
 */
@RecordBuilder
public record IndirectSettings(int bounces, int rays, int spacing, boolean background) implements IndirectSettingsBuilder.With {
    /** Shorter side of a picture, pixels, up to which {@link #spacing} counts its pixels. */
    public static final int FULL_HD = 1080;
    public static final int MAX_BOUNCES = 8;
    public static final int MIN_SPACING = 2;
    public static final int MAX_SPACING = 64;
    /** Allowed numbers of rays, ascending. All are squares. */
    public static final List<Integer> RAY_COUNTS = List.of(16, 64, 256, 1024);
    /** Settings of a file that has indirect light but no values. */
    public static final IndirectSettings DEFAULT = new IndirectSettings(2, 64, 8, false);
    /** Settings of indirect light that is switched on, or imported: as many bounces as Cycles has by default. */
    public static final IndirectSettings INITIAL = new IndirectSettings(4, 64, 8, false);

    public static final SceneAttribute<IndirectSettings, Integer> BOUNCES = new SceneAttribute<>("bounces", "indirect bounces",
            NumericKind.integer(1, MAX_BOUNCES), DEFAULT.bounces, "diffuse bounces", IndirectSettings::bounces,
            IndirectSettings::withBounces);
    public static final SceneAttribute<IndirectSettings, Integer> RAYS = new SceneAttribute<>("rays", "indirect rays",
            NumericKind.integer(RAY_COUNTS.getFirst(), RAY_COUNTS.getLast()).withCheck(IndirectSettings::checkRays), DEFAULT.rays,
            "16, 64, 256 or 1024 for each gather point", IndirectSettings::rays, IndirectSettings::withRays);
    public static final SceneAttribute<IndirectSettings, Integer> SPACING = new SceneAttribute<>("spacing", "indirect spacing",
            NumericKind.integer(MIN_SPACING, MAX_SPACING), DEFAULT.spacing, "pixels between gather points", IndirectSettings::spacing,
            IndirectSettings::withSpacing);
    public static final SceneAttribute<IndirectSettings, Boolean> BACKGROUND = new SceneAttribute<>("background", "indirect background",
            ChoiceKind.ON_OR_OFF, DEFAULT.background, "", IndirectSettings::background, IndirectSettings::withBackground);

    public static final List<SceneAttribute<IndirectSettings, ?>> ATTRIBUTES = List.of(BOUNCES, RAYS, SPACING, BACKGROUND);

    public IndirectSettings {
        SceneLimits.checkRange("indirect: bounces", bounces, 1, MAX_BOUNCES);
        checkRays("indirect: rays", rays);
        SceneLimits.checkRange("indirect: spacing", spacing, MIN_SPACING, MAX_SPACING);
    }

    private static void checkRays(String name, int rays) {
        if (!RAY_COUNTS.contains(rays)) {
            throw new RefusalException(name + " must be 16, 64, 256 or 1024, was " + rays);
        }
    }

    /** Returns the pixels of a picture along one pixel of {@link #spacing}, at least 1. */
    public static double pixelScale(PictureSettings picture) {
        return Math.max(1, Math.min(picture.width(), picture.height()) / (double) FULL_HD);
    }

    /** Returns all settings in a line: {@code 2 bounces, 64 rays, every 8 pixels}. */
    public String label() {
        return Messages.count(bounces, "{0} bounce, {1} rays, every {2} pixels", "{0} bounces, {1} rays, every {2} pixels", bounces, rays,
                spacing) + (background ? Messages.tr(", background") : "");
    }
}
