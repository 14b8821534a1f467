package lightning.cli;

import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options that ask for another picture than the scene's own. */
final class PictureOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--size", paramLabel = "WxH", converter = PictureDimensions.Converter.class,
            description = "Pixels; the scene's own size without it.")
    private PictureDimensions size;

    private Integer depth;

    @Option(names = "--depth", paramLabel = "N",
            description = "How many mirror bounces are followed, 0 to " + SceneLimits.MAX_DEPTH + "; the scene's own depth without it.")
    private void setDepth(int value) {
        if (value < 0 || value > SceneLimits.MAX_DEPTH) {
            throw new ParameterException(command.commandLine(), "--depth must be from 0 to " + SceneLimits.MAX_DEPTH + ", was " + value);
        }
        depth = value;
    }

    @Option(names = "--antialias", paramLabel = "WHICH", description = {
        "Which pixels are the mean of several samples: ${COMPLETION-CANDIDATES};",
        "the scene's own choice without it."})
    private AntialiasMode antialias;

    private Integer samples;

    @Option(names = "--samples", paramLabel = "N",
            description = "Samples along each side of such a pixel, " + SceneLimits.MIN_SAMPLES + " to " + SceneLimits.MAX_SAMPLES
                    + "; the scene's own number without it.")
    private void setSamples(int value) {
        if (value < SceneLimits.MIN_SAMPLES || value > SceneLimits.MAX_SAMPLES) {
            throw new ParameterException(command.commandLine(), "--samples must be from " + SceneLimits.MIN_SAMPLES + " to "
                    + SceneLimits.MAX_SAMPLES + ", was " + value);
        }
        samples = value;
    }

    /** The scene with the picture asked for. */
    Scene apply(Scene scene) {
        PictureSettings picture = scene.picture();
        if (size != null) {
            picture = picture.withSize(size.width(), size.height());
        }
        SamplingSettings sceneSampling = picture.sampling();
        SamplingSettings sampling = new SamplingSettings(antialias == null ? sceneSampling.antialias() : antialias,
                samples == null ? sceneSampling.grid() : samples);
        return scene.withPicture((depth == null ? picture : picture.withDepth(depth)).withSampling(sampling));
    }
}
