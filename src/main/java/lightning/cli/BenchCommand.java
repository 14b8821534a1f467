package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.base.file.ParentFolder;
import lightning.base.text.Quote;
import lightning.bench.BenchSettings;
import lightning.bench.Harness;
import lightning.bench.NamedScene;
import lightning.bench.PaperFigures;
import lightning.bench.PictureSize;
import lightning.bench.ResultsReporter;
import lightning.bench.report.HtmlReport;
import lightning.bench.result.BaselineComparison;
import lightning.bench.result.BenchResults;
import lightning.bench.result.MeasurementFailure;
import lightning.bench.result.ResultsFile;
import lightning.cli.option.OptionRange;
import lightning.cli.option.PictureDimensions;
import lightning.cli.option.RepetitionsOption;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.BenchTable;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.ProgressBar;
import lightning.cli.report.BenchReport;
import lightning.scene.paper.PaperCases;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Benchmark of relighting: time saved and accuracy of each setting. */
@Command(name = "bench", header = "Benchmark relighting: time saved and accuracy.", abbreviateSynopsis = true,
        description = {
            "Runs the paper's edits and a few more on every scene, each with three values and at every accuracy setting, from "
                    + "half resolution to the full trace. Measures the time and error of each edit.",
            "",
            "Also measures the first pass; how times scale with pixels, lights, objects and reflection bounces; editing with up to "
                    + "a million objects; ray tracing of meshes (compared with Embree if installed); error drift over 10 000 edits; memory "
                    + "bandwidth; POV-Ray if installed; and cold starts of whole processes. Compared programs run alternately. Each image "
                    + "is checked before it is timed.",
            "",
            "Writes report.html (a self-contained page with charts and images), results.json (every sample), results.csv (one row "
                    + "per measurement) and images to the output folder. A canceled run keeps its results so far.",
            "",
            "Exit codes: 1 if an image is less accurate than its setting promises or a result is worse than the baseline, "
                    + "2 if a scene cannot be read (the other scenes are measured)."},
        footer = {
            "Examples:",
            "  lightning bench -o results --quick",
            "  lightning bench scenes/bird.jen -o fig24 --figure 24",
            "  lightning bench -o house --figure B4",
            "  lightning bench --report results/results.json",
            "  lightning bench -o new --baseline old/results.json"})
final class BenchCommand implements Callable<Integer> {
    private static final double MINUTE = 60;
    /** Scenes of the paper: one with few objects, one with many, and one with mutual reflections. */
    private static final List<String> QUICK_SCENES = List.of("bird", "balls", "house");
    /** Scenes with area lights, glass, leaves, many lights or an environment. */
    private static final List<String> MODERN_SCENES = List.of("product", "stage", "window", "hall", "softbox", "night", "arbor");
    /** Scenes with rooms or many lights. */
    private static final List<String> INDIRECT_SCENES = List.of("hall", "window", "night");
    private static final int MAX_PROCESSES = 1000;

    private final Console console;
    private final ResultsReporter reporter = HtmlReport::write;

