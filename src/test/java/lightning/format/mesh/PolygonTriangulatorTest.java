package lightning.format.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import lightning.base.work.Await;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Triangulated polygons cover the original area. */
class PolygonTriangulatorTest {
    /** Star-shaped outline around its center in a tilted plane: its triangles keep its orientation and area. */
    @Property
    void randomOutline_isCoveredExactlyOnce(@ForAll @IntRange(min = 3, max = 40) int corners, @ForAll long seed) {
        var random = new SplittableRandom(seed);
        double[] x = new double[corners];
        double[] y = new double[corners];
        float[] positions = new float[3 * corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners;
            double radius = 0.2 + random.nextDouble();
            x[i] = radius * Math.cos(angle);
            y[i] = radius * Math.sin(angle);
            positions[3 * i] = (float) x[i];
            positions[3 * i + 1] = (float) (y[i] + 0.3 * x[i]);
            positions[3 * i + 2] = (float) (2 * x[i] - y[i]);
        }
        IntList triangles = triangles(positions);
        assertThat(triangles.size()).isEqualTo(3 * (corners - 2));
        double sum = 0;
        for (int t = 0; t < triangles.size(); t += 3) {
            int a = triangles.get(t);
            int b = triangles.get(t + 1);
            int c = triangles.get(t + 2);
            double area = (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
            assertThat(area).as("triangle " + a + " " + b + " " + c).isGreaterThan(-1e-6);
            sum += area;
        }
        double outline = 0;
        for (int i = 0; i < corners; i++) {
            int next = (i + 1) % corners;
            outline += x[i] * y[next] - y[i] * x[next];
        }
        assertThat(sum).isCloseTo(outline, Offset.offset(1e-5));
    }

    /** Planar rotated and non-planar quadrilaterals, as docs/jen-format.md defines. */
    @Test
    void convexQuadrilateral_isSplitFromSecondToFourthCorner() {
        float[][] outlines =
                {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0},
                    {0, 0, 0, 1, 0, 0, 1, 1, 0.3f, 0, 1, 0}};
        for (float[] outline : outlines) {
            int[] triangles = triangles(outline).toArray();
            assertThat(triangles).containsExactly(3, 0, 1, 1, 2, 3);
        }
    }

    @Test
    void concaveQuadrilateral_isSplitAtItsReflexCorner() {
        assertThat(contains(triangles(new float[] {0, 0, 0, 2, 0, 0, 0.5f, 0.5f, 0, 0, 2, 0}).toArray(), 0, 2)).isTrue();
    }

    @Test
    void outlineWithoutArea_isTriangulatedAsFan() {
        assertThat(triangles(new float[12]).toArray()).containsExactly(0, 1, 2, 0, 2, 3);
    }

    @Test
    @Timeout(Await.TIMEOUT_SECONDS)
    void selfIntersectingOutline_terminates() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 20; i++) {
            float[] positions = new float[3 * PolygonTriangulator.MAX_CORNERS];
            for (int j = 0; j < positions.length; j++) {
                positions[j] = (float) random.nextDouble();
            }
            assertThat(triangles(positions).size()).isEqualTo(3 * (PolygonTriangulator.MAX_CORNERS - 2));
        }
    }

    @Test
    void tooManyCorners_areTriangulatedAsFan() {
        assertThat(triangles(new float[3 * PolygonTriangulator.MAX_CORNERS + 3]).size())
                .isEqualTo(3 * (PolygonTriangulator.MAX_CORNERS - 1));
    }

    /** Returns whether one triangle has both corners, and thus an edge between them. */
    private static boolean contains(int[] triangles, int a, int b) {
        int matches = 0;
        for (int t = 0; t < triangles.length; t += 3) {
            int sharedCorners = 0;
            for (int i = t; i < t + 3; i++) {
                sharedCorners += triangles[i] == a || triangles[i] == b ? 1 : 0;
            }
            matches += sharedCorners == 2 ? 1 : 0;
        }
        return matches == 2;
    }

    private static IntList triangles(float[] positions) {
        int[] corners = new int[positions.length / 3];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i;
        }
        var triangles = new IntList();
        new PolygonTriangulator().triangulate(corners, corners.length, positions, triangles);
        return triangles;
    }
}
