package lightning.bench.report;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.EditResult;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.MachineSpec;
import lightning.bench.result.MeshPoint;
import lightning.bench.result.SceneResult;
import lightning.bench.result.ValueResult;
import lightning.render.measure.AccuracySetting;

/** Named phrases with measured values for documents, made from results only. */
public final class ReportStatements {
    private static final String NONE = "–";
    private static final List<String> RECOLORED = List.of("color");
    private static final List<String> MOVED = List.of("position");
    private static final int PAPER_SIZE = 300;

    private final List<SceneResult> scenes;
    private final Map<String, Supplier<String>> statements = new LinkedHashMap<>();

    /**
     * @param figures results of edits
     * @param cold    results of cold-start processes
     * @param meshes  results of ray throughput on meshes
     */
    public ReportStatements(BenchResults figures, BenchResults cold, BenchResults meshes) {
        scenes = figures.scenes().stream().filter(s -> s.firstPass() != null && !s.edits().isEmpty()).toList();
        statements.put("build", () -> build(figures.run()));
        statements.put("equal pictures", this::equalPictures);
        statements.put("scenes", () -> scenes.stream().map(s -> "`" + s.scene() + "`").collect(Collectors.joining(", ")));
        statements.put("size", () -> scenes.stream().map(s -> s.width() + "×" + s.height()).distinct().collect(Collectors.joining(", ")));
        statements.put("threads", () -> Integer.toString(figures.run().threads()));
        statements.put("peer pace", () -> range("%.1f", scenes.stream().filter(s -> s.peer() != null).map(s -> s.peer().ratio())));
        statements.put("first pass", () -> range("%.1f", scenes.stream().map(s -> s.firstPass().percentSlower())) + " %");
        statements.put("bytes a row", () -> range("%.0f", scenes.stream().map(s -> s.firstPass().bytesPerRow())));
        statements.put("rays a second", () -> range("%.0f", scenes.stream().map(s -> raysPerSecond(s.firstPass()) / 1e6)) + " million");
        statements.put("moved cap", () -> scene("bird", s -> caps(s, MOVED) + " %"));
        statements.put("color cap", () -> range("%.0f", scenes.stream().flatMap(s -> edits(s, RECOLORED)).map(EditResult::cap)) + " %");
        statements.put("color over floor", () -> range("%.1f", scenes.stream().flatMap(s -> edits(s, RECOLORED))
                .flatMap(e -> e.first(AccuracySetting.DEFAULT).stream()).map(r -> r.work().timesFloor())));
        statements.put("stale values",
                () -> range("%.1f",
                        scenes.stream().flatMap(s -> summaries(s, AccuracySetting.EXACT)).map(AccuracySummary::percentDiffering))
                        + " %");
        statements.put("median savings", () -> each(s -> percent(summary(s, AccuracySetting.DEFAULT))));
        statements.put("median savings, mirrors as they were", () -> each(s -> percent(summary(s, AccuracySetting.EXACT))));
        statements.put("recolored light", () -> previews(RECOLORED));
        statements.put("moved light", () -> previews(MOVED));
        statements.put("cold share",
                () -> coldShares(cold, s -> s.width() == PAPER_SIZE) + " at 300×300 and " + coldShares(cold, s -> s.width() > PAPER_SIZE)
                        + " at 1920×1080");
        statements.put("eye rays beside Embree", () -> embree(meshes, "eye"));
        statements.put("shadow rays beside Embree", () -> embree(meshes, "shadow"));
        statements.put("mirrored rays beside Embree", () -> embree(meshes, "mirrored"));
    }

