package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import lightning.base.text.Quote;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.report.ConversionReport;
import lightning.document.imports.LightUnitPreviews;
import lightning.format.exchange.ImportLighting;
import lightning.format.exchange.ImportOptions;
import lightning.format.exchange.IndirectChoice;
import lightning.format.exchange.SceneImporter;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.JenFile;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Converts a file of another program to a scene. */
@Command(name = "import", header = "Convert glTF, USD, OBJ, PLY, NFF, FBX and others to a .jen scene.", abbreviateSynopsis = true,
        description = "Writes a scene with the file's meshes, cameras, lights and materials. Copies the file and its images next to "
                + "the scene unless they are already there. Lists and counts the features that are left out or converted approximately.",
        footer = {
            "Examples:",
            "  lightning import house.glb -o house.jen --light-units candela",
            "  lightning import shot.usda -o shot.jen",
            "  lightning import shot.usda --camera side --frame 1050 -o still.jen"})
final class ImportCommand implements Callable<Integer> {
    /** Longer side of a preview image, in pixels. */
    private static final int PICTURE_SIZE = 320;

    private final Console console;

    @Parameters(index = "0", paramLabel = "FILE",
            description = "A .glb, .gltf, .obj, .ply, .nff, .fbx, .dae, .stl, .usd, .usda, .usdc or .usdz file, or one of docs/command-line.md. USD files "
                    + "need Python with the package usd-core; LIGHTNING_PYTHON names its interpreter, LIGHTNING_USD_FOLDERS "
                    + "folders besides the file's own that it may refer to.")
    private Path file;
    @Option(names = {"-o", "--output"}, paramLabel = "scene.jen", required = true, description = "Output scene.")
    private Path output;
    @Option(names = "--replace", description = "Also replace meshes and images next to the scene that have other content, such as those "
            + "of an earlier import. The scene itself is always replaced.")
    private boolean replaces;
    @Option(names = "--keep-others", description = "Replace meshes and images next to the scene only if an earlier import with this option "
            + "wrote them for this scene, and they have not changed since. Others stay; the new ones get another name.")
    private boolean keepsOthers;
    @Option(names = "--light-units", paramLabel = "UNITS",
            description = "Units of a glTF file's lights: candela (and lux, as the format defines), unitless (watts per steradian and "
                    + "per square meter) or watts, as chosen in its exporter (default: candela, but watts for Blender before 3.4).")
    private @Nullable LightUnits units;
    @Option(names = "--light-pictures",
            description = "Also write a small preview for each light unit next to the scene, such as scene.candela.png.")
    private boolean writesUnitPictures;

    @Option(names = "--subdivision", paramLabel = "LEVELS",
            description = "Refinements of the subdivision surfaces of a USD file, from 0 (their control meshes) to 4 (default: 2). Dense "
                    + "meshes get fewer, at most a million triangles for each.")
    private int levels = SceneImporter.DEFAULT_LEVELS;

    @Option(names = "--variant", paramLabel = "NAME",
            description = "Variant of a glTF file's materials (default: the materials that the file has without variants), or SET=NAME for "
                    + "a variant of a USD file (default: as the stage selects). PATH:SET=NAME selects it on one prim only. Repeat for more.")
    private List<String> variants = new ArrayList<>();

    @Option(names = "--camera", paramLabel = "NAME",
            description = "Camera of a glTF or USD file; in USD its name or its path (default: that of the render settings, or the first).")
    private String camera = "";

    @Option(names = "--frame", paramLabel = "F",
            description = "Time code of a USD file at which all of it is read, without animation (default: animation, and what cannot be "
                    + "animated as at the first frame).")
    private @Nullable Double frame;

    @Option(names = "--indirect", paramLabel = "WHEN",
            description = "Indirect light: on, off, or auto, which is on if the camera is in a closed room (default: on).")
    private IndirectChoice indirect = IndirectChoice.ON;

    @Option(names = "--glowing-lights", description = "Make each object that glows a light that shines on others with soft shadows.")
    private boolean hasGlowingLights;

