package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.ColdStart;
import lightning.bench.result.DriftCurve;
import lightning.bench.result.EditResult;
import lightning.bench.result.EffectResult;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.GrowthPoint;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.TimeSamples;
import lightning.render.measure.AccuracySetting;

/** Named Markdown tables of a run for documents, made from the results only. */
public final class MarkdownTables {
    private final BenchResults results;

    public MarkdownTables(BenchResults results) {
        this.results = results;
    }

    /** Returns the names of all tables. */
    public static List<String> names() {
        return List.of("scenes", "savings", "savings in short", "ladder", "previews", "composing", "drift", "growth", "editing", "meshes",
                "rays", "effects in use",
                "effects absent",
                "peer",
                "cold");
    }

    /**
     * Returns a table whose lines end with line feeds.
     *
     * @throws IllegalArgumentException if there is no table of that name
     */
    public String of(String name) {
        return switch (name) {
            case "scenes" -> scenes();
            case "savings" -> savings();
            case "savings in short" -> savingsSummary();
            case "ladder" -> accuracy();
            case "previews" -> previews();
            case "composing" -> floors();
            case "drift" -> drift();
            case "growth" -> growth();
            case "editing" -> editing();
            case "meshes" -> meshes();
            case "rays" -> rays();
            case "effects in use" -> effects(true);
            case "effects absent" -> effects(false);
            case "peer" -> peers();
            case "cold" -> cold();
            default -> throw new IllegalArgumentException("there is no table '" + name + "'");
        };
    }

    private String scenes() {
        return table(
                List.of("scene", "shapes", "lights", "full trace ms", "first pass slower by %", "bytes a pixel", "edits to break even"),
                largestScenes().map(s -> List.of(s.scene(), Integer.toString(s.shapes()), Integer.toString(s.lights()),
                        number(s.firstPass().fullTrace().median()), number(s.firstPass().percentSlower()),
                        number(s.firstPass().bytesPerPixel()), number(s.firstPass().editsToPayOff()))));
    }

    /** Returns the scenes at the largest size. */
    private Stream<SceneResult> largestScenes() {
        int maxWidth = results.scenes().stream().mapToInt(SceneResult::width).max().orElse(0);
        return results.scenes().stream().filter(s -> s.width() == maxWidth && s.firstPass() != null);
    }

    private String savings() {
        List<SceneResult> scenes = largestScenes().toList();
        List<String> head = new ArrayList<>(List.of("edit", "the paper"));
        scenes.forEach(s -> head.add(s.scene()));
        return table(head, edits(scenes).map(edit -> {
            List<String> row = new ArrayList<>(List.of(edit.edit(), number(edit.paperSaving())));
            scenes.forEach(s -> row.add(cell(s, edit.edit(), e -> number(e.saving()))));
            return row;
        }));
    }

    /** Edits of the summary table with their titles. */
    private static final Map<String, String> SUMMARY_EDITS = new LinkedHashMap<>();

    static {
        List.of("color", "intensity", "attenuation", "ambience", "angle-smaller", "angle-larger", "dropoff", "delete", "position",
                "direction",
                "type", "add").forEach(edit -> SUMMARY_EDITS.put(edit, edit.replace('-', ' ')));
        SUMMARY_EDITS.put("material-color", "a material's color");
        SUMMARY_EDITS.put("shininess", "shininess");
    }

    /** Returns savings of the default setting per edit, with its rays on the first scene. */
    private String savingsSummary() {
        List<SceneResult> scenes = largestScenes().toList();
        List<String> head = new ArrayList<>(List.of("edit"));
        scenes.forEach(s -> head.add("`" + s.scene() + "`, " + s.lights() + " lights: saves"));
        head.add("the paper, 1998");
        head.add("shadow rays (" + (scenes.isEmpty() ? "" : "`" + scenes.getFirst().scene() + "`") + ")");
        return table(head, edits(scenes).filter(edit -> SUMMARY_EDITS.containsKey(edit.edit()))
                .sorted(Comparator.comparingInt(edit -> List.copyOf(SUMMARY_EDITS.keySet()).indexOf(edit.edit()))).map(edit -> {
                    List<String> row = new ArrayList<>(List.of(SUMMARY_EDITS.get(edit.edit())));
                    scenes.forEach(s -> row.add(cell(s, edit.edit(), e -> percent(e.saving(), "%.1f"))));
                    row.add(percent(edit.paperSaving(), "%.0f"));
                    row.add(scenes.isEmpty() ? "–" : cell(scenes.getFirst(), edit.edit(), e -> e.first(AccuracySetting.DEFAULT)
                            .filter(point -> point.work() != null).map(point -> grouped(point.work().shadowRays())).orElse("–")));
                    return row;
                }));
    }

