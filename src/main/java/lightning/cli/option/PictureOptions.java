package lightning.cli.option;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options that override the scene's image settings. */
public final class PictureOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--size", paramLabel = "WxH", converter = PictureDimensions.Converter.class,
            description = "Image size in pixels (default: the scene's).")
    private @Nullable PictureDimensions size;

    @Option(names = "--camera", paramLabel = "NAME",
            description = "Named camera of the scene, or of a glTF or USD file (default: the scene's camera).")
    private @Nullable String camera;

    private @Nullable Integer depth;

    @Option(names = "--depth", paramLabel = "N",
            description = "Maximum reflection depth, 0 to " + SceneLimits.MAX_DEPTH + " (default: the scene's).")
    private void setDepth(int value) {
        depth = OptionRange.check(command, "--depth", value, 0, SceneLimits.MAX_DEPTH);
    }

    @Option(names = "--antialias", paramLabel = "MODE",
            description = "Anti-aliasing: off, edges or every (default: the scene's).")
    private @Nullable AntialiasMode antialias;

    private @Nullable Integer samples;

    @Option(names = "--samples", paramLabel = "N",
            description = "Anti-aliasing samples per pixel side, " + SceneLimits.MIN_SAMPLES + " to " + SceneLimits.MAX_SAMPLES
                    + " (default: the scene's).")
    private void setSamples(int value) {
        samples = OptionRange.check(command, "--samples", value, SceneLimits.MIN_SAMPLES, SceneLimits.MAX_SAMPLES);
    }

    /** Choice of indirect light. */
    enum Indirect {
        ON, OFF
    }

    @Option(names = "--indirect", paramLabel = "on|off", description = "Indirect light: on or off (default: the scene's).")
    private @Nullable Indirect indirect;

    @Option(names = "--no-indirect", description = "Same as --indirect=off.")
    private void setNoIndirect(boolean off) {
        if (off) {
            indirect = Indirect.OFF;
        }
    }

    private List<RenderEffect> leftOut = List.of();

    @Option(names = "--without", paramLabel = "EFFECT", split = ",",
            description = "Effects of the scene to leave out, such as blurred-reflections. An unknown name prints all names.")
    private void setLeftOut(List<String> effects) {
        leftOut = effects.stream().map(this::removable).toList();
    }

    private RenderEffect removable(String id) {
        return RenderEffect.REMOVABLE.stream().filter(effect -> effect.id().equals(id)).findFirst()
                .orElseThrow(() -> new ParameterException(command.commandLine(), "--without must name effects from "
                        + RenderEffect.REMOVABLE.stream().map(RenderEffect::id).collect(Collectors.joining(", ")) + ", was " + id));
    }

    /** Returns whether the size was chosen. */
    public boolean hasSize() {
        return size != null;
    }

    /** Returns the scene with these options applied. */
    public Scene apply(Scene scene) {
        PictureSettings picture = scene.picture();
        if (size != null) {
            picture = picture.withSize(size.width(), size.height());
        }
        if (indirect == Indirect.OFF) {
            picture = picture.withIndirect(Optional.empty());
        } else if (indirect == Indirect.ON && picture.indirect().isEmpty()) {
            picture = picture.withIndirect(Optional.of(IndirectSettings.INITIAL));
        }
        SamplingSettings sceneSampling = picture.sampling();
        SamplingSettings sampling = new SamplingSettings(antialias == null ? sceneSampling.antialias() : antialias,
                samples == null ? sceneSampling.grid() : samples);
        Scene result = scene.withPicture((depth == null ? picture : picture.withDepth(depth)).withSampling(sampling));
        return ViewEffects.ALL.withHidden(leftOut).apply(camera == null ? result : result.withCamera(camera(scene, camera)));
    }

    private Camera camera(Scene scene, String name) {
        List<String> names = scene.cameraNames();
        return scene.namedCamera(name).orElseThrow(() -> new ParameterException(command.commandLine(), "--camera: the scene has no camera "
                + Quote.of(name) + ", it has " + (names.isEmpty() ? "no named ones" : Quote.list(names))));
    }
}
