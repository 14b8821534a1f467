package lightning.bench.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SoftShadowAccuracy;

/** Named Markdown tables and lists of indirect light for documents, made from the results only. */
public final class IndirectTables {
    private final IndirectResults results;
    private final Map<String, Supplier<String>> tables = new LinkedHashMap<>();

    public IndirectTables(BenchResults results) {
        this.results = results.indirect();
        tables.put("indirect findings", () -> IndirectFindings.list(this.results));
        tables.put("indirect targets", () -> IndirectTargets.table(this.results));
        tables.put("indirect charts", () -> images("Error against time", this.results.accuracy().stream(), IndirectAccuracy::scene,
                IndirectDocumentCharts::fileName));
        tables.put("indirect errors", this::errors);
        tables.put("reflection charts", () -> images("Error of blurred reflections against time",
                this.results.reflections().stream().filter(scene -> !scene.points().isEmpty()), ReflectionAccuracy::scene,
                IndirectDocumentCharts::fileName));
        tables.put("reflection errors", this::reflections);
        tables.put("area light charts", () -> images("Error of area lights against time", this.results.softShadows().stream(),
                SoftShadowAccuracy::scene, IndirectDocumentCharts::fileName));
        tables.put("area light errors", this::softShadows);
        tables.put("indirect bounces chart",
                () -> this.results.accuracy().isEmpty() ? ""
                        : "![Missing light against bounces](pictures/" + IndirectDocumentCharts.BOUNCES + ")\n");
        tables.put("indirect bounces", this::bounces);
        tables.put("indirect first pass", this::firstPass);
        tables.put("indirect edits", this::edits);
        tables.put("indirect growth charts", () -> images("Time against", this.results.growth().stream(), IndirectGrowth::along,
                IndirectDocumentCharts::fileName));
        tables.put("indirect growth", this::growth);
        tables.put("indirect absence", this::absence);
    }