    static String percent(double value, String pattern) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, pattern, value) + " %";
    }

    private static String grouped(long value) {
        return String.format(Locale.ROOT, "%,d", value).replace(',', ' ');
    }

    /** Compares a composing edit and a ray-tracing edit with typical previews of other editors. */
    private String previews() {
        List<AccuracySetting> settings =
                List.of(AccuracySetting.HALF_RESOLUTION, AccuracySetting.FAST_SHADING, AccuracySetting.DEFAULT, AccuracySetting.FULL_TRACE);
        List<String> head = new ArrayList<>(List.of("scene", "edit"));
        settings.forEach(setting -> head.add(setting.label() + " ms"));
        return table(head,
                largestScenes().flatMap(s -> s.edits().stream().filter(e -> List.of("color", "position").contains(e.edit())).map(e -> {
                    List<String> row = new ArrayList<>(List.of(s.scene(), e.edit()));
                    settings.forEach(setting -> row.add(e.first(setting).map(point -> number(point.time().median())).orElse("–")));
                    return row;
                })));
    }

    /**
     * Returns a row per run with stored results.
     *
     * @param runs runs by part name
     */
    public static String runs(Map<String, BenchRun> runs) {
        return table(List.of("part", "began (UTC)", "minutes", "samples", "memory bandwidth GB/s", "load average before",
                "processor time of other processes %", "quiet"), runs.entrySet().stream().map(entry -> {
                    BenchRun run = entry.getValue();
                    return List.of(entry.getKey(), run.date(), number(run.actualSeconds() / 60), Integer.toString(run.repetitions()),
                            number(run.triadGBs()), number(run.load().atStart()), number(100 * run.load().others()),
                            run.load().isBusy(run.machine().processors()) ? "**no**" : "yes");
                }));
    }

    /** Returns each kind of edit once. */
    private static Stream<EditResult> edits(List<SceneResult> scenes) {
        return scenes.stream().flatMap(s -> s.edits().stream())
                .collect(Collectors.toMap(EditResult::edit, e -> e, (a, _) -> a, LinkedHashMap::new)).values().stream();
    }

    private static String cell(SceneResult scene, String edit, Function<EditResult, String> value) {
        return scene.edits().stream().filter(e -> e.edit().equals(edit)).map(value).findFirst().orElse("–");
    }

    private String accuracy() {
        return table(List.of("scene", "setting", "ms", "saves %", "worst RMSE", "worst ꟻLIP", "most values that differ %"),
                largestScenes()
                        .flatMap(s -> AccuracySummary.of(s).stream().map(l -> List.of(s.scene(), l.setting().label(), number(l.median()),
                                number(l.saving()), error(l.rmse()), error(l.flip()), number(l.percentDiffering())))));
    }

    private String floors() {
        return table(List.of("scene", "edit", "ms", "floor ms", "times the floor"), largestScenes().flatMap(s -> s.edits().stream()
                .filter(e -> List.of("color", "attenuation", "position").contains(e.edit()) && e.first(AccuracySetting.DEFAULT).isPresent())
                .map(e -> {
                    SweepPointResult exact = e.first(AccuracySetting.DEFAULT).orElseThrow();
                    return List.of(s.scene(), e.edit(), number(exact.time().median()), number(exact.work().floorMs()),
                            number(exact.work().timesFloor()));
                })));
    }

    private String drift() {
        return table(List.of("edits", "setting", "values that differ", "largest ulp", "largest difference", "bound", "refreshes"),
                results.drift().stream().map(DriftCurve::points).flatMap(List::stream).map(p -> List.of(Integer.toString(p.edits()),
                        p.accuracy().name().toLowerCase(Locale.ROOT), Long.toString(p.error().values()), Long.toString(p.error().maxUlp()),
                        error(p.error().maxAbsolute()), error(p.bound()), Integer.toString(p.refreshes()))));
    }

    private String growth() {
        return table(List.of("along", "at", "full trace ms", "color ms", "position ms"),
                results.growth().stream().flatMap(g -> g.points().stream().map(p -> List.of(g.along(), Long.toString(p.at()),
                        number(p.fullTrace().median()), edit(g, p, "color"), edit(g, p, "position")))));
    }

    private static String edit(GrowthCurve growth, GrowthPoint point, String edit) {
        return point.edits().stream().filter(e -> e.edit().equals(edit)).map(e -> number(e.time().median())).findFirst().orElse("–");
    }

    private String editing() {
        return table(List.of("shapes", "lights", "load ms", "tree ms", "new scene ms", "plan ms", "first hover ms",
                "document, bytes a shape", "primitives and tree, bytes a shape"),
                results.editing().stream().map(e -> List.of(Integer.toString(e.shapes()), Integer.toString(e.lights()), median(e.load()),
                        median(e.tree()), median(e.newScene()), median(e.plan()), median(e.hover()), number(e.documentBytes()),
                        number(e.treeBytes()))));
    }

    private String meshes() {
        return table(List.of("triangles", "tree ms", "Embree's ms", "tree, bytes a triangle", "Embree's", "mesh, bytes a triangle"),
                results.meshes().stream().map(m -> List.of(Integer.toString(m.triangles()), median(m.tree()),
                        m.rival() == null ? "–" : median(m.rival().tree()), number(m.treeBytes()),
                        m.rival() == null ? "–" : number(m.rival().treeBytes()), number(m.meshBytes()))));
    }

    private String rays() {
        return table(List.of("triangles", "rays", "million rays a second", "Embree's", "share %"),
                results.meshes().stream().flatMap(m -> m.rays().stream().map(pace -> List.of(Integer.toString(m.triangles()), pace.rays(),
                        number(pace.millionsPerSecond()), pace.rival() == null ? "–" : number(pace.rivalMillionsPerSecond()),
                        pace.rival() == null ? "–" : number(pace.share())))));
    }

    private String effects(boolean inUse) {
        return table(List.of("scene", "effect", "first pass ms", "± ms", "moved light ms", "MB", "million rays"),
                largestScenes().flatMap(s -> s.effects().stream().filter(e -> e.inUse() == inUse).map(e -> row(s, e))));
    }

    private static List<String> row(SceneResult scene, EffectResult e) {
        return List.of(scene.scene(), e.effect(), number(e.certainFirstMs()), number(e.noiseMs()), number(e.certainUpdateMs()),
                number(e.bytes() / 1e6),
                number(e.rays() / 1e6));
    }

    private String peers() {
        return table(List.of("scene", "program", "its ms", "full trace ms", "times as fast", "pixels that agree %"),
                largestScenes().filter(s -> s.peer() != null)
                        .map(s -> List.of(s.scene(), s.peer().program(), number(s.peer().time().median()),
                                number(s.peer().fullTrace().median()), number(s.peer().ratio()), number(100 * s.peer().agreement()))));
    }

    private String cold() {
        return table(List.of("scene", "size", "process ms", "processor ms", "program", "its process ms", "its processor ms", "share",
                "warm full trace ms"),
                results.scenes().stream().filter(s -> s.cold() != null).map(s -> List.of(s.scene(), s.width() + "×" + s.height(),
                        median(s.cold().process()), median(s.cold().processor()), rival(s, ColdStart.Rival::program),
                        rival(s, r -> median(r.process())), rival(s, r -> median(r.processor())), rival(s, r -> number(r.share())),
                        s.firstPass() == null ? "–" : median(s.firstPass().fullTrace()))));
    }

    private static String rival(SceneResult scene, Function<ColdStart.Rival, String> value) {
        return scene.cold().rival() == null ? "–" : value.apply(scene.cold().rival());
    }

    static String median(TimeSamples samples) {
        return samples == null ? "–" : number(samples.median());
    }

    /** Formats three digits without exponent. */
    static String number(double v) {
        if (Double.isNaN(v)) {
            return "–";
        }
        double size = Math.abs(v);
        return String.format(Locale.ROOT, size >= 99.95 ? "%.0f" : size >= 9.995 ? "%.1f" : "%.2f", v);
    }

    /** Formats two digits with exponent; 0 for no error. */
    static String error(double v) {
        return v == 0 ? "0" : Double.isNaN(v) ? "–" : String.format(Locale.ROOT, "%.1e", v);
    }

    static String table(List<String> head, Stream<List<String>> rows) {
        String rule = "|" + "---|".repeat(head.size()) + "\n";
        return line(head) + rule + rows.map(MarkdownTables::line).collect(Collectors.joining());
    }

    private static String line(List<String> cells) {
        return "| " + String.join(" | ", cells) + " |\n";
    }
}
