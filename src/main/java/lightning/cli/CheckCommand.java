package lightning.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.report.CheckReport;
import lightning.format.jen.InertProperties;
import lightning.format.jen.JenReader;
import lightning.format.jen.ReferencedFiles;
import lightning.scene.Scene;
import lightning.scene.asset.Gobo;
import lightning.scene.light.Light;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Reads a scene and reports every problem. */
@Command(name = "check", abbreviateSynopsis = true, header = "Validate a scene.",
        description = {
            "Reads the scene and its textures. Prints one line per problem, FILE:LINE:COLUMN: what was expected and what was "
                    + "found; the exit code is then 2. A file that the scene cannot use, or only with fewer pixels, is a problem here. Prints a one-line summary of a valid scene, and warnings to the error stream."},
        footer = {
            "Example:",
            "  lightning check scenes/bird.jen"})
final class CheckCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;

    CheckCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = JenReader.read(input.path()).requireAllFiles().scene();
        Map<String, Long> objects = count(scene.placedShapes().stream().map(s -> s.shape().solid().typeName()));
        Map<String, Long> lights = count(scene.lights().stream().map(CheckCommand::typeName));
        long textures = ReferencedFiles.textures(scene).distinct().count();
        List<String> parts = new ArrayList<>();
        parts.add(describeCounts("object", objects));
        parts.add(describeCounts("light", lights));
        parts.add(Console.count(scene.materials().size(), "material"));
        parts.add(Console.count(textures, "texture"));
        long gobos = scene.lights().stream().flatMap(l -> l.gobo().stream()).map(Gobo::file).distinct().count();
        if (gobos > 0) {
            parts.add(Console.count(gobos, "gobo"));
        }
        console.print("%s: no problems; %s; %d x %d pixels, depth %d", input.path(), String.join(", ", parts),
                scene.picture().width(), scene.picture().height(), scene.picture().depth());
        console.printWarnings(input.path(), scene);
        InertProperties.of(scene).forEach(remark -> console.warn("%s: %s", input.path(), remark));
        console.report().setResult(new CheckReport(input.path().toString(), total(objects), objects, total(lights), lights,
                scene.materials().size(), textures, gobos, scene.picture().width(), scene.picture().height(), scene.picture().depth()));
        return ExitCode.OK;
    }

    /** Returns a count with its parts, such as "3 lights (1 point, 2 spot)". */
    private static String describeCounts(String noun, Map<String, Long> counts) {
        long total = total(counts);
        String detail = counts.entrySet().stream().map(e -> e.getValue() + " " + e.getKey()).collect(Collectors.joining(", "));
        return Console.count(total, noun) + (total == 0 ? "" : " (" + detail + ")");
    }

    private static Map<String, Long> count(Stream<String> kinds) {
        return kinds.collect(Collectors.groupingBy(k -> k, TreeMap::new, Collectors.counting()));
    }

    private static long total(Map<String, Long> counts) {
        return counts.values().stream().mapToLong(n -> n).sum();
    }

    private static String typeName(Light light) {
        return switch (light.type()) {
            case DIRECTIONAL -> "directional";
            case POINT -> "point";
            case SPOT -> "spot";
            case RECT -> "rect";
            case DISC -> "disc";
            case TUBE -> "tube";
            case OBJECT -> "object";
        };
    }
}