    @Option(names = "--lighting", paramLabel = "LIGHTS",
            description = "Lights of the scene: file (the file's own), studio (soft key, fill and rim lights on a cyclorama), sky (sun, "
                    + "sky and ground), or an image of a photo studio: softboxes, strips or ring. All but file fit the "
                    + "size of the subject, frame it if the file has no camera, and smooth edges "
                    + "(default: file).")
    private ImportLighting lighting = ImportLighting.FILE;

    ImportCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String name = output.getFileName() == null ? "" : output.getFileName().toString();
        if (!JenFile.isJenFileName(name.toLowerCase(Locale.ROOT))) {
            throw new BadInputException(output + ": a scene's file name must end in " + JenFile.EXTENSION);
        }
        if (levels < 0 || levels > SceneImporter.MAX_LEVELS) {
            throw new BadInputException("--subdivision must be from 0 to " + SceneImporter.MAX_LEVELS + ", was " + levels);
        }
        if (frame != null && !(Math.abs(frame) <= ImportOptions.MAX_FRAME)) {
            throw new BadInputException("--frame must be from -100000000 to 100000000, was " + frame);
        }
        PictureOutput.checkFile(output);
        ImportedScene imported;
        try (var bar = new ProgressBar(console, "reading")) {
            imported =
                    SceneImporter.read(file, output, new ImportOptions(Optional.ofNullable(units), levels, variants, camera,
                            frame == null ? OptionalDouble.empty() : OptionalDouble.of(frame)), bar);
        }
        boolean saysIndirect = imported.hasIndirect();
        imported = lighting.apply(indirect.apply(imported));
        Optional<LightUnits> usedUnits = imported.units();
        imported = hasGlowingLights ? imported.withGlowingLights() : imported;
        imported = keepsOthers ? imported.keepingOthers((old, used) -> console
                .warn("%s: stays, because it has other content; the scene uses %s", output.resolveSibling(old), Quote.of(used))) : imported;
        List<Path> replaced = keepsOthers ? List.of() : imported.differentFiles();
        if (!replaced.isEmpty() && !replaces) {
            throw new BadInputException(Quote.path(replaced.getFirst()) + ": already exists with other content"
                    + (replaced.size() == 1 ? "; --replace replaces it" : Console.text(", and %d more; --replace replaces them",
                            replaced.size() - 1))
                    + ", or import into another folder");
        }
        imported.writeReplacing();
        replaced.forEach(old -> console.warn("%s: replaced", old));
        if (writesUnitPictures) {
            writePictures(imported, name.substring(0, name.length() - JenFile.EXTENSION.length()));
        }
        if (units == null) {
            usedUnits.ifPresent(used -> console.warn("%s: light units taken as %s; --light-pictures shows each choice", file,
                    used.description()));
        }
        if (imported.hasIndirect() && !saysIndirect && indirect == IndirectChoice.AUTO) {
            console.warn("%s: the camera is in a closed room, so indirect light is on; --indirect off leaves it out", file);
        }
        console.printNotes(file, "left out or approximated", imported.notes());
        console.print("%s: written; %s, %s, %s", output, Console.count(imported.scene().stage().shapeCount(), "object"),
                Console.count(imported.scene().materials().size(), "material"), Console.count(imported.scene().lights().size(), "light"));
        console.report().setResult(new ConversionReport(output.toString(), imported.scene().stage().shapeCount(),
                imported.scene().materials().size(), imported.scene().lights().size(),
                usedUnits.map(LightUnits::description).orElse(null), imported.hasIndirect(), imported.notes()));
        return ExitCode.OK;
    }

    private void writePictures(ImportedScene imported, String stem) throws IOException {
        try (var bar = new ProgressBar(console, "tracing"); var workers = new WorkerPool(WorkerPool.processorCount())) {
            var previews = new LightUnitPreviews(imported, PICTURE_SIZE);
            for (LightUnits units : LightUnits.values()) {
                Path file = output.resolveSibling(stem + "." + units.name().toLowerCase(Locale.ROOT) + ImageFormat.PNG.extension());
                imported.inputs(this.file).check(file);
                ProgressPart part = new ProgressPart(bar, 0, 1).section(units.ordinal(), LightUnits.values().length);
                ImageFile.write(file, previews.render(units, workers, part), ViewTransform.DEFAULT);
                console.print("%s: written; light units taken as %s", file, units.description());
            }
        }
    }
}
