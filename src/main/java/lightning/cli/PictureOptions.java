package lightning.cli;

import lightning.scene.Antialias;
import lightning.scene.Limits;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options that ask for another picture than the scene's own. */
final class PictureOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--size", paramLabel = "WxH", converter = Size.Converter.class,
            description = "Pixels; the scene's own size without it.")
    private Size size;

    private Integer depth;

    @Option(names = "--depth", paramLabel = "N",
            description = "How many mirror bounces are followed, 0 to " + Limits.MAX_DEPTH + "; the scene's own depth without it.")
    private void setDepth(int value) {
        if (value < 0 || value > Limits.MAX_DEPTH) {
            throw new ParameterException(command.commandLine(), "--depth must be from 0 to " + Limits.MAX_DEPTH + ", was " + value);
        }
        depth = value;
    }

    @Option(names = "--antialias", paramLabel = "WHICH", description = {
        "Which pixels are the mean of several samples: ${COMPLETION-CANDIDATES};",
        "the scene's own choice without it."})
    private Antialias antialias;

    private Integer samples;

    @Option(names = "--samples", paramLabel = "N",
            description = "Samples along each side of such a pixel, " + Limits.MIN_SAMPLES + " to " + Limits.MAX_SAMPLES
                    + "; the scene's own number without it.")
    private void setSamples(int value) {
        if (value < Limits.MIN_SAMPLES || value > Limits.MAX_SAMPLES) {
            throw new ParameterException(command.commandLine(), "--samples must be from " + Limits.MIN_SAMPLES + " to "
                    + Limits.MAX_SAMPLES + ", was " + value);
        }
        samples = value;
    }

    /** The scene with the picture asked for. */
    Scene apply(Scene scene) {
        Picture picture = scene.picture();
        if (size != null) {
            picture = picture.withSize(size.width(), size.height());
        }
        Sampling own = picture.sampling();
        Sampling sampling = new Sampling(antialias == null ? own.antialias() : antialias, samples == null ? own.grid() : samples);
        return scene.withPicture((depth == null ? picture : picture.withDepth(depth)).withSampling(sampling));
    }
}
