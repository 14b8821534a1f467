package lightning.cli;

import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.exchange.Import;
import lightning.exchange.Importer;
import lightning.exchange.LightUnits;
import lightning.mesh.MeshException;
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
    private final Console console;

    @Parameters(index = "0", paramLabel = "FILE", description = "A .glb, .gltf, .obj, .ply or .nff file.")
    private Path file;
    @Option(names = {"-o", "--output"}, paramLabel = "scene.jen", required = true, description = "The scene to write.")
    private Path output;
    @Option(names = "--light-units", paramLabel = "UNITS", defaultValue = "candela",
            description = "What the numbers of a glTF file's lights are: candela (and lux, as the format says), unitless (watts per steradian "
                    + "and per square metre) or watts, as its exporter was told. Default: ${DEFAULT-VALUE}.")
    private LightUnits units;

    ImportCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String name = output.getFileName() == null ? "" : output.getFileName().toString();
        if (!name.toLowerCase(Locale.ROOT).endsWith(".jen")) {
            throw new BadInput(output + ": a scene's name must end in .jen");
        }
        PictureOutput.checkFile(output);
        Import read;
        try (var bar = new ProgressBar(console, "reading")) {
            read = Importer.read(file, output, units, bar);
        } catch (MeshException e) {
            throw new BadInput(e.getMessage());
        }
        read.write();
        console.notes(file, "left out or not the same", read.notes());
        console.line("%s: written; %d shapes, %d materials, %d lights", output, read.scene().stage().shapeCount(),
                read.scene().materials().size(),
                read.scene().lights().size());
        return ExitCode.DONE;
    }
}
