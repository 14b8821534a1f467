package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.base.work.WorkerPool;
import lightning.format.exchange.ImportedScene;
import lightning.format.exchange.LightUnitPreviews;
import lightning.format.exchange.LightUnits;
import lightning.format.exchange.SceneImporter;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.JenFile;
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
                    + "and per square meter) or watts, as its exporter was told. Default: candela.")
    private LightUnits units;
    @Option(names = "--light-pictures",
            description = "Also write a small picture of each choice beside the scene: scene.candela.png, scene.unitless.png, "
                    + "scene.watts.png.")
    private boolean writesUnitPictures;

    ImportCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String name = output.getFileName() == null ? "" : output.getFileName().toString();
        if (!JenFile.isJenFileName(name.toLowerCase(Locale.ROOT))) {
            throw new BadInputException(output + ": a scene's name must end in " + JenFile.EXTENSION);
        }
        PictureOutput.checkFile(output);
        ImportedScene imported;
        try (var bar = new ProgressBar(console, "reading")) {
            imported = SceneImporter.read(file, output, units == null ? LightUnits.CANDELA : units, bar);
        }
        imported.write();
        if (writesUnitPictures) {
            writePictures(imported, name.substring(0, name.length() - JenFile.EXTENSION.length()));
        }
        if (units == null) {
            imported.units()
                    .ifPresent(
                            usedUnits -> console.warn("%s: the numbers of its lights were taken as %s; --light-pictures shows each choice",
                                    file, usedUnits.description()));
        }
        console.printNotes(file, "left out or not the same", imported.notes());
        console.print("%s: written; %s, %s, %s", output, Console.count(imported.scene().stage().shapeCount(), "shape"),
                Console.count(imported.scene().materials().size(), "material"), Console.count(imported.scene().lights().size(), "light"));
        return ExitCode.OK;
    }

    private void writePictures(ImportedScene imported, String stem) throws IOException {
        try (var bar = new ProgressBar(console, "tracing"); var workers = new WorkerPool(WorkerPool.processorCount())) {
            for (var picture : LightUnitPreviews.render(imported, PICTURE_SIZE, workers, bar).entrySet()) {
                Path file =
                        output.resolveSibling(stem + "." + picture.getKey().name().toLowerCase(Locale.ROOT) + ImageFormat.PNG.extension());
                ImageFile.write(file, picture.getValue(), ViewTransform.DEFAULT);
                console.print("%s: written; numbers taken as %s", file, picture.getKey().description());
            }
        }
    }
}
