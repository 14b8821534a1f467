package lightning.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.base.file.AtomicFile;
import lightning.base.work.Progress;
import lightning.format.exchange.LightExport;
import lightning.format.exchange.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.scene.Scene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Takes a scene's lights to other programs. */
@Command(name = "export-lights", header = "Write a scene's lights into a glTF file, or as plain JSON.", abbreviateSynopsis = true,
        description = {
            "With --into, writes a copy of a glTF file with the scene's lights in place of its own, and nothing else touched. What glTF",
            "cannot say is listed and counted; it is written into the extras of the lights, from where lightning import restores it.",
            "Without --into, writes all that the scene says of its lights and banks as JSON."},
        footer = {
            "Example:",
            "  lightning export-lights house.jen --into house.glb -o relit.glb"})
final class ExportLightsCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Option(names = "--into", paramLabel = "FILE", description = "The .gltf or .glb file to copy, which is not changed.")
    private Path template;
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true, description = "The file to write.")
    private Path output;
    @Option(names = "--light-units", paramLabel = "UNITS",
            description = "What the numbers of the glTF file's lights shall be: candela (and lux), unitless or watts. "
                    + "Default: what was chosen at import, which the scene says; else candela.")
    private LightUnits units;

    ExportLightsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        String ending = template == null ? ".json" : template.toString().toLowerCase(Locale.ROOT).endsWith(".glb") ? ".glb" : ".gltf";
        if (!output.toString().toLowerCase(Locale.ROOT).endsWith(ending)) {
            throw new BadInputException(Console.text("%s: the file's name must end in %s", output, ending));
        }
        if (template != null && Files.exists(output) && Files.isSameFile(template, output)) {
            throw new BadInputException(Console.text("%s: is the file to copy, which stays as it is; choose another name", output));
        }
        PictureOutput.checkFile(output);
        JenDocument document = input.read();
        Scene scene = document.scene();
        LightUnits chosen = units != null ? units : LightUnits.findIn(document.text()).orElse(LightUnits.CANDELA);
        LightExport lights = template == null ? LightExport.toJson(scene) : LightExport.toGltf(template, scene, chosen, Progress.NONE);
        AtomicFile.write(output, out -> out.write(lights.bytes()));
        console.printNotes(output, "not the same there", lights.notes());
        console.print("%s: written; %s%s", output, Console.count(scene.lights().size(), "light"),
                template == null ? "" : ", in " + chosen.description());
        return ExitCode.OK;
    }
}
