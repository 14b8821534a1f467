package lightning.cli;

import java.nio.file.Path;
import java.util.Locale;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import lightning.cli.option.PictureOptions;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.report.ConversionReport;
import lightning.format.pov.PovScene;
import lightning.scene.Scene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Exports a scene to POV-Ray. */
@Command(name = "export", header = "Export a scene to POV-Ray 3.7.", abbreviateSynopsis = true,
        description = "Writes camera, objects, materials, textures and the environment (as image files next to the output) and lights, to "
                + "compare images and times. Features that POV-Ray does not support exactly are listed, also as comments in the file's "
                + "header.",
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
    @Option(names = {"-o", "--output"}, paramLabel = "x.pov", required = true, description = "Output file.")
    private Path output;

    ExportCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String name = output.getFileName() == null ? "" : output.getFileName().toString();
        if (!name.toLowerCase(Locale.ROOT).endsWith(".pov")) {
            throw new BadInputException(output + ": the output name must end in .pov");
        }
        PictureOutput.checkFile(output);
        Scene scene = picture.apply(input.read(console).scene());
        input.inputs(scene).check(output);
        PovScene pov = PovScene.of(scene, name.substring(0, name.length() - ".pov".length()));
        pov.write(output);
        pov.losses().forEach(loss -> console.warn("%s", loss));
        console.print("%s: written; %s", output, pov.losses().isEmpty() ? "exported exactly"
                : Console.text("not exported exactly: %d (see the notes)", pov.losses().size()));
        console.report().setResult(new ConversionReport(output.toString(), scene.stage().shapeCount(), scene.materials().size(),
                scene.lights().size(), null, null,
                pov.losses().stream().collect(Collectors.toMap(loss -> loss, _ -> 1, Integer::sum, TreeMap::new))));
        return ExitCode.OK;
    }
}