    @Spec
    private CommandSpec command;
    @Parameters(arity = "0..*", paramLabel = "scene.jen", description = "Scenes (default: all in scenes/).")
    private List<Path> scenes = List.of();
    @Option(names = {"-o", "--output"}, paramLabel = "DIR",
            description = "Output folder, created if missing (default with --report: the results' folder).")
    private @Nullable Path folder;
    @Option(names = "--report", paramLabel = "RESULTS.json",
            description = "Write the report of existing results; measure nothing.")
    private @Nullable Path storedResults;
    @Option(names = "--edits", description = "Measure edits and scaling only: no effects, cold starts or large scenes.")
    private boolean editsOnly;
    @Option(names = "--quick",
            description = "Measure a small selection: one value per edit at 640x480, three scenes.")
    private boolean quick;
    @Option(names = "--effects", description = "Measure only the first pass and the cost of each effect.")
    private boolean effects;
    @Option(names = "--cold",
            description = "Measure only the first pass and cold starts of whole processes, alternating with POV-Ray if installed.")
    private boolean coldStart;
    @Option(names = "--editing",
            description = "Measure only editing, with up to a million objects and a thousand lights, without the editor's window.")
    private boolean editing;
    @Option(names = "--meshes",
            description = "Measure only ray tracing of meshes of up to ten million triangles, alternating with Embree if installed.")
    private boolean meshes;
    @Option(names = "--modern",
            description = "Measure only the modern scenes with and without anti-aliasing: first pass, edits, cold starts, and time "
                    + "against error, alternating with POV-Ray if installed (default scenes: product, stage, window, hall, softbox, "
                    + "night, arbor).")
    private boolean modern;
    @Option(names = "--indirect",
            description = "Measure only indirect light: time against error, first pass, edits, and growth with lights, gather points, rays, "
                    + "objects, triangles and pixels (default scenes: hall, window, night). Without this option, indirect light is left out.")
    private boolean indirect;
    @Option(names = "--size", paramLabel = "WxH", converter = PictureDimensions.Converter.class,
            description = "Image size in pixels; repeat for several sizes (default: 300x300 and 1920x1080).")
    private List<PictureDimensions> sizes = List.of();
    @Option(names = "--antialiased", paramLabel = "NAME",
            description = "Keep the anti-aliasing of this scene; repeat for several (default: leave out anti-aliasing).")
    private List<String> antialiased = List.of();
    @Option(names = "--baseline", paramLabel = "OLD.json",
            description = "Compare with earlier results: print what is slower (disjoint quartiles and more than 10 %%, also relative to "
                    + "the full trace) or less accurate.")
    private @Nullable Path baseline;
    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "Random seed (default: 1).")
    private long seed;
    @Mixin
    private ThreadsOption threads;
    private PaperFigures.@Nullable Subject figure;
    private @Nullable Integer values;
    private @Nullable Integer repetitions;
    private @Nullable Integer processes;
    /** Measurements that are worse than the baseline; null without one. */
    private @Nullable List<String> worse;

    @Option(names = "--processes", paramLabel = "N",
            description = "Cold starts per image (default: 10; 0 with --quick).")
    private void setProcesses(int value) {
        processes = OptionRange.check(command, "--processes", value, 0, MAX_PROCESSES);
    }

    @Option(names = "--figure", paramLabel = "N",
            description = "Measure only the edits of one of the paper's figures (default scene: the figure's). B1 to B4 are the "
                    + "examples of its Appendix B (balls, spaceship, desk, house), B is all four.")
    private void setFigure(String value) {
        figure = PaperFigures.parse(value).orElseThrow(() -> new ParameterException(command.commandLine(),
                "--figure must be a figure with measured edits (" + PaperFigures.measuredRange() + "), was " + Quote.of(value)));
    }

    @Option(names = "--values", paramLabel = "N", description = "Values per edit (default: 3; 1 with --quick).")
    private void setValues(int value) {
        values = OptionRange.check(command, "--values", value, 1, PaperCases.VALUES);
    }

    @Option(names = "--repetitions", paramLabel = "N",
            description = "Repetitions (default: 5; 3 with --quick). 1: preview without warm-up, not a measurement.")
    private void setRepetitions(int value) {
        repetitions = RepetitionsOption.check(command, value);
    }

    BenchCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (storedResults != null) {
            return report(storedResults);
        }
        if (folder == null) {
            throw new ParameterException(command.commandLine(), "Missing required option: '--output=DIR'");
        }
        BenchResults baselineResults = baseline == null ? null : ResultsFile.readJson(baseline);
        BenchScenes benchScenes = BenchScenes.read(scenes,
                figure != null ? figure.scenes() : modern ? MODERN_SCENES : indirect ? INDIRECT_SCENES : quick ? QUICK_SCENES : List.of());
        benchScenes.problems().forEach(problem -> console.warn("%s", problem.what()));
        if (benchScenes.scenes().isEmpty()) {
            throw new BadInputException("no scene to measure");
        }
        requireMeasured(antialiased, benchScenes);
        Files.createDirectories(folder);
        BenchResults results = measure(benchScenes.withoutAntialiasing(antialiased), folder);
        console.print("%s: report.html, results.json, results.csv and images", folder);
        int exit = exitCode(results, baselineResults, !benchScenes.problems().isEmpty());
        console.report().setResult(new BenchReport(folder.toString(), folder.resolve(HtmlReport.FILE).toString(),
                folder.resolve(BenchOutput.RESULTS).toString(), benchScenes.scenes().size(),
                results.problems().stream().map(MeasurementFailure::what).toList(), worse));
        return exit;
    }

    /** Rejects names of scenes that are not measured. */
    private void requireMeasured(List<String> names, BenchScenes benchScenes) {
        List<String> measured = benchScenes.scenes().stream().map(NamedScene::name).toList();
        names.stream().filter(name -> !measured.contains(name)).findFirst().ifPresent(name -> {
            throw new ParameterException(command.commandLine(),
                    "--antialiased must be the name of a measured scene (" + String.join(", ", measured) + "), was " + Quote.of(name));
        });
    }

    /** Writes the report of stored results again. */
    private int report(Path stored) throws IOException {
        if (!scenes.isEmpty()) {
            throw new ParameterException(command.commandLine(), "--report reads " + stored + " and measures no scene");
        }
        BenchResults results = ResultsFile.readJson(stored);
        Path resultsFolder = ParentFolder.of(stored);
        Path targetFolder = folder == null ? resultsFolder : folder;
        Files.createDirectories(targetFolder);
        HtmlReport.write(results, resultsFolder, targetFolder);
        console.print("%s", targetFolder.resolve(HtmlReport.FILE));
        console.report().setResult(new BenchReport(targetFolder.toString(), targetFolder.resolve(HtmlReport.FILE).toString(),
                stored.toString(), null, null, null));
        return ExitCode.OK;
    }

    private BenchSettings settings() {
        BenchSettings settings = quick ? BenchSettings.quick(threads.count(), seed) : BenchSettings.full(threads.count(), seed);
        if (!sizes.isEmpty()) {
            settings = settings.withSizes(sizes.stream().map(size -> new PictureSize(size.width(), size.height())).distinct().toList());
        }
        if (figure != null) {
            settings = settings.withFigure(figure.figure());
        }
        if (editsOnly) {
            settings = settings.editsAndCurves();
        }
        if (effects) {
            settings = settings.effectsOnly();
        }
        if (coldStart) {
            settings = settings.coldStartOnly();
        }
        if (editing) {
            settings = settings.editingOnly();
        }
        if (meshes) {
            settings = settings.meshesOnly();
        }
        if (modern) {
            settings = settings.modernOnly();
        }
        if (indirect) {
            settings = settings.indirectOnly();
        }
        if (values != null && settings.values() > 0) {
            settings = settings.withValues(values);
        }
        if (processes != null) {
            settings = settings.withProcesses(processes);
        }
        return repetitions == null ? settings : settings.withRepetitions(repetitions);
    }

    private BenchResults measure(BenchScenes benchScenes, Path target) throws IOException, InterruptedException {
        BenchTable table = new BenchTable(console);
        BenchOutput files = new BenchOutput(target, reporter);
        try (ProgressBar bar = new ProgressBar(console, "bench")) {
            List<String> arguments = new ArrayList<>(command.commandLine().getParseResult().originalArgs());
            Harness harness = new Harness(settings(), benchScenes.scenes(), benchScenes.problems(), target, arguments, bar);
            int count = benchScenes.scenes().size();
            console.print("%d scene%s; this will take about %s", count, count == 1 ? "" : "s", duration(harness.predictedSeconds()));
            try {
                BenchResults results = harness.run((_, until) -> {
                    table.printNew(until);
                    files.writePeriodically(until);
                }, bar);
                files.write(results);
                table.printSummary(results);
                return results;
            } catch (CancellationException | InterruptedException | IOException e) {
                files.writeUninterruptibly(harness.results(false), () -> console.warn("%s: contains the results so far", folder));
                throw e;
            }
        }
    }

    private static String duration(double seconds) {
        return seconds < 2 * MINUTE ? Console.text("%.0f s", Math.ceil(seconds)) : Console.text("%.0f min", Math.ceil(seconds / MINUTE));
    }

    private int exitCode(BenchResults results, @Nullable BenchResults baselineResults, boolean hasUnreadable) throws BadInputException {
        long failures = results.problems().stream().filter(problem -> problem.kind() == MeasurementFailure.Kind.BROKEN).count();
        if (baselineResults != null) {
            BaselineComparison compared = BaselineComparison.compare(baselineResults, results);
            if (compared.compared() == 0) {
                throw new BadInputException(baseline + ": contains none of the edits measured now");
            }
            worse = compared.worse();
            compared.worse().forEach(line -> console.print("%s", line));
            console.print("baseline: %s compared, %d worse", Console.count(compared.compared(), "measurement"), compared.worse().size());
            failures += compared.worse().size();
        }
        return failures > 0 ? ExitCode.CHECK_FAILED : hasUnreadable ? ExitCode.BAD_INPUT : ExitCode.OK;
    }
}
