package lightning.render.shading;

import lightning.base.math.Transform;
import lightning.render.gather.cell.DirectionCells;
import lightning.scene.asset.SmoothGrid;
import lightning.scene.value.DomeRotation;

/** Means of an environment's light over {@link DirectionCells}. */
final class EnvironmentCells {
    private static final double[] SIN_AZIMUTH = new double[SmoothGrid.COLUMNS];
    private static final double[] COS_AZIMUTH = new double[SmoothGrid.COLUMNS];

    static {
        for (int column = 0; column < SmoothGrid.COLUMNS; column++) {
            double azimuth = 2 * Math.PI * ((column + 0.5) / SmoothGrid.COLUMNS - 0.5);
            SIN_AZIMUTH[column] = StrictMath.sin(azimuth);
            COS_AZIMUTH[column] = StrictMath.cos(azimuth);
        }
    }

    private EnvironmentCells() {}

    /**
     * Returns the mean radiance of each cell, red, green and blue: at least six cells of the grid lie in each.
     *
     * @param rotation rotation of the environment
     */
    static double[] means(SmoothGrid grid, DomeRotation rotation) {
        Transform m = rotation.toWorld();
        double[] sum = new double[3 * DirectionCells.COUNT];
        double[] weight = new double[DirectionCells.COUNT];
        for (int row = 0; row < SmoothGrid.ROWS; row++) {
            double polar = Math.PI * (row + 0.5) / SmoothGrid.ROWS;
            double height = StrictMath.cos(polar);
            double radius = StrictMath.sin(polar);
            for (int column = 0; column < SmoothGrid.COLUMNS; column++) {
                double x = radius * SIN_AZIMUTH[column];
                double z = -radius * COS_AZIMUTH[column];
                int cell = DirectionCells.of(m.m00() * x + m.m01() * height + m.m02() * z, m.m10() * x + m.m11() * height + m.m12() * z,
                        m.m20() * x + m.m21() * height + m.m22() * z);
                int from = 3 * (row * SmoothGrid.COLUMNS + column);
                weight[cell] += radius;
                for (int c = 0; c < 3; c++) {
                    sum[3 * cell + c] += radius * grid.rgb()[from + c];
                }
            }
        }
        for (int i = 0; i < sum.length; i++) {
            sum[i] /= weight[i / 3];
        }
        return sum;
    }
}
