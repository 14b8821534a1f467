package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import lightning.cli.option.OptionRange;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.report.ShotLightsReport;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.sequence.LoadedSequence;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Lists the difference that each light makes in the frames of a shot or a sequence, and leaves out lights without a visible one. */
@Command(name = "lights", abbreviateSynopsis = true, header = "List the lights that a shot or a sequence does not need.",
        description = {
            "Renders each frame with all lights and without each one, and prints the largest difference of a pixel in any frame: linear, and in "
                    + "steps of 8 bits as the scene's view shows it. Nothing is estimated; to leave out a light costs no ray.",
            "",
            "Lights that change no pixel by more than --steps can be left out. They are then left out together and measured again. -o writes the "
                    + "scene, or the rig of a sequence, without them."},
        footer = {
            "Examples:",
            "  lightning shot lights scenes/dusk.jen --frames 1-4 --size 60x40"})
final class ShotLightsCommand implements Callable<Integer> {
    private static final int MAX_STEPS = 255;

    private final Console console;

    @Spec
    private CommandSpec command;
    @Mixin
    private SceneFile input;
    @Mixin
    private ShotParts chosen;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Option(names = "--every", paramLabel = "N", defaultValue = "1", description = "Measure every Nth frame only (default: 1).")
    private int every;
    @Option(names = "--steps", paramLabel = "N", defaultValue = "1",
            description = "Largest difference of a light that can be left out, steps of 8 bits (default: 1).")
    private int steps;
    @Option(names = {"-o", "--output"}, paramLabel = "FILE.jen", description = "Scene or rig to write without these lights.")
    private @Nullable Path output;

    ShotLightsCommand(Console console) {
        this.console = console;
    }

    /** Largest differences that a light, or several together, make. */
    private static final class LargestDifference {
        private double linear;
        private int steps;
        private String shot = "";
        private int frame;

        private void add(Film with, Film without, Scene scene, String name, int at) {
            float[] a = with.toScanlines();
            float[] b = without.toScanlines();
            double largest = 0;
            for (int i = 0; i < a.length; i++) {
                largest = Math.max(largest, Math.abs((double) a[i] - b[i]));
            }
            int[] shownA = SceneView.of(scene).toPixels(with);
            int[] shownB = SceneView.of(scene).toPixels(without);
            int step = 0;
            for (int i = 0; i < shownA.length; i++) {
                for (int shift = 0; shift < 24; shift += 8) {
                    step = Math.max(step, Math.abs((shownA[i] >> shift & 0xff) - (shownB[i] >> shift & 0xff)));
                }
            }
            if (step > steps || step == steps && largest > linear) {
                shot = name;
                frame = at;
            }
            linear = Math.max(linear, largest);
            steps = Math.max(steps, step);
        }
    }

    @Override
    public Integer call() throws Exception {
        if (every < 1) {
            throw new ParameterException(command.commandLine(), "--every must be at least 1, was " + every);
        }
        OptionRange.check(command, "--steps", steps, 0, MAX_STEPS);
        ShotParts.Parts shots = chosen.read(input.path(), picture, console);
        if (output != null) {
            PictureOutput.checkFile(output);
            for (ShotParts.Part part : shots.parts()) {
                InputFiles.of(part.file(), List.of(part.scene())).check(output);
            }
        }
        Map<String, LargestDifference> found = new LinkedHashMap<>();
        forEachFrame(shots.parts(), (renderer, cache, part, frame, bar) -> {
            Scene scene = cache.scene();
            for (Light light : scene.lights()) {
                LargestDifference difference = found.computeIfAbsent(light.name(), _ -> new LargestDifference());
                if (scene.isActive(light)) {
                    add(difference, renderer, cache, Set.of(light.name()), part, frame, bar);
                }
            }
        });
        Set<String> needless = new HashSet<>();
        LargestDifference alone = new LargestDifference();
        for (Map.Entry<String, LargestDifference> entry : found.entrySet()) {
            if (entry.getValue().steps <= steps) {
                needless.add(entry.getKey());
                alone = entry.getValue();
            }
        }
        LargestDifference together = needless.size() > 1 ? new LargestDifference() : alone;
        if (needless.size() > 1) {
            forEachFrame(shots.parts(), (renderer, cache, part, frame, bar) -> add(together, renderer, cache, needless, part, frame, bar));
        }
        print(found, needless, together, shots.areOfSequence());
        if (output != null) {
            write(output, needless, shots.areOfSequence());
        }
        return ExitCode.OK;
    }

