package lightning.render.gather.point;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import lightning.render.gather.cell.SurfaceColumns;
import org.junit.jupiter.api.Test;

class NearPointsTest {
    private static final int COUNT = 64;

    /** The extent of the places is beyond the range of floats. */
    @Test
    void placesFarApart_areVisitedOnceEach() {
        SurfaceColumns points = new SurfaceColumns();
        points.reserve(COUNT);
        points.count = COUNT;
        float[] radius = new float[COUNT];
        for (int p = 0; p < COUNT; p++) {
            points.set(p, p, 0, 0, 0, 0, 1, 0);
            radius[p] = 1e18f;
        }
        float[] x = {-3e38f, 3e38f, 2e38f, 1, 2};
        float[] zeros = new float[x.length];
        int[] found = new int[x.length];
        Arrays.fill(found, -1);
        new NearPoints(points, radius, new PointGroups(points, radius)).find(x, zeros, zeros, new int[] {0, 1, 2, 3, 4}, 0, x.length,
                (place, count) -> found[place] = count);
        assertThat(found).containsExactly(0, 0, 0, COUNT, COUNT);
    }
}