    /** Returns the names of all tables and lists. */
    public static List<String> names() {
        BenchResults none = new BenchResults(null, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        return List.copyOf(new IndirectTables(none).tables.keySet());
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

    private static <T> String images(String title, Stream<T> charts, java.util.function.Function<T, String> name,
            java.util.function.Function<T, String> file) {
        return charts.map(chart -> "![" + title + ", " + name.apply(chart) + "](pictures/" + file.apply(chart) + ")\n")
                .collect(Collectors.joining());
    }

    private String errors() {
        return MarkdownTables.table(
                List.of("scene", "spacing", "rays", "first pass ms", "gather points", "surfels", "mean error", "median", "95th percentile",
                        "bias", "Pareto"),
                results.accuracy().stream().flatMap(scene -> scene.grid().stream().map(p -> List.of(scene.scene(),
                        Integer.toString(p.spacing()), Integer.toString(p.rays()), MarkdownTables.median(p.time()),
                        Integer.toString(p.gatherPoints()), Integer.toString(p.surfels()), percent(p.error().mean()),
                        percent(p.error().median()), percent(p.error().high()), percent(p.error().bias()),
                        IndirectDocumentCharts.front(scene).contains(p) ? "yes" : ""))));
    }

    private String reflections() {
        return results.reflections().isEmpty() ? "" : MarkdownTables.table(
                List.of("scene", "pixels", "rays", "reflection points", "first pass ms", "mean error", "95th percentile", "bias",
                        "mean error of colors"),
                results.reflections().stream().flatMap(scene -> scene.points().stream().map(p -> List.of(scene.scene(),
                        Integer.toString(scene.pixels()), Integer.toString(p.rays()), Integer.toString(p.points()),
                        MarkdownTables.median(p.time()), percent(p.mean()), percent(p.high()), percent(p.bias()),
                        percent(p.shown())))));
    }

    private String softShadows() {
        return results.softShadows().isEmpty() ? "" : MarkdownTables.table(
                List.of("scene", "area lights", "samples", "first pass ms", "mean error", "95th percentile"),
                results.softShadows().stream().flatMap(scene -> scene.points().stream().map(p -> List.of(scene.scene(),
                        Integer.toString(scene.lights()), Integer.toString(p.samples()), MarkdownTables.median(p.time()),
                        percent(p.mean()), percent(p.high())))));
    }

    private String bounces() {
        return MarkdownTables.table(List.of("scene", "bounces", "first pass ms", "mean error", "missing light"),
                results.accuracy().stream().flatMap(scene -> scene.byBounces().stream().map(p -> List.of(scene.scene(),
                        Integer.toString(p.bounces()), MarkdownTables.median(p.time()), percent(p.error().mean()),
                        percent(p.error().missing())))));
    }

    private String firstPass() {
        return MarkdownTables.table(
                List.of("scene", "size", "lights", "first pass ms", "without ms", "added ms", "full trace ms", "gather points", "surfels",
                        "added bytes a pixel"),
                results.costs().stream().map(c -> List.of(c.scene(), c.width() + "×" + c.height(), Integer.toString(c.lights()),
                        MarkdownTables.median(c.first()), MarkdownTables.median(c.without()), MarkdownTables.number(c.extraMs()),
                        MarkdownTables.median(c.fullTrace()), Integer.toString(c.gatherPoints()), Integer.toString(c.surfels()),
                        MarkdownTables.number(c.bytesPerPixel()))));
    }

    private String edits() {
        return MarkdownTables.table(
                List.of("scene", "edit", "update ms", "without ms", "added ms", "saves of the first pass", "saves of a full trace",
                        "equal"),
                results.costs().stream().flatMap(c -> c.edits().stream().map(e -> List.of(c.scene(), e.edit().replace('-', ' '),
                        MarkdownTables.median(e.time()), MarkdownTables.median(e.without()), MarkdownTables.number(e.extraMs()),
                        saving(c, e, c.first().median()), saving(c, e, c.fullTrace() == null ? Double.NaN : c.fullTrace().median()),
                        e.equal() ? "yes" : "no"))));
    }

    private static String saving(IndirectCost cost, IndirectCost.Edit edit, double whole) {
        double saved = 1 - edit.time().median() / whole;
        return Double.isFinite(saved) ? percent(saved) : "–";
    }

    private String growth() {
        return MarkdownTables.table(
                List.of("along", "scene", "from", "to", "gather points", "surfels", "first pass, added ms", "slope", "moved light ms",
                        "slope", "intensity ms", "slope",
                        "added bytes a pixel"),
                results.growth().stream().filter(g -> !g.points().isEmpty()).map(g -> List.of(g.along(), g.scene(),
                        Long.toString(g.points().getFirst().at()), Long.toString(g.points().getLast().at()),
                        counts(g, IndirectGrowth.Point::gatherPoints), counts(g, IndirectGrowth.Point::surfels),
                        ends(g, IndirectGrowth.Point::extraMs), slope(g, IndirectGrowth.Point::extraMs),
                        ends(g, p -> p.position().median()), slope(g, p -> p.position().median()),
                        ends(g, p -> p.intensity().median()), slope(g, p -> p.intensity().median()),
                        ends(g, IndirectGrowth.Point::bytesPerPixel))));
    }

    private static String ends(IndirectGrowth growth, ToDoubleFunction<IndirectGrowth.Point> value) {
        return MarkdownTables.number(value.applyAsDouble(growth.points().getFirst())) + " to "
                + MarkdownTables.number(value.applyAsDouble(growth.points().getLast()));
    }

    private static String counts(IndirectGrowth growth, ToIntFunction<IndirectGrowth.Point> value) {
        return value.applyAsInt(growth.points().getFirst()) + " to " + value.applyAsInt(growth.points().getLast());
    }

    private static String slope(IndirectGrowth growth, ToDoubleFunction<IndirectGrowth.Point> value) {
        double slope = exponent(growth.points(), value);
        return Double.isFinite(slope) ? String.format(Locale.ROOT, "%.2f", slope) : "–";
    }

    private String absence() {
        return MarkdownTables.table(
                List.of("scene", "size", "bytes", "rays", "images equal", "first pass, absent ms", "hidden ms", "ratio"),
                results.absence().stream().map(a -> List.of(a.scene(), a.width() + "×" + a.height(), Long.toString(a.bytes()),
                        Long.toString(a.rays()), a.equal() ? "yes" : "no", MarkdownTables.median(a.absent()),
                        MarkdownTables.median(a.hidden()), String.format(Locale.ROOT, "%.3f", a.hidden().median() / a.absent().median()))));
    }

    /** Formats a share as percent. */
    static String percent(double share) {
        return Double.isFinite(share) ? String.format(Locale.ROOT, "%.1f %%", 100 * share) : "–";
    }

    /**
     * Returns the exponent of the power law that fits a value best, by least squares of the logarithms: 1 if it grows in proportion. NaN if
     * there are fewer than two points with positive values.
     */
    public static double exponent(List<IndirectGrowth.Point> points, ToDoubleFunction<IndirectGrowth.Point> value) {
        List<double[]> logs = points.stream().filter(p -> p.at() > 0 && value.applyAsDouble(p) > 0)
                .map(p -> new double[] {Math.log(p.at()), Math.log(value.applyAsDouble(p))}).toList();
        double x = logs.stream().mapToDouble(p -> p[0]).average().orElse(Double.NaN);
        double y = logs.stream().mapToDouble(p -> p[1]).average().orElse(Double.NaN);
        double covariance = logs.stream().mapToDouble(p -> (p[0] - x) * (p[1] - y)).sum();
        double variance = logs.stream().mapToDouble(p -> (p[0] - x) * (p[0] - x)).sum();
        return variance > 0 ? covariance / variance : Double.NaN;
    }
}