    /** Receives the picture of a frame. */
    private interface FrameUse {
        void use(Renderer renderer, PixelCache cache, ShotParts.Part part, int frame, ProgressBar bar);
    }

    private void forEachFrame(List<ShotParts.Part> parts, FrameUse use) {
        int total = parts.stream().mapToInt(part -> (part.frames().range().count() + every - 1) / every).sum();
        int done = 0;
        try (ProgressBar bar = new ProgressBar(console, "measuring")) {
            for (ShotParts.Part part : parts) {
                try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(threads.count()))) {
                    for (int frame = part.frames().range().first(); frame <= part.frames().range().last(); frame += every) {
                        renderer.render(part.frames().shot().sceneAt(part.scene(), frame), bar.cancellationOnly());
                        PixelCache cache = renderer.cache();
                        use.use(renderer, cache, part, frame, bar);
                        renderer.restore(cache);
                        bar.report(++done, total);
                    }
                }
            }
        }
    }

    private static void add(LargestDifference to, Renderer renderer, PixelCache cache, Set<String> off, ShotParts.Part part, int frame,
            ProgressBar bar) {
        Scene scene = cache.scene();
        renderer.restore(cache);
        renderer.render(without(scene, off), bar.cancellationOnly());
        to.add(cache.film(), renderer.film(), scene, part.name(), frame);
    }

    private static Scene without(Scene scene, Set<String> names) {
        return scene.withLights(scene.lights().stream().filter(light -> !names.contains(light.name())).toList());
    }

    private void print(Map<String, LargestDifference> found, Set<String> needless, LargestDifference together, boolean areOfSequence) {
        List<Map.Entry<String, LargestDifference>> sorted = new ArrayList<>(found.entrySet());
        sorted.sort(Comparator.comparingInt((Map.Entry<String, LargestDifference> e) -> e.getValue().steps)
                .thenComparingDouble(e -> e.getValue().linear));
        List<ShotLightsReport.LightDifference> rows = new ArrayList<>();
        for (Map.Entry<String, LargestDifference> entry : sorted) {
            LargestDifference d = entry.getValue();
            boolean isDark = d.linear == 0;
            String where = isDark ? "" : areOfSequence ? ", " + d.shot + " frame " + d.frame : ", frame " + d.frame;
            console.print("%s: %s of 8 bits, %.3g linear%s", entry.getKey(), Console.count(d.steps, "step"), d.linear, where);
            rows.add(new ShotLightsReport.LightDifference(entry.getKey(), d.linear, d.steps, isDark || !areOfSequence ? null : d.shot,
                    isDark ? null : d.frame));
        }
        List<String> names = sorted.stream().map(Map.Entry::getKey).filter(needless::contains).toList();
        if (names.isEmpty()) {
            console.print("every light changes a pixel by more than %s", Console.count(steps, "step"));
        } else {
            console.print("without %s: %s of 8 bits, %.3g linear", String.join(", ", names), Console.count(together.steps, "step"),
                    together.linear);
        }
        console.report().setResult(new ShotLightsReport(rows, names, names.isEmpty() ? null : together.steps,
                names.isEmpty() ? null : together.linear, output == null ? null : output.toString()));
    }

    private void write(Path file, Set<String> needless, boolean isSequence) throws Exception {
        JenDocument document;
        if (isSequence) {
            document = JenDocument.of(LoadedSequence.read(input.path()).rig());
        } else {
            document = input.read(console);
        }
        Scene scene = document.scene();
        document.withScene(without(scene, needless)).save(file);
    }
}
