package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import lightning.bench.Drift;
import lightning.bench.DriftPoint;
import lightning.bench.Growth;
import lightning.bench.GrowthPoint;
import lightning.bench.Results;
import lightning.render.relight.plan.Accuracy;

/** What becomes of pictures after many edits, and how times grow. */
final class CurveSections {
    private static final int WIDTH = 560;
    private static final int HEIGHT = 320;
    /** Where there are many edits: one of each kind of update. */
    private static final List<String> TYPICAL = List.of("color", "position", "attenuation", "angle-larger", "add",
            "mirrors updated after position");

    private CurveSections() {}

    static void write(Markup page, Results results) {
        if (!results.drift().isEmpty()) {
            page.open("section", "id", "drift");
            page.leaf("h2", "Drift");
            page.leaf("p", "After many edits in a row, how far is a picture from a full trace? Grade exact starts from the stored rows "
                    + "each time; grade ratio multiplies what it has, knows a bound of its error, and computes anew before that could show.",
                    "class", "lead");
            page.open("div", "class", "charts");
            results.drift().forEach(drift -> drift(page, drift));
            page.close().close();
        }
        if (!results.growth().isEmpty()) {
            page.open("section", "id", "growth");
            page.leaf("h2", "Growth");
            page.open("div", "class", "charts");
            results.growth().forEach(growth -> growth(page, growth));
            page.close().close();
        }
    }

    private static void drift(Markup page, Drift drift) {
        List<CurveChart.Curve> curves = new ArrayList<>();
        for (Accuracy accuracy : Accuracy.values()) {
            String name = accuracy.name().toLowerCase(Locale.ROOT);
            Ink ink = Ink.of(accuracy);
            curves.add(curve(name, ink, false, drift, accuracy, p -> p.error().maxAbsolute()));
            if (!accuracy.isExact()) {
                curves.add(curve(name + ", its bound", ink, true, drift, accuracy, DriftPoint::bound));
            }
        }
        int refreshes = drift.points().stream().mapToInt(DriftPoint::refreshes).max().orElse(0);
        SceneSection.figure(page, drift.scene() + ", " + drift.width() + " × " + drift.height(),
                "Largest difference of any value (linear) against the number of edits. Grade ratio "
                        + (refreshes == 0 ? "never had to compute anew." : "computed anew " + refreshes + " times."),
                CurveChart.svg("Error after many edits", curves, WIDTH, HEIGHT, Numbers::tick,
                        at -> Numbers.power((int) Math.round(Math.log10(at)))));
    }

    private static CurveChart.Curve curve(String name, Ink ink, boolean dashed, Drift drift, Accuracy accuracy,
            ToDoubleFunction<DriftPoint> value) {
        return new CurveChart.Curve(name, ink, dashed, points(drift.points().stream().filter(p -> p.accuracy() == accuracy)
                .map(p -> new double[] {p.edits(), value.applyAsDouble(p)})));
    }

    private static void growth(Markup page, Growth growth) {
        SceneSection.figure(page, "With " + growth.along(), "Time (ms) against " + growth.along() + "; " + growth.scene() + "."
                + (hasFewEdits(growth) ? "" : " Grey: the other edits."), growth(growth));
    }

    private static boolean hasFewEdits(Growth growth) {
        return edits(growth).count() <= TYPICAL.size();
    }

    private static Stream<String> edits(Growth growth) {
        return growth.points().stream().flatMap(p -> p.edits().stream()).map(GrowthPoint.EditTime::edit).distinct();
    }

    /** The chart of one curve. */
    static String growth(Growth growth) {
        List<CurveChart.Curve> curves = new ArrayList<>();
        curves.add(new CurveChart.Curve("full trace", Ink.TEXT, false,
                points(growth.points().stream().map(p -> new double[] {p.at(), p.fullTrace().median()}))));
        List<String> edits = edits(growth).sorted(Comparator.comparing(TYPICAL::contains)).toList();
        boolean few = hasFewEdits(growth);
        for (String edit : edits) {
            boolean named = few || TYPICAL.contains(edit);
            Ink ink = few ? Ink.of(edits.indexOf(edit)) : named ? Ink.of(TYPICAL.indexOf(edit)) : Ink.PAPER;
            curves.add(new CurveChart.Curve(named ? edit : "", ink, false, points(growth.points().stream().flatMap(p -> p.edits().stream()
                    .filter(e -> e.edit().equals(edit)).map(e -> new double[] {p.at(), e.time().median()})))));
        }
        return CurveChart.svg("Time against " + growth.along(), curves, WIDTH, HEIGHT, Numbers::tick, Numbers::tick);
    }

    /** Those that a chart can show. */
    private static List<double[]> points(Stream<double[]> points) {
        return points.filter(p -> Charts.plausibleOrZero(p[0]) && Charts.plausibleOrZero(p[1])).toList();
    }
}
