package lightning.render.gather.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class SkyCellsTest {
    private static final double[] SOLID_ANGLES = {0, 0.002, 0.01, 0.03, 0.1, 1};

    private static int[] parts(int cell) {
        return IntStream.range(0, 4).map(number -> SkyCells.part(cell, number)).toArray();
    }

    @Property
    void coarserCell_containsTheFinerOneOfTheSameDirection(@ForAll @DoubleRange(min = -1, max = 1) double x,
            @ForAll @DoubleRange(min = -1, max = 1) double y, @ForAll @DoubleRange(min = -1, max = 1) double z) {
        if (Math.abs(x) + Math.abs(y) + Math.abs(z) > 0.1) {
            int finer = SkyCells.of(x, y, z, 0);
            double solidAngle = 0.001;
            while (solidAngle < 4) {
                int cell = SkyCells.of(x, y, z, solidAngle);
                if (cell != finer) {
                    assertThat(parts(cell)).contains(finer);
                }
                finer = cell;
                solidAngle *= 2;
            }
        }
    }

    @Test
    void cellsOfOtherLevels_haveOtherNumbers() {
        assertThat(IntStream.range(0, SOLID_ANGLES.length).map(i -> SkyCells.of(0.3, 0.8, -0.2, SOLID_ANGLES[i])).distinct().count())
                .isEqualTo(SOLID_ANGLES.length);
        assertThat(SkyCells.of(-0.1, -1, 0.1, 100)).isLessThan(SkyCells.COUNT);
    }

    /** All finest cells are parts of some cell, each of one. */
    @Test
    void everyFinerCell_isPartOfOneCell() {
        int[] all = IntStream.range(SkyCells.FINEST_COUNT, SkyCells.COUNT).flatMap(cell -> IntStream.of(parts(cell))).sorted().toArray();
        assertThat(all).doesNotHaveDuplicates().startsWith(0, 1, 2).hasSize(4 * (SkyCells.COUNT - SkyCells.FINEST_COUNT));
    }

    /** The cells of one level are equally many on the sphere, so their mean size is known: no cell may be larger than what is asked for. */
    @Test
    void cells_areNotLargerThanAsked() {
        for (double solidAngle : SOLID_ANGLES) {
            int cell = SkyCells.of(0.2, 0.9, 0.1, solidAngle);
            int inFinest = 1;
            while (cell >= SkyCells.FINEST_COUNT) {
                cell = SkyCells.part(cell, 0);
                inFinest *= 4;
            }
            double mean = inFinest * 4 * Math.PI / SkyCells.FINEST_COUNT;
            assertThat(inFinest == 1 || mean <= solidAngle * (1 + 1e-12)).as("%s", solidAngle).isTrue();
        }
    }
}
