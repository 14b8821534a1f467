package lightning.bench.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ColdStart;
import lightning.bench.result.ErrorPoint;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernScene;

/** Named Markdown tables and lists of the modern set for documents, made from the results only. */
public final class ModernTables {
    private final List<ModernScene> scenes;
    private final Map<String, Supplier<String>> tables = new LinkedHashMap<>();

    public ModernTables(BenchResults results) {
        scenes = results.modern();
        tables.put("modern findings", () -> ModernFindings.list(scenes));
        tables.put("modern first pass", this::firstPass);
        tables.put("modern savings", () -> edits(edit -> MarkdownTables.number(edit.saving())));
        tables.put("modern edit times", () -> edits(edit -> MarkdownTables.number(edit.time().median())));
        tables.put("modern cold", this::cold);
        tables.put("modern errors", this::errors);
        tables.put("modern equal errors", this::equalErrors);
        tables.put("modern charts", this::charts);
        tables.put("modern remarks", this::remarks);
    }

    /** Returns the names of all tables and lists. */
    public static List<String> names() {
        BenchResults none = new BenchResults(null, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        return List.copyOf(new ModernTables(none).tables.keySet());
    }

    /**
     * Returns a table or list whose lines end with line feeds.
     *
     * @throws IllegalArgumentException if there is none of that name
     */
    public String of(String name) {
        Supplier<String> table = tables.get(name);
        if (table == null) {
            throw new IllegalArgumentException("there is no table '" + name + "'");
        }
        return table.get();
    }

    private String firstPass() {
        return MarkdownTables.table(List.of("scene", "anti-aliasing", "size", "full trace ms", "first pass slower by %", "bytes a pixel"),
                rows(p -> p.firstPass() != null, (s, p) -> List.of(s.scene(), p.sampling().label(), size(p.width(), p.height()),
                        MarkdownTables.median(p.firstPass().fullTrace()), MarkdownTables.number(p.firstPass().percentSlower()),
                        MarkdownTables.number(p.firstPass().bytesPerPixel()))));
    }

    private Stream<List<String>> rows(Function<ModernPicture, Boolean> condition,
            BiFunction<ModernScene, ModernPicture, List<String>> row) {
        return scenes.stream().flatMap(s -> s.pictures().stream().filter(condition::apply).map(p -> row.apply(s, p)));
    }

    /** Returns a value per scene, anti-aliasing and kind of edit. */
    private String edits(Function<ModernEdit, String> value) {
        List<String> head = new ArrayList<>(List.of("scene", "anti-aliasing"));
        ModernCases.NAMES.forEach(name -> head.add(name.replace('-', ' ')));
        return MarkdownTables.table(head, rows(p -> !p.edits().isEmpty(), (s, p) -> {
            List<String> row = new ArrayList<>(List.of(s.scene(), p.sampling().label()));
            ModernCases.NAMES.forEach(name -> row.add(p.edits().stream().filter(edit -> edit.edit().equals(name)).map(value).findFirst()
                    .orElse("–")));
            return row;
        }));
    }

    private String cold() {
        return MarkdownTables.table(
                List.of("scene", "anti-aliasing", "size", "processes", "process ms", "processor ms", "POV-Ray's settings", "its process ms",
                        "its processor ms", "share"),
                rows(p -> p.cold() != null, (s, p) -> List.of(s.scene(), p.sampling().label(), size(p.coldWidth(), p.coldHeight()),
                        Integer.toString(p.cold().process().samples().size()), MarkdownTables.median(p.cold().process()),
                        MarkdownTables.median(p.cold().processor()), "`" + p.sampling().povRayLabel() + "`",
                        rival(p, r -> MarkdownTables.median(r.process())), rival(p, r -> MarkdownTables.median(r.processor())),
                        rival(p, r -> MarkdownTables.number(r.share())))));
    }

    private static String rival(ModernPicture picture, Function<ColdStart.Rival, String> value) {
        return picture.cold().rival() == null ? "–" : value.apply(picture.cold().rival());
    }

    private String errors() {
        return MarkdownTables.table(List.of("scene", "program", "setting", "ms", "error"),
                scenes.stream().flatMap(s -> s.curves().stream().flatMap(c -> c.points().stream().map(p -> List.of(s.scene(), c.program(),
                        code(p), MarkdownTables.median(p.time()), error(p.error()))))));
    }

    private String equalErrors() {
        return MarkdownTables.table(
                List.of("scene", "program", "setting", "error", "ms", "fastest setting of the other with at most that error", "its error",
                        "its ms", "Lightning is times as fast"),
                scenes.stream().flatMap(s -> EqualError.of(s).stream()).map(e -> List.of(e.scene(), e.program(), code(e.target()),
                        error(e.target().error()), MarkdownTables.median(e.target().time()),
                        e.other().map(ModernTables::code).orElse("none"),
                        e.other().map(p -> error(p.error())).orElse("–"), e.other().map(p -> MarkdownTables.median(p.time())).orElse("–"),
                        MarkdownTables.number(e.timesAsFast()))));
    }

    private static String code(ErrorPoint point) {
        return "`" + point.setting() + "`";
    }

    private static String error(double value) {
        return Double.isFinite(value) ? String.format(Locale.ROOT, "%.4f", value) : "–";
    }

    private String charts() {
        return scenes.stream().filter(s -> !s.curves().isEmpty())
                .map(s -> "![Time and error, " + s.scene() + "](pictures/" + ModernDocumentCharts.fileName(s) + ")\n")
                .collect(Collectors.joining());
    }

    /** Returns the remarks per scene, each with the number of lights or materials that it names. */
    private String remarks() {
        return MarkdownTables.table(List.of("scene", "not translated exactly", "times"), scenes.stream().flatMap(s -> {
            Map<String, Long> counts = s.losses().stream()
                    .collect(Collectors.groupingBy(ModernTables::withoutName, LinkedHashMap::new, Collectors.counting()));
            return counts.entrySet().stream().map(e -> List.of(s.scene(), e.getKey(), Long.toString(e.getValue())));
        }));
    }

    /** Removes the name from a remark, as in {@code light key: its barn doors are left out}. */
    private static String withoutName(String remark) {
        int end = remark.indexOf(": ");
        int kind = remark.indexOf(' ');
        return end < 0 || kind < 0 || kind > end ? remark : remark.substring(0, kind) + remark.substring(end);
    }

    private static String size(int width, int height) {
        return width + "×" + height;
    }
}
