package lightning.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.SceneEffects;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Scene to measure.
 *
 * @param name    file name without extension; unique in a run
 * @param file    source file for cold-start processes; null if none, which skips them
 * @param options options by which {@code lightning render} leaves out what this scene lacks of its file's, except anti-aliasing
 */
public record NamedScene(String name, Scene scene, @Nullable Path file, List<String> options) {
    public NamedScene {
        options = List.copyOf(options);
    }

    /** Creates a scene as in its file. */
    public NamedScene(String name, Scene scene, @Nullable Path file) {
        this(name, scene, file, List.of());
    }

    /**
     * Returns the scene without indirect light and blurred reflections. All parts except that of indirect light measure it, because
     * POV-Ray's images have none, and results from before stay comparable.
     */
    NamedScene withoutGatheredLight() {
        NamedScene direct = scene.picture().indirect().isEmpty() ? this : with(scene.withoutIndirect(), "--no-indirect");
        return SceneEffects.of(scene).has(RenderEffect.BLURRED_REFLECTIONS)
                ? direct.with(ViewEffects.ALL.with(RenderEffect.BLURRED_REFLECTIONS, false).apply(direct.scene()), "--without",
                        RenderEffect.BLURRED_REFLECTIONS.id())
                : direct;
    }

    /** Returns the scene with one sample per pixel. */
    public NamedScene withoutAntialiasing() {
        return scene.picture().sampling().antialias() == AntialiasMode.OFF ? this : withSampling(SamplingSettings.DEFAULT);
    }

    /** Returns the scene with other anti-aliasing. */
    NamedScene withSampling(SamplingSettings sampling) {
        return with(scene.withPicture(scene.picture().withSampling(sampling)));
    }

    /** Returns the options by which {@code lightning render} shows this scene from its file. */
    public List<String> renderOptions() {
        SamplingSettings sampling = scene.picture().sampling();
        return Stream.concat(options.stream(), Stream.of("--antialias", sampling.antialias().word(), "--samples",
                Integer.toString(sampling.grid()))).toList();
    }

    private NamedScene with(Scene changed, String... added) {
        return new NamedScene(name, changed, file, Stream.concat(options.stream(), Stream.of(added)).toList());
    }

    /** Returns the scene with other indirect light, or without. */
    Scene withIndirect(Optional<IndirectSettings> settings) {
        return scene.withPicture(scene.picture().withIndirect(settings));
    }
}
