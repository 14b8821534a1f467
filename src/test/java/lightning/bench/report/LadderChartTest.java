package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.bench.accuracy.Grade;
import lightning.bench.report.LadderChart.Point;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class LadderChartTest {

    @Test
    void aLevelBeatenInBoth_isOffTheFront() {
        Point fast = new Point(Grade.FAST_SHADING, 1, 1, 1, 0.1);
        Point half = new Point(Grade.HALF_RESOLUTION, 2, 2, 2, 0.2);
        Point exact = new Point(Grade.EXACT_CURRENT, 3, 3, 3, 0);
        Point full = new Point(Grade.FULL_TRACE, 9, 9, 9, 0);

        assertThat(LadderChart.paretoFront(List.of(full, half, exact, fast))).containsExactly(fast, exact);
    }

    @Property
    void theFront_holdsWhatNoOtherBeats(@ForAll("points") List<Point> points) {
        List<Point> front = LadderChart.paretoFront(points);

        for (Point p : points) {
            boolean beaten = points.stream().anyMatch(q -> q.median() <= p.median() && q.error() <= p.error()
                    && (q.median() < p.median() || q.error() < p.error()));
            boolean inFront = front.stream().anyMatch(q -> q.median() == p.median() && q.error() == p.error());
            assertThat(inFront).as("%s", p).isEqualTo(!beaten);
        }
    }

    @Test
    void everyLevel_isNamedInTheChart() {
        String svg = LadderChart.svg("chart", List.of(new Point(Grade.RATIO, 1, 2, 3, 1e-8), new Point(Grade.FULL_TRACE, 8, 9, 10, 0)), 400,
                300);

        assertThat(svg).contains(">ratio<", ">full trace<", ">0<");
    }

    /** Colors and shapes stand in the order of the grades. */
    @Test
    void everyGrade_hasAColorAndAShapeOfItsOwn() {
        assertThat(Grade.values()).extracting(PlotLook::shape).doesNotHaveDuplicates();
        assertThat(Grade.values()).extracting(grade -> Ink.of(grade).name()).containsExactly("ORANGE", "RED", "MUTED", "MUTED", "PURPLE",
                "SKY", "GREEN", "OURS", "TEXT");
    }

    @Test
    void allEqual_stillIsAChart() {
        assertThat(LadderChart.svg("chart", List.of(new Point(Grade.FULL_TRACE, 5, 5, 5, 0)), 400, 300)).contains(">full trace<");
        assertThat(LadderChart.svg("chart", List.of(), 400, 300)).contains("<svg");
    }

    @Test
    void quartilesInDisorder_areNoPoint() {
        Point wrong = new Point(Grade.EXACT, 3, 2, 1, 0);

        assertThat(LadderChart.svg("chart", List.of(wrong, new Point(Grade.FULL_TRACE, 8, 9, 10, 0)), 400, 300)).contains(">full trace<")
                .doesNotContain(">exact<");
        assertThat(LadderChart.svg("chart", List.of(wrong), 400, 300)).contains("<svg");
    }

    @Provide
    Arbitrary<List<Point>> points() {
        Arbitrary<Double> few = Arbitraries.of(1.0, 2.0, 3.0, 4.0);
        return Combinators.combine(Arbitraries.of(Grade.values()), few, few)
                .as((grade, time, error) -> new Point(grade, time, time, time, error - 1)).list().ofMaxSize(7);
    }
}
