package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.base.work.Workers;
import lightning.format.exchange.Import;
import lightning.format.exchange.Importer;
import lightning.format.exchange.LightUnits;
import lightning.format.exchange.UnitPictures;
import lightning.format.jen.JenFile;
import lightning.format.picture.PictureFile;
import lightning.format.picture.PictureFormat;
import lightning.render.image.ViewTransform;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Makes a scene of a file of another program. */
@Command(name = "import", header = "Make a scene of a glTF, OBJ, PLY or NFF file.", abbreviateSynopsis = true,
        description = {
            "Writes a scene that shows the file's meshes, with its cameras, lights and materials where it has them. The file and its",
            "pictures are copied beside the scene where they do not lie there already. What is left out, or is not the same here,",
            "is listed and counted."},
        footer = {
            "Example:",
            "  lightning import house.glb -o house.jen --light-units candela"})
final class ImportCommand implements Callable<Integer> {
    /** Pixels of the longer side. */
    private static final int PICTURE_SIZE = 320;

    private final Console console;

    @Parameters(index = "0", paramLabel = "FILE", description = "A .glb, .gltf, .obj, .ply or .nff file.")
    private Path file;
    @Option(names = {"-o", "--output"}, paramLabel = "scene.jen", required = true, description = "The scene to write.")
    private Path output;
    @Option(names = "--light-units", paramLabel = "UNITS",
            description = "What the numbers of a glTF file's lights are: candela (and lux, as the format says), unitless (watts per steradian "
                    + "and per square metre) or watts, as its exporter was told. Default: candela.")
    private LightUnits units;
    @Option(names = "--light-pictures",
            description = "Also write a small picture of each choice beside the scene: scene.candela.png, scene.unitless.png, "
                    + "scene.watts.png.")
    private boolean pictures;

    ImportCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String name = output.getFileName() == null ? "" : output.getFileName().toString();
        if (!JenFile.isNamedSo(name.toLowerCase(Locale.ROOT))) {
            throw new BadInput(output + ": a scene's name must end in " + JenFile.ENDING);
        }
        PictureOutput.checkFile(output);
        Import read;
        try (var bar = new ProgressBar(console, "reading")) {
            read = Importer.read(file, output, units == null ? LightUnits.CANDELA : units, bar);
        }
        read.write();
        if (pictures) {
            writePictures(read, name.substring(0, name.length() - JenFile.ENDING.length()));
        }
        if (units == null) {
            read.units()
                    .ifPresent(taken -> console.remark("%s: the numbers of its lights were taken as %s; --light-pictures shows each choice",
                            file, taken.words()));
        }
        console.notes(file, "left out or not the same", read.notes());
        console.line("%s: written; %s, %s, %s", output, Console.count(read.scene().stage().shapeCount(), "shape"),
                Console.count(read.scene().materials().size(), "material"), Console.count(read.scene().lights().size(), "light"));
        return ExitCode.DONE;
    }

    private void writePictures(Import read, String stem) throws IOException {
        try (var bar = new ProgressBar(console, "tracing"); var workers = new Workers(Workers.available())) {
            for (var picture : UnitPictures.of(read, PICTURE_SIZE, workers, bar).entrySet()) {
                Path to = output.resolveSibling(stem + "." + picture.getKey().name().toLowerCase(Locale.ROOT) + PictureFormat.PNG.ending());
                PictureFile.write(to, picture.getValue(), ViewTransform.DEFAULT);
                console.line("%s: written; numbers taken as %s", to, picture.getKey().words());
            }
        }
    }
}
