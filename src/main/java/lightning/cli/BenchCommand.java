package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.base.text.Quote;
import lightning.bench.BaselineComparison;
import lightning.bench.BenchResults;
import lightning.bench.BenchSettings;
import lightning.bench.Harness;
import lightning.bench.MeasurementFailure;
import lightning.bench.PaperFigures;
import lightning.bench.PictureSize;
import lightning.bench.ResultsFile;
import lightning.bench.ResultsReporter;
import lightning.bench.accuracy.PaperCases;
import lightning.bench.report.HtmlReport;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Measures what re-rendering saves and what accuracy costs. */
@Command(name = "bench", header = "Measure what re-rendering saves, and what accuracy costs in time.", abbreviateSynopsis = true,
        description = {
            "Makes the paper's edits, and a few more, on every scene, each with three values, at each grade of accuracy, from",
            "half the resolution to the full trace, and measures time and error of each. Also measures the first pass, how times",
            "grow with pixels, lights, shapes and mirror bounces, what editing costs with up to a million shapes, how fast",
            "rays are traced against meshes beside Embree where it is installed, how errors drift over 10 000 edits, the bandwidth of",
            "memory, and POV-Ray where it is installed, and whole processes that begin cold. Works are measured in turns; no picture is timed before it was compared.",
            "",
            "Writes report.html (a page with charts and pictures, which needs no network), results.json (everything, with every",
            "sample), results.csv (a row for each measurement) and pictures into the folder. A run that is canceled keeps what it",
            "has. The exit code is 1 if a picture was not what its grade promises, or something became worse than the baseline; 2 if",
            "a scene could not be read (the others are measured)."},
        footer = {
            "Examples:",
            "  lightning bench -o results --quick",
            "  lightning bench scenes/bird.jen -o fig24 --figure 24",
            "  lightning bench -o house --figure B4",
            "  lightning bench --report results/results.json",
            "  lightning bench -o new --baseline old/results.json"})
final class BenchCommand implements Callable<Integer> {
    private static final double MINUTE = 60;
    /** Of the paper, with few shapes and with many, and with mirrors in mirrors. */
    private static final List<String> QUICK_SCENES = List.of("bird", "balls", "house");
    private static final int MAX_PROCESSES = 1000;

    private final Console console;
    /** What makes a page of the results. */
    private final ResultsReporter reporter = HtmlReport::write;

