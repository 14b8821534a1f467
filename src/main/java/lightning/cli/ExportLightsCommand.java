package lightning.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import lightning.base.file.AtomicFile;
import lightning.base.work.Progress;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.report.ConversionReport;
import lightning.format.exchange.LightExport;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Exports a scene's lights to glTF, USD or JSON. */
@Command(name = "export-lights", header = "Export a scene's lights to glTF, USD or JSON.", abbreviateSynopsis = true,
        description = {
            "With --into, writes a copy of a glTF file in which the scene's lights replace the original ones; everything else stays "
                    + "unchanged. Properties that glTF does not support are listed and counted. They are stored in the extras of the "
                    + "lights; lightning import restores them.",
            "",
            "Without --into, to a .usda file, writes a layer for the USD stage that the scene was imported from: its lights are changed, "
                    + "new ones are defined, deleted ones are inactive.",
            "",
            "Without --into, to a .json file, writes all light and light group properties of the scene as JSON, and animated "
                    + "properties of lights at each frame."},
        footer = {
            "Examples:",
            "  lightning export-lights house.jen --into house.glb -o relit.glb",
            "  lightning export-lights shot.jen -o lights.usda"})
final class ExportLightsCommand implements Callable<Integer> {
    private static final String LAYER_ENDING = ".usda";

    private final Console console;

    @Mixin
    private SceneFile input;
    @Option(names = "--into", paramLabel = "FILE", description = "The .gltf or .glb file to copy.")
    private @Nullable Path template;
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true, description = "Output file.")
    private Path output;
    @Option(names = "--light-units", paramLabel = "UNITS",
            description = "Light units of the output: candela (and lux), unitless or watts (default: the units chosen at import, "
                    + "else candela).")
    private @Nullable LightUnits units;

    ExportLightsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        boolean isLayer = template == null && output.toString().toLowerCase(Locale.ROOT).endsWith(LAYER_ENDING);
        String ending = isLayer ? LAYER_ENDING : template == null ? ".json"
                : template.toString().toLowerCase(Locale.ROOT).endsWith(".glb") ? ".glb" : ".gltf";
        if (!output.toString().toLowerCase(Locale.ROOT).endsWith(ending)) {
            throw new BadInputException(
                    Console.text("%s: the output name must end in %s", output, template == null ? ".json or .usda" : ending));
        }
        if (template != null && Files.exists(output) && Files.isSameFile(template, output)) {
            throw new BadInputException(Console.text("%s: is the file to copy; choose another output name", output));
        }
        PictureOutput.checkFile(output);
        JenDocument document = input.read(console);
        Scene scene = document.scene();
        input.inputs(scene).check(output);
        LightUnits chosen = units != null ? units : LightUnits.findIn(document.text()).orElse(LightUnits.CANDELA);
        ExportedLights lights = isLayer ? LightExport.toUsd(document.text(), document.animatedScene(), input.path(), output)
                : template == null ? LightExport.toJson(document.animatedScene())
                : LightExport.toGltf(template, scene, chosen, Progress.NONE);
        for (Map.Entry<String, byte[]> file : lights.files().entrySet()) {
            Path place = output.resolveSibling(file.getKey());
            input.inputs(scene).check(place);
            AtomicFile.write(place, out -> out.write(file.getValue()));
        }
        AtomicFile.write(output, out -> out.write(lights.bytes()));
        console.printNotes(output, "not exported exactly", lights.notes());
        console.print("%s: written; %s%s", output, Console.count(scene.lights().size(), "light"),
                template == null ? "" : ", in " + chosen.description());
        console.report().setResult(new ConversionReport(output.toString(), null, null, scene.lights().size(),
                template == null ? null : chosen.description(), null, lights.notes()));
        return ExitCode.OK;
    }
}