    /** Returns the names of all statements. */
    public static List<String> names() {
        BenchResults none = new BenchResults(null, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        return List.copyOf(new ReportStatements(none, none, none).statements.keySet());
    }

    /**
     * Returns a phrase without line ends.
     *
     * @throws IllegalArgumentException if there is none of that name
     * @throws IllegalStateException    if it is false for the results
     */
    public String of(String name) {
        Supplier<String> statement = statements.get(name);
        if (statement == null) {
            throw new IllegalArgumentException("there is no statement '" + name + "'");
        }
        return statement.get();
    }

    private static String build(BenchRun run) {
        MachineSpec machine = run.machine();
        return String.format(Locale.ROOT, "build `%s`, measured on %s with %d processors (%s, %d-bit vectors), %.0f GB of memory, %s, %s",
                run.commit(), run.date().replaceFirst("T.*", ""), machine.processors(), machine.processor(), machine.vectorBits(),
                machine.memoryBytes() / 1e9, machine.system(), machine.java())
                + (run.load().isBusy(machine.processors()) ? ", **while other work held the processors, so that its times say little**"
                        : "");
    }

    /** Returns the statement for the default setting; a single differing image makes it false. */
    private String equalPictures() {
        long all = 0;
        for (SceneResult scene : scenes) {
            for (EditResult edit : scene.edits()) {
                for (ValueResult value : edit.values()) {
                    if (value.find(AccuracySetting.DEFAULT).map(point -> point.error().values() != 0).orElse(true)) {
                        throw new IllegalStateException(
                                scene.scene() + ", " + edit.edit() + ", " + value.value() + ": the picture of grade "
                                        + AccuracySetting.DEFAULT.label() + " is not equal to the full trace");
                    }
                    all++;
                }
            }
        }
        return "all " + all + " were equal to a full trace in every bit";
    }

    private static double raysPerSecond(FirstPassResult first) {
        return 1e3 * first.fullRays() / first.fullTrace().median();
    }

    private static String caps(SceneResult scene, List<String> edits) {
        return range("%.0f", edits(scene, edits).map(EditResult::cap));
    }

    private static Stream<EditResult> edits(SceneResult scene, List<String> names) {
        return scene.edits().stream().filter(e -> names.contains(e.edit()));
    }

    private static Stream<AccuracySummary> summaries(SceneResult scene, AccuracySetting setting) {
        return AccuracySummary.of(scene).stream().filter(summary -> summary.setting() == setting);
    }

    private static double summary(SceneResult scene, AccuracySetting setting) {
        return summaries(scene, setting).mapToDouble(AccuracySummary::saving).findFirst().orElse(Double.NaN);
    }

    /** Returns times of a kind of edit at the default setting, and of typical previews of other editors. */
    private String previews(List<String> edits) {
        return each(
                s -> time(s, edits, AccuracySetting.DEFAULT) + " ms (half the resolution " + time(s, edits, AccuracySetting.HALF_RESOLUTION)
                        + ", no shadows and mirrors " + time(s, edits, AccuracySetting.FAST_SHADING) + ")");
    }

    private static String time(SceneResult scene, List<String> edits, AccuracySetting setting) {
        return format("%.1f", edits(scene, edits).flatMap(e -> e.first(setting).stream()).mapToDouble(r -> r.time().median()).average()
                .orElse(Double.NaN));
    }

    private static String coldShares(BenchResults cold, java.util.function.Predicate<SceneResult> condition) {
        return range("%.2f", cold.scenes().stream().filter(s -> s.cold() != null && s.cold().rival() != null).filter(condition)
                .map(s -> s.cold().rival().share()));
    }

    private static String embree(BenchResults meshes, String rays) {
        ToDoubleFunction<MeshPoint> share =
                m -> m.rays().stream().filter(pace -> pace.rays().equals(rays) && pace.rival() != null).mapToDouble(pace -> pace.share())
                        .findFirst().orElse(Double.NaN);
        return range("%.0f", meshes.meshes().stream().map(share::applyAsDouble)) + " %";
    }

    private String scene(String name, Function<SceneResult, String> statement) {
        return scenes.stream().filter(s -> s.scene().equals(name)).map(statement).findFirst().orElse(NONE);
    }

    private String each(Function<SceneResult, String> statement) {
        List<String> parts = new ArrayList<>(scenes.stream().map(s -> statement.apply(s) + " on `" + s.scene() + "`").toList());
        return parts.isEmpty() ? NONE : parts.size() == 1 ? parts.getFirst()
                : String.join(", ", parts.subList(0, parts.size() - 1)) + " and " + parts.getLast();
    }

    private static String percent(double value) {
        return Double.isNaN(value) ? NONE : format("%.0f", value) + " %";
    }

    /** Returns minimum and maximum, or one number if both have the same text. */
    static String range(String pattern, Stream<Double> values) {
        DoubleSummaryStatistics all = values.filter(Double::isFinite).mapToDouble(v -> v).summaryStatistics();
        if (all.getCount() == 0) {
            return NONE;
        }
        String minText = format(pattern, all.getMin());
        String maxText = format(pattern, all.getMax());
        return minText.equals(maxText) ? minText : minText + " to " + maxText;
    }

    private static String format(String pattern, double value) {
        return Double.isNaN(value) ? NONE : String.format(Locale.ROOT, pattern, value);
    }
}
