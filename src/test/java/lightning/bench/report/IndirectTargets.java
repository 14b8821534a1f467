package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.IndirectResults;

/** Targets of indirect light at 1920×1080 pixels, with measured values. */
final class IndirectTargets {
    private static final String WINDOW = "window";
    private static final String HALL = "hall";
    private static final String NIGHT = "night";
    private static final String PIXELS = "pixels";
    private static final long FULL_HD = 1920L * 1080;
    private static final long ULTRA_HD = 3840L * 2160;

    private IndirectTargets() {}

    /** One target: its limit and the measured value in the same unit; NaN if not measured. */
    private record Target(String name, String scene, double limit, double measured, String unit) {
        private List<String> row() {
            return List.of(name, scene, number(limit) + unit, Double.isNaN(measured) ? "–" : number(measured) + unit,
                    Double.isNaN(measured) ? "–" : measured <= limit ? "yes" : "no");
        }

        private static String number(double v) {
            return v == Math.rint(v) ? String.format(Locale.ROOT, "%.0f", v) : MarkdownTables.number(v);
        }
    }

    /** Returns the table of all targets. */
    static String table(IndirectResults results) {
        List<Target> targets = new ArrayList<>();
        targets.add(new Target("first pass, added", WINDOW, 1500, cost(results, WINDOW).map(IndirectCost::extraMs).orElse(Double.NaN),
                " ms"));
        targets.add(new Target("first pass, added", HALL, 4000, cost(results, HALL).map(IndirectCost::extraMs).orElse(Double.NaN), " ms"));
        for (String scene : List.of(WINDOW, HALL, NIGHT)) {
            targets.add(new Target("color of a light, added", scene, 60, added(results, scene, ModernCases.COLOR), " ms"));
        }
        for (String scene : List.of(WINDOW, HALL, NIGHT)) {
            targets.add(new Target("moved light, added", scene, 100, added(results, scene, ModernCases.POSITION), " ms"));
        }
        for (String scene : List.of(WINDOW, HALL, NIGHT)) {
            targets.add(new Target("memory, added", scene, 45, cost(results, scene).map(IndirectCost::bytesPerPixel).orElse(Double.NaN),
                    " bytes a pixel"));
        }
        targets.add(new Target("color of a light, relative to `window`", NIGHT, 1.5,
                time(results, NIGHT, ModernCases.COLOR) / time(results, WINDOW, ModernCases.COLOR), " times"));
        targets.add(new Target("first pass at 3840×2160, relative to 1920×1080", "room", 3,
                first(results, ULTRA_HD) / first(results, FULL_HD), " times"));
        return MarkdownTables.table(List.of("target", "scene", "limit", "measured", "met"), targets.stream().map(Target::row));
    }

    private static Optional<IndirectCost> cost(IndirectResults results, String scene) {
        return results.costs().stream().filter(c -> c.scene().equals(scene) && (long) c.width() * c.height() == FULL_HD).findFirst();
    }

    private static double added(IndirectResults results, String scene, String edit) {
        return cost(results, scene).flatMap(c -> c.find(edit)).map(IndirectCost.Edit::extraMs).orElse(Double.NaN);
    }

    private static double time(IndirectResults results, String scene, String edit) {
        return cost(results, scene).flatMap(c -> c.find(edit)).map(e -> e.time().median()).orElse(Double.NaN);
    }

    private static double first(IndirectResults results, long pixels) {
        Stream<IndirectGrowth.Point> points =
                results.growth().stream().filter(g -> g.along().equals(PIXELS)).flatMap(g -> g.points().stream());
        return points.filter(p -> p.at() == pixels).map(p -> p.first().median()).findFirst().orElse(Double.NaN);
    }
}
