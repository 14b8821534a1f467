package lightning.bench.report;

import java.util.List;
import lightning.render.measure.AccuracySetting;

/** Chart of error against time with a point per accuracy setting. */
final class AccuracyChart {
    /** Accuracy setting with its time in milliseconds and its error, ≥ 0. */
    record Point(AccuracySetting setting, double lower, double median, double upper, double error) {
        private ParetoChart.Point toChart() {
            return new ParetoChart.Point(setting.label(), PlotColor.of(setting), PlotStyle.shape(setting), setting != AccuracySetting.EXACT,
                    lower, median, upper, error);
        }
    }

    private AccuracyChart() {}

    static String svg(String label, List<Point> measured, int width, int height) {
        return ParetoChart.svg(label, measured.stream().map(Point::toChart).toList(), width, height,
                at -> NumberText.power((int) Math.round(Math.log10(at))));
    }
}
