package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.bench.report.AccuracyChart.Point;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.ParetoFront;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class AccuracyChartTest {

    @Test
    void dominatedSetting_isOffParetoFront() {
        Point fast = new Point(AccuracySetting.FAST_SHADING, 1, 1, 1, 0.1);
        Point half = new Point(AccuracySetting.HALF_RESOLUTION, 2, 2, 2, 0.2);
        Point exact = new Point(AccuracySetting.EXACT_CURRENT, 3, 3, 3, 0);
        Point full = new Point(AccuracySetting.FULL_TRACE, 9, 9, 9, 0);

        assertThat(ParetoFront.of(List.of(full, half, exact, fast), Point::median, Point::error)).containsExactly(fast, exact);
    }

    @Property
    void paretoFront_hasUndominatedPoints(@ForAll("points") List<Point> points) {
        List<Point> front = ParetoFront.of(points, Point::median, Point::error);

        for (Point p : points) {
            boolean beaten = points.stream().anyMatch(q -> q.median() <= p.median() && q.error() <= p.error()
                    && (q.median() < p.median() || q.error() < p.error()));
            boolean inFront = front.stream().anyMatch(q -> q.median() == p.median() && q.error() == p.error());
            assertThat(inFront).as("%s", p).isEqualTo(!beaten);
        }
    }

    @Test
    void everySetting_isLabeledInChart() {
        String svg = AccuracyChart.svg("chart",
                List.of(new Point(AccuracySetting.RATIO, 1, 2, 3, 1e-8), new Point(AccuracySetting.FULL_TRACE, 8, 9, 10, 0)), 400,
                300);

        assertThat(svg).contains(">ratio<", ">full trace<", ">0<");
    }

    /** Checks that colors and shapes are in the order of the settings. */
    @Test
    void everySetting_hasUniqueColorAndShape() {
        assertThat(AccuracySetting.values()).extracting(PlotStyle::shape).doesNotHaveDuplicates();
        assertThat(AccuracySetting.values()).extracting(grade -> PlotColor.of(grade).name()).containsExactly("ORANGE", "RED", "MUTED",
                "MUTED", "PURPLE",
                "SKY", "GREEN", "OURS", "TEXT");
    }

    @Test
    void equalPoints_giveAChart() {
        assertThat(AccuracyChart.svg("chart", List.of(new Point(AccuracySetting.FULL_TRACE, 5, 5, 5, 0)), 400, 300))
                .contains(">full trace<");
        assertThat(AccuracyChart.svg("chart", List.of(), 400, 300)).contains("<svg");
    }

    @Test
    void unorderedQuartiles_areSkipped() {
        Point wrong = new Point(AccuracySetting.EXACT, 3, 2, 1, 0);

        assertThat(AccuracyChart.svg("chart", List.of(wrong, new Point(AccuracySetting.FULL_TRACE, 8, 9, 10, 0)), 400, 300))
                .contains(">full trace<")
                .doesNotContain(">exact<");
        assertThat(AccuracyChart.svg("chart", List.of(wrong), 400, 300)).contains("<svg");
    }

    @Provide
    Arbitrary<List<Point>> points() {
        Arbitrary<Double> few = Arbitraries.of(1.0, 2.0, 3.0, 4.0);
        return Combinators.combine(Arbitraries.of(AccuracySetting.values()), few, few)
                .as((grade, time, error) -> new Point(grade, time, time, time, error - 1)).list().ofMaxSize(7);
    }
}
