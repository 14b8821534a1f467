package lightning.cli;

import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.format.pov.PovScene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Writes a scene for POV-Ray. */
@Command(name = "export", header = "Write a scene for POV-Ray 3.7.", abbreviateSynopsis = true,
        description = {
            "Writes camera, shapes, materials, textures (as PNG files beside it) and lights in the language of POV-Ray 3.7,",
            "to compare pictures and times. What POV-Ray cannot say, or not exactly, is listed, and stands as comments in the",
            "file's head."},
        footer = {
            "Example:",
            "  lightning export scenes/bird.jen -o bird.pov",
            "  povray +Ibird.pov +W300 +H300 -A -D"})
final class ExportCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private PictureOptions picture;
    @Option(names = {"-o", "--output"}, paramLabel = "x.pov", required = true, description = "The file to write.")
    private Path output;

    ExportCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String name = output.getFileName() == null ? "" : output.getFileName().toString();
        if (!name.toLowerCase(Locale.ROOT).endsWith(".pov")) {
            throw new BadInputException(output + ": an exported scene's name must end in .pov");
        }
        PictureOutput.checkFile(output);
        PovScene pov = PovScene.of(picture.apply(input.read().scene()), name.substring(0, name.length() - ".pov".length()));
        pov.write(output);
        pov.losses().forEach(loss -> console.warn("%s", loss));
        console.print("%s: written; %s", output, pov.losses().isEmpty() ? "everything maps exactly"
                : Console.text("not exactly the same: %d (see the remarks)", pov.losses().size()));
        return ExitCode.OK;
    }
}
