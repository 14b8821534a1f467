package lightning.render.gather.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class SkyCellsTest {
    private final int[] cells = new int[4];
    private final float[] shares = new float[4];

    private static int[] parts(int cell) {
        return IntStream.range(0, 4).map(number -> SkyCells.part(cell, number)).toArray();
    }

    /** Returns a cell of the finest level that is part of a cell. */
    private static int finest(int cell) {
        return cell < SkyCells.FINEST_COUNT ? cell : finest(SkyCells.part(cell, 0));
    }

    @Property
    void mixedCells_areOnOneSideOfTheHorizonAndHaveSharesOfOne(@ForAll @DoubleRange(min = -1, max = 1) double x,
            @ForAll @DoubleRange(min = -1, max = 1) double y, @ForAll @DoubleRange(min = -1, max = 1) double z,
            @ForAll @DoubleRange(min = 0, max = 12) double solidAngle) {
        if (Math.abs(x) + Math.abs(y) + Math.abs(z) > 0.1) {
            SkyCells.mix(x, y, z, solidAngle, cells, shares);
            assertThat(shares[0] + shares[1] + shares[2] + shares[3]).isCloseTo(1, within(1e-6f));
            for (int i = 0; i < 4; i++) {
                assertThat(shares[i]).isBetween(0f, 1f);
                assertThat(finest(cells[i]) >= SkyCells.FINEST_COUNT / 2).isEqualTo(y < 0);
            }
        }
    }

    /** At the center of a cell, its own light is seen, and halfway to the next one both. */
    @Test
    void centerOfACell_seesThisCellAlone() {
        double[] center = new double[3];
        for (int cell : new int[] {64 * 128 + 64, 5000, SkyCells.FINEST_COUNT / 2 + 77}) {
            SkyCells.writeCenter(cell, center);
            SkyCells.mix(center[0], center[1], center[2], 0, cells, shares);
            for (int i = 0; i < 4; i++) {
                assertThat(shares[i]).isCloseTo(cells[i] == cell ? 1 : 0, within(1e-4f));
            }
            assertThat(cells).contains(cell);
        }
    }

    /** All finest cells are parts of some cell, each of one. */
    @Test
    void everyFinerCell_isPartOfOneCell() {
        int[] all = IntStream.range(SkyCells.FINEST_COUNT, SkyCells.COUNT).flatMap(cell -> IntStream.of(parts(cell))).sorted().toArray();
        assertThat(all).doesNotHaveDuplicates().startsWith(0, 1, 2).hasSize(4 * (SkyCells.COUNT - SkyCells.FINEST_COUNT));
    }

    /** The cells of one level are equally many on the sphere, so their mean size is known: no cell may be larger than about what is asked for. */
    @Test
    void cells_areAboutAsLargeAsAsked() {
        for (double solidAngle = 0.001; solidAngle < 0.2; solidAngle *= 1.1) {
            SkyCells.mix(0.2, 0.9, 0.1, solidAngle, cells, shares);
            int inFinest = 1;
            for (int cell = cells[0]; cell >= SkyCells.FINEST_COUNT; cell = SkyCells.part(cell, 0)) {
                inFinest *= 4;
            }
            double mean = inFinest * 4 * Math.PI / SkyCells.FINEST_COUNT;
            assertThat(mean / solidAngle).as("%s", solidAngle).isBetween(0.49, 2.01);
        }
    }
}
