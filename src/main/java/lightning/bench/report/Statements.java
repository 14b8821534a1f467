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
import lightning.bench.EditResult;
import lightning.bench.FirstPass;
import lightning.bench.Machine;
import lightning.bench.MeshPoint;
import lightning.bench.Results;
import lightning.bench.Run;
import lightning.bench.SceneResult;
import lightning.bench.ValueResult;
import lightning.bench.accuracy.Grade;

/** Parts of sentences that say what was measured, for documents: each is named, and made from results alone. */
public final class Statements {
    private static final String NONE = "–";
    private static final List<String> RECOLORED = List.of("color");
    private static final List<String> MOVED = List.of("position");
    private static final int PAPER_SIZE = 300;

    private final List<SceneResult> scenes;
    private final Map<String, Supplier<String>> made = new LinkedHashMap<>();

    /**
     * @param figures results of edits
     * @param cold    results of processes that begin cold
     * @param meshes  results of rays against meshes
     */
    public Statements(Results figures, Results cold, Results meshes) {
        scenes = figures.scenes().stream().filter(s -> s.firstPass() != null && !s.edits().isEmpty()).toList();
        made.put("build", () -> build(figures.run()));
        made.put("equal pictures", this::equalPictures);
        made.put("scenes", () -> scenes.stream().map(s -> "`" + s.scene() + "`").collect(Collectors.joining(", ")));
        made.put("size", () -> scenes.stream().map(s -> s.width() + "×" + s.height()).distinct().collect(Collectors.joining(", ")));
        made.put("threads", () -> Integer.toString(figures.run().threads()));
        made.put("peer pace", () -> range("%.1f", scenes.stream().filter(s -> s.peer() != null).map(s -> s.peer().ratio())));
        made.put("first pass", () -> range("%.1f", scenes.stream().map(s -> s.firstPass().percentSlower())) + " %");
        made.put("bytes a row", () -> range("%.0f", scenes.stream().map(s -> s.firstPass().bytesPerRow())));
        made.put("rays a second", () -> range("%.0f", scenes.stream().map(s -> raysPerSecond(s.firstPass()) / 1e6)) + " million");
        made.put("moved cap", () -> scene("bird", s -> caps(s, MOVED) + " %"));
        made.put("color cap", () -> range("%.0f", scenes.stream().flatMap(s -> edits(s, RECOLORED)).map(EditResult::cap)) + " %");
        made.put("color over floor", () -> range("%.1f", scenes.stream().flatMap(s -> edits(s, RECOLORED))
                .flatMap(e -> e.first(Grade.DEFAULT).stream()).map(r -> r.work().timesFloor())));
        made.put("stale values",
                () -> range("%.1f", scenes.stream().flatMap(s -> grade(s, Grade.EXACT)).map(GradeSummary::percentDiffering))
                        + " %");
        made.put("median savings", () -> each(s -> percent(summary(s, Grade.DEFAULT))));
        made.put("median savings, mirrors as they were", () -> each(s -> percent(summary(s, Grade.EXACT))));
        made.put("recolored light", () -> previews(RECOLORED));
        made.put("moved light", () -> previews(MOVED));
        made.put("cold share",
                () -> colds(cold, s -> s.width() == PAPER_SIZE) + " at 300×300 and " + colds(cold, s -> s.width() > PAPER_SIZE)
                        + " at 1920×1080");
        made.put("eye rays beside Embree", () -> embree(meshes, "eye"));
        made.put("shadow rays beside Embree", () -> embree(meshes, "shadow"));
        made.put("mirrored rays beside Embree", () -> embree(meshes, "mirrored"));
    }

