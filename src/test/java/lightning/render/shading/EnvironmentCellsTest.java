package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import lightning.render.gather.cell.DirectionCells;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.DomeRotation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class EnvironmentCellsTest {
    private static final int ROWS = 64;
    private static final int GRID = 400;
    /** Cells with fewer directions, near the poles, are not compared. */
    private static final int MIN_DIRECTIONS = 20;

    /** The image is brighter toward its top: 1 plus the cosine of the angle from it. */
    @Property(tries = 20)
    void cellsOfTiltedImage_haveItsMeans(@ForAll @DoubleRange(min = -180, max = 180) double rotation,
            @ForAll @DoubleRange(min = -180, max = 180) double tilt, @ForAll @DoubleRange(min = -180, max = 180) double roll) {
        float[] rgb = new float[3 * 2 * ROWS * ROWS];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (1 + Math.cos(Math.PI * (i / (6 * ROWS) + 0.5) / ROWS));
        }
        DomeRotation dome = DomeRotation.of(rotation, tilt, roll);
        double[] found = EnvironmentCells.means(new EnvironmentMap(2 * ROWS, ROWS, rgb).smoothGrid(), dome);

        Vec3 up = dome.toWorld().transformVector(Vec3.Y);
        double[] sum = new double[DirectionCells.COUNT];
        double[] weight = new double[DirectionCells.COUNT];
        for (int i = 0; i < GRID * GRID; i++) {
            double y = 1 - 2 * (i / GRID + 0.5) / GRID;
            double azimuth = 2 * Math.PI * (i % GRID + 0.5) / GRID;
            double radius = Math.sqrt(1 - y * y);
            Vec3 d = new Vec3(radius * Math.cos(azimuth), y, radius * Math.sin(azimuth));
            int cell = DirectionCells.of(d.x(), d.y(), d.z());
            weight[cell]++;
            sum[cell] += 1 + d.dot(up);
        }
        for (int cell = 0; cell < DirectionCells.COUNT; cell++) {
            if (weight[cell] >= MIN_DIRECTIONS) {
                assertThat(found[3 * cell]).isCloseTo(sum[cell] / weight[cell], within(0.02));
            }
        }
    }
}
