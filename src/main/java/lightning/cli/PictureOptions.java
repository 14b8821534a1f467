package lightning.cli;

import lightning.scene.Limits;
import lightning.scene.Picture;
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

    /** The scene with the picture asked for. */
    Scene apply(Scene scene) {
        Picture picture = scene.picture();
        if (size != null) {
            picture = picture.withSize(size.width(), size.height());
        }
        return scene.withPicture(depth == null ? picture : picture.withDepth(depth));
    }
}