    /** The names of all statements. */
    public static List<String> names() {
        Results none = new Results(null, List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        return List.copyOf(new Statements(none, none, none).made.keySet());
    }

    /**
     * A part of a sentence, without line ends.
     *
     * @throws IllegalArgumentException if there is none of that name
     * @throws IllegalStateException    if the results say that it is not true
     */
    public String of(String name) {
        Supplier<String> statement = made.get(name);
        if (statement == null) {
            throw new IllegalArgumentException("there is no statement '" + name + "'");
        }
        return statement.get();
    }

    private static String build(Run run) {
        Machine machine = run.machine();
        return String.format(Locale.ROOT, "build `%s`, measured on %s with %d processors (%s, %d-bit vectors), %.0f GB of memory, %s, %s",
                run.commit(), run.date().replaceFirst("T.*", ""), machine.processors(), machine.processor(), machine.vectorBits(),
                machine.memoryBytes() / 1e9, machine.system(), machine.java())
                + (run.load().isBusy(machine.processors()) ? ", **while other work held the processors, so that its times say little**"
                        : "");
    }

    /** Of the default grade: one picture that differs makes it untrue. */
    private String equalPictures() {
        long all = 0;
        for (SceneResult scene : scenes) {
            for (EditResult edit : scene.edits()) {
                for (ValueResult value : edit.values()) {
                    if (value.find(Grade.DEFAULT).map(rung -> rung.error().values() != 0).orElse(true)) {
                        throw new IllegalStateException(
                                scene.scene() + ", " + edit.edit() + ", " + value.value() + ": the picture of grade "
                                        + Grade.DEFAULT.label() + " is not equal to the full trace");
                    }
                    all++;
                }
            }
        }
        return "all " + all + " were equal to a full trace in every bit";
    }

    private static double raysPerSecond(FirstPass first) {
        return 1e3 * first.fullRays() / first.fullTrace().median();
    }

    private static String caps(SceneResult scene, List<String> edits) {
        return range("%.0f", edits(scene, edits).map(EditResult::cap));
    }

    private static Stream<EditResult> edits(SceneResult scene, List<String> names) {
        return scene.edits().stream().filter(e -> names.contains(e.edit()));
    }

    private static Stream<GradeSummary> grade(SceneResult scene, Grade grade) {
        return GradeSummary.of(scene).stream().filter(summary -> summary.grade() == grade);
    }

    private static double summary(SceneResult scene, Grade grade) {
        return grade(scene, grade).mapToDouble(GradeSummary::saving).findFirst().orElse(Double.NaN);
    }

    /** What a kind of edit takes at the default grade, and by what other editors offer while a light is dragged. */
    private String previews(List<String> edits) {
        return each(s -> time(s, edits, Grade.DEFAULT) + " ms (half the resolution " + time(s, edits, Grade.HALF_RESOLUTION)
                + ", no shadows and mirrors " + time(s, edits, Grade.FAST_SHADING) + ")");
    }

    private static String time(SceneResult scene, List<String> edits, Grade grade) {
        return format("%.1f", edits(scene, edits).flatMap(e -> e.first(grade).stream()).mapToDouble(r -> r.time().median()).average()
                .orElse(Double.NaN));
    }

    private static String colds(Results cold, java.util.function.Predicate<SceneResult> which) {
        return range("%.2f", cold.scenes().stream().filter(s -> s.cold() != null && s.cold().rival() != null).filter(which)
                .map(s -> s.cold().rival().share()));
    }

    private static String embree(Results meshes, String rays) {
        ToDoubleFunction<MeshPoint> share =
                m -> m.rays().stream().filter(pace -> pace.rays().equals(rays) && pace.rival() != null).mapToDouble(pace -> pace.share())
                        .findFirst().orElse(Double.NaN);
        return range("%.0f", meshes.meshes().stream().map(share::applyAsDouble)) + " %";
    }

    private String scene(String name, Function<SceneResult, String> what) {
        return scenes.stream().filter(s -> s.scene().equals(name)).map(what).findFirst().orElse(NONE);
    }

    private String each(Function<SceneResult, String> what) {
        List<String> parts = new ArrayList<>(scenes.stream().map(s -> what.apply(s) + " on `" + s.scene() + "`").toList());
        return parts.isEmpty() ? NONE : parts.size() == 1 ? parts.getFirst()
                : String.join(", ", parts.subList(0, parts.size() - 1)) + " and " + parts.getLast();
    }

    private static String percent(double value) {
        return Double.isNaN(value) ? NONE : format("%.0f", value) + " %";
    }

    /** The least and the largest; one number where they are written alike. */
    private static String range(String pattern, Stream<Double> values) {
        DoubleSummaryStatistics all = values.filter(Double::isFinite).mapToDouble(v -> v).summaryStatistics();
        if (all.getCount() == 0) {
            return NONE;
        }
        String least = format(pattern, all.getMin());
        String most = format(pattern, all.getMax());
        return least.equals(most) ? least : least + " to " + most;
    }

    private static String format(String pattern, double value) {
        return Double.isNaN(value) ? NONE : String.format(Locale.ROOT, pattern, value);
    }
}
