package lightning.render.measure;

import java.util.Set;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.paper.Accuracy;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/** Accuracy settings, each a method to show an edit, from the roughest to the full trace. */
public enum AccuracySetting {
    HALF_RESOLUTION("half resolution", "exact re-render with reflections at half the width and height, each pixel enlarged to "
            + "its nearest ones"),
    FAST_SHADING("fast shading", "re-render without shadows and reflections, like previews of other editors (paper §1.1, §2.3)"),
    FEW_SAMPLES("few samples", "exact re-render with reflections and 4 samples per area light; only "
            + "for scenes with area lights"),
    NO_ANTIALIASING("no anti-aliasing",
            "exact re-render with reflections and one sample per pixel; only for scenes with "
                    + "anti-aliasing"),
    RATIO("ratio", "the paper's update of stored contributions; reflections are not updated"),
    EXACT("exact", "bit-identical to a full trace with the old reflections"),
    EXACT_UPDATED("exact, mirrors updated", "exact update, then Update Reflections: sum of both times (paper §4.8)"),
    EXACT_CURRENT("exact, mirrors current", "bit-identical to a full trace with current reflections, in one step"),
    FULL_TRACE("full trace", "traditional trace without a cache: the reference");

    /** Default setting of the program, used for headline results. */
    public static final AccuracySetting DEFAULT = EXACT_CURRENT;

    /** Number of light samples of the setting with few samples. */
    private static final int REDUCED_LIGHT_SAMPLES = SceneLimits.MIN_LIGHT_SAMPLES;

    private final String label;
    private final String description;

    AccuracySetting(String label, String note) {
        this.label = label;
        this.description = note;
    }

    /** Returns whether the setting differs from its neighbors for edits of a scene. */
    boolean appliesTo(Scene scene) {
        return switch (this) {
            case FEW_SAMPLES -> scene.lights().stream().anyMatch(Light::isArea);
            case NO_ANTIALIASING -> scene.picture().sampling().isSupersampled();
            case HALF_RESOLUTION, FAST_SHADING, RATIO, EXACT, EXACT_UPDATED, EXACT_CURRENT, FULL_TRACE -> true;
        };
    }

    /** Returns the scene that the setting renders for a requested one. */
    Scene sceneFor(Scene scene) {
        PictureSettings p = scene.picture();
        return switch (this) {
            case HALF_RESOLUTION -> scene.withPicture(p.withSize((p.width() + 1) / 2, (p.height() + 1) / 2));
            case FEW_SAMPLES ->
                    scene.withLights(scene.lights().stream().map(l -> l.withArea(l.area().withSamples(REDUCED_LIGHT_SAMPLES))).toList());
            case NO_ANTIALIASING -> scene.withPicture(p.withSampling(new SamplingSettings(AntialiasMode.OFF, p.sampling().grid())));
            case FAST_SHADING, RATIO, EXACT, EXACT_UPDATED, EXACT_CURRENT, FULL_TRACE -> scene;
        };
    }

    /** Returns the render options of the setting. */
    RenderOptions options() {
        RenderOptions exact = RenderOptions.DEFAULT.withEngines(Engines.FASTEST);
        return switch (this) {
            case HALF_RESOLUTION, FEW_SAMPLES, NO_ANTIALIASING, EXACT_CURRENT -> exact;
            case FAST_SHADING -> exact.withReflectionsOnRequest()
                    .withView(ViewEffects.ALL.withHidden(Set.of(RenderEffect.SHADOWS, RenderEffect.REFLECTION)));
            case RATIO -> exact.withReflectionsOnRequest().withAccuracy(Accuracy.RATIO);
            case EXACT, EXACT_UPDATED -> exact.withReflectionsOnRequest();
            case FULL_TRACE -> throw new IllegalArgumentException("expected a setting of a re-render, found the full trace");
        };
    }

    /** Returns whether its edits start from the cache of setting exact. */
    boolean startsFromExact() {
        return this == EXACT_UPDATED || this == EXACT_CURRENT;
    }

    /** Returns a short label for tables. */
    public String label() {
        return label;
    }

    /** Returns a description, one line. */
    public String description() {
        return description;
    }
}
