package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.DriftCurve;
import lightning.bench.result.DriftPoint;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.GrowthPoint;
import lightning.render.relight.paper.Accuracy;

/** Report sections of image drift and growth of times. */
final class CurveSections {
    private static final int WIDTH = 560;
    private static final int HEIGHT = 320;
    /** Edits to highlight among many: one per kind of update. */
    private static final List<String> TYPICAL_EDITS = List.of("color", "position", "attenuation", "angle-larger", "add",
            "mirrors updated after position");

    private CurveSections() {}

    static void write(HtmlWriter page, BenchResults results) {
        if (!results.drift().isEmpty()) {
            page.open("section", "id", "drift");
            page.element("h2", "Drift");
            page.element("p", "Error against a full trace after many edits in a row. Setting exact recomputes from the stored rows "
                    + "each time. Setting ratio multiplies stored values, tracks an error bound, and recomputes before an error is "
                    + "visible.",
                    "class", "lead");
            page.open("div", "class", "charts");
            results.drift().forEach(drift -> drift(page, drift));
            page.close().close();
        }
        if (!results.growth().isEmpty()) {
            page.open("section", "id", "growth");
            page.element("h2", "Growth");
            page.open("div", "class", "charts");
            results.growth().forEach(growth -> growth(page, growth));
            page.close().close();
        }
    }

    private static void drift(HtmlWriter page, DriftCurve drift) {
        List<CurveChart.Curve> curves = new ArrayList<>();
        for (Accuracy accuracy : Accuracy.values()) {
            String name = accuracy.name().toLowerCase(Locale.ROOT);
            PlotColor ink = PlotColor.of(accuracy);
            curves.add(curve(name, ink, false, drift, accuracy, p -> p.error().maxAbsolute()));
            if (!accuracy.isExact()) {
                curves.add(curve(name + ", bound", ink, true, drift, accuracy, DriftPoint::bound));
            }
        }
        int refreshes = drift.points().stream().mapToInt(DriftPoint::refreshes).max().orElse(0);
        SceneSection.figure(page, drift.scene() + ", " + drift.width() + " × " + drift.height(),
                "Maximum difference of any value (linear) against the number of edits. Setting ratio "
                        + (refreshes == 0 ? "never had to recompute." : "recomputed " + refreshes + " times."),
                CurveChart.svg("Error after many edits", curves, WIDTH, HEIGHT, NumberText::tick,
                        at -> NumberText.power((int) Math.round(Math.log10(at)))));
    }

    private static CurveChart.Curve curve(String name, PlotColor ink, boolean dashed, DriftCurve drift, Accuracy accuracy,
            ToDoubleFunction<DriftPoint> value) {
        return new CurveChart.Curve(name, ink, dashed, points(drift.points().stream().filter(p -> p.accuracy() == accuracy)
                .map(p -> new double[] {p.edits(), value.applyAsDouble(p)})));
    }

    private static void growth(HtmlWriter page, GrowthCurve growth) {
        SceneSection.figure(page, "Growth with " + growth.along(), "Time (ms) against " + growth.along() + "; " + growth.scene() + "."
                + (hasFewEdits(growth) ? "" : " Gray: the other edits."), growth(growth));
    }

    private static boolean hasFewEdits(GrowthCurve growth) {
        return edits(growth).count() <= TYPICAL_EDITS.size();
    }

    private static Stream<String> edits(GrowthCurve growth) {
        return growth.points().stream().flatMap(p -> p.edits().stream()).map(GrowthPoint.EditTime::edit).distinct();
    }

    /** Returns the chart of one curve. */
    static String growth(GrowthCurve growth) {
        List<CurveChart.Curve> curves = new ArrayList<>();
        curves.add(new CurveChart.Curve("full trace", PlotColor.TEXT, false,
                points(growth.points().stream().map(p -> new double[] {p.at(), p.fullTrace().median()}))));
        List<String> edits = edits(growth).sorted(Comparator.comparing(TYPICAL_EDITS::contains)).toList();
        boolean showsAll = hasFewEdits(growth);
        for (String edit : edits) {
            boolean isNamed = showsAll || TYPICAL_EDITS.contains(edit);
            PlotColor ink =
                    showsAll ? PlotColor.of(edits.indexOf(edit)) : isNamed ? PlotColor.of(TYPICAL_EDITS.indexOf(edit)) : PlotColor.PAPER;
            curves.add(new CurveChart.Curve(isNamed ? edit : "", ink, false, points(growth.points().stream().flatMap(p -> p.edits().stream()
                    .filter(e -> e.edit().equals(edit)).map(e -> new double[] {p.at(), e.time().median()})))));
        }
        return CurveChart.svg("Time against " + growth.along(), curves, WIDTH, HEIGHT, NumberText::tick, NumberText::tick);
    }

    /** Returns the points that a chart can show. */
    private static List<double[]> points(Stream<double[]> points) {
        return points.filter(p -> ChartRange.isPlausibleOrZero(p[0]) && ChartRange.isPlausibleOrZero(p[1])).toList();
    }
}