    @Spec
    private CommandSpec command;
    @Parameters(arity = "0..*", paramLabel = "scene.jen", description = "The scenes; all in scenes/ where none is named.")
    private List<Path> scenes = List.of();
    @Option(names = {"-o", "--output"}, paramLabel = "DIR",
            description = "The folder for the results, made if it is not there; with --report the one of the results without it.")
    private Path folder;
    @Option(names = "--report", paramLabel = "RESULTS.json",
            description = "Makes the page of results that were kept, and measures nothing.")
    private Path storedResults;
    @Option(names = "--edits", description = "Edits and curves alone: no effects, no processes that begin cold, no large scenes.")
    private boolean editsOnly;
    @Option(names = "--quick",
            description = "A small selection: three of the scenes where none is named, at 640x480, each edit with one value.")
    private boolean quick;
    @Option(names = "--effects", description = "What each effect of the scenes takes, and nothing else but the first pass.")
    private boolean effects;
    @Option(names = "--cold", description = {"Whole processes that begin cold, in turns with POV-Ray's where it is installed, and nothing",
        "else but the first pass."})
    private boolean coldStart;
    @Option(names = "--editing",
            description = {"What editing costs with up to a million shapes and a thousand lights, below the editor's window,",
                "and nothing else."})
    private boolean editing;
    @Option(names = "--meshes",
            description = {"How fast rays are traced against meshes of up to ten million triangles, in turns with Embree where it is",
                "installed, and nothing else."})
    private boolean meshes;
    @Option(names = "--size", paramLabel = "WxH", converter = PictureDimensions.Converter.class,
            description = "Pixels, more than once for several sizes; 300x300 and 1920x1080 without it.")
    private List<PictureDimensions> sizes = List.of();
    @Option(names = "--baseline", paramLabel = "OLD.json",
            description = {"Prints what became slower (quartiles apart, and by more than 10 %%, also as a share of the full trace)",
                "or less accurate than these results."})
    private Path baseline;
    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "What everything random starts from; 1 without it.")
    private long seed;
    @Mixin
    private ThreadsOption threads;
    private PaperFigures.Subject figure;
    private Integer values;
    private Integer repetitions;
    private Integer processes;

    @Option(names = "--processes", paramLabel = "N",
            description = "How many processes that begin cold render each picture; 10 without it, 0 with --quick.")
    private void setProcesses(int value) {
        if (value < 0 || value > MAX_PROCESSES) {
            throw new ParameterException(command.commandLine(), "--processes must be from 0 to " + MAX_PROCESSES + ", was " + value);
        }
        processes = value;
    }

    @Option(names = "--figure", paramLabel = "N",
            description = {"The edits of one of the paper's figures alone, on its scene where none is named; B1 to B4 are the examples",
                "of its Appendix B (balls, spaceship, desk, house), B is all four."})
    private void setFigure(String value) {
        figure = PaperFigures.parse(value).orElseThrow(() -> new ParameterException(command.commandLine(),
                "--figure must be one that shows measured edits (" + PaperFigures.measuredRange() + "), was " + Quote.of(value)));
    }

    @Option(names = "--values", paramLabel = "N", description = "How many values each edit has; 3 without it, 1 with --quick.")
    private void setValues(int value) {
        if (value < 1 || value > PaperCases.VALUES) {
            throw new ParameterException(command.commandLine(),
                    "--values must be from 1 to " + PaperCases.VALUES + ", was " + value);
        }
        values = value;
    }

    @Option(names = "--repetitions", paramLabel = "N",
            description = "How many samples each work has; 5 without it, 3 with --quick. 1 is for a look: nothing is warmed up.")
    private void setRepetitions(int value) {
        repetitions = RepetitionsOption.requireValid(command, value);
    }

    BenchCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        if (storedResults != null) {
            return report();
        }
        if (folder == null) {
            throw new ParameterException(command.commandLine(), "Missing required option: '--output=DIR'");
        }
        BenchResults baselineResults = baseline == null ? null : ResultsFile.readJson(baseline);
        BenchScenes benchScenes = BenchScenes.read(scenes, figure != null ? figure.scenes() : quick ? QUICK_SCENES : List.of());
        benchScenes.problems().forEach(problem -> console.warn("%s", problem.what()));
        if (benchScenes.scenes().isEmpty()) {
            throw new BadInputException("there is no scene to measure");
        }
        Files.createDirectories(folder);
        BenchResults results = measure(benchScenes);
        console.print("%s: report.html, results.json, results.csv and pictures", folder);
        return exitCode(results, baselineResults, !benchScenes.problems().isEmpty());
    }

    /** Makes the page of kept results again. */
    private int report() throws IOException {
        if (!scenes.isEmpty()) {
            throw new ParameterException(command.commandLine(), "--report makes the page of " + storedResults + ", and measures no scene");
        }
        BenchResults results = ResultsFile.readJson(storedResults);
        Path resultsFolder = storedResults.toAbsolutePath().getParent();
        Path targetFolder = folder == null ? resultsFolder : folder;
        Files.createDirectories(targetFolder);
        HtmlReport.write(results, resultsFolder, targetFolder);
        console.print("%s", targetFolder.resolve(HtmlReport.FILE));
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
        if (values != null && settings.values() > 0) {
            settings = settings.withValues(values);
        }
        if (processes != null) {
            settings = settings.withProcesses(processes);
        }
        return repetitions == null ? settings : settings.withRepetitions(repetitions);
    }

    private BenchResults measure(BenchScenes benchScenes) throws IOException, InterruptedException {
        BenchTable table = new BenchTable(console);
        BenchOutput files = new BenchOutput(folder, reporter);
        try (ProgressBar bar = new ProgressBar(console, "bench")) {
            List<String> arguments = new ArrayList<>(command.commandLine().getParseResult().originalArgs());
            Harness harness = new Harness(settings(), benchScenes.scenes(), benchScenes.problems(), folder, arguments, bar);
            int count = benchScenes.scenes().size();
            console.print("%d scene%s; this will take about %s", count, count == 1 ? "" : "s", duration(harness.predictedSeconds()));
            try {
                BenchResults results = harness.run((_, until) -> {
                    bar.erase();
                    table.printNew(until);
                    files.writePeriodically(until);
                }, bar);
                files.write(results);
                bar.erase();
                table.printSummary(results);
                return results;
            } catch (CancellationException | InterruptedException | IOException e) {
                bar.erase();
                files.writeUninterruptibly(harness.results(false), () -> console.warn("%s: holds what was measured until now", folder));
                throw e;
            }
        }
    }

    private static String duration(double seconds) {
        return seconds < 2 * MINUTE ? Console.text("%.0f s", Math.ceil(seconds)) : Console.text("%.0f min", Math.ceil(seconds / MINUTE));
    }

    private int exitCode(BenchResults results, BenchResults baselineResults, boolean hasUnreadable) throws BadInputException {
        long failures = results.problems().stream().filter(problem -> problem.kind() == MeasurementFailure.Kind.BROKEN).count();
        if (baselineResults != null) {
            BaselineComparison compared = BaselineComparison.compare(baselineResults, results);
            if (compared.compared() == 0) {
                throw new BadInputException(baseline + ": holds none of the edits that were measured now");
            }
            compared.worse().forEach(line -> console.print("%s", line));
            console.print("baseline: %s compared, %d worse", Console.count(compared.compared(), "measurement"), compared.worse().size());
            failures += compared.worse().size();
        }
        return failures > 0 ? ExitCode.CHECK_FAILED : hasUnreadable ? ExitCode.BAD_INPUT : ExitCode.OK;
    }
}
