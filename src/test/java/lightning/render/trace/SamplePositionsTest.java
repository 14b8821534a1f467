package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SamplePositionsTest {
    private static final short[] PIXELS = {31, 32, 500, 1023};

    @Test
    void batchPositions_matchSinglePositions() {
        for (int grid = 1; grid <= 5; grid++) {
            for (SampleCells cells : List.of(SampleCells.all(grid), SampleCells.first(grid), SampleCells.rest(grid))) {
                var places = new SamplePositions(64, 32, PIXELS, cells);
                for (int first = 0; first < places.count(); first++) {
                    int count = Math.min(16, places.count() - first);
                    double[] x = new double[count];
                    double[] y = new double[count];
                    places.writePositions(first, count, x, y);
                    for (int i = 0; i < count; i++) {
                        assertThat(x[i]).isEqualTo(places.x(first + i));
                        assertThat(y[i]).isEqualTo(places.y(first + i));
                    }
                }
            }
        }
    }
}
