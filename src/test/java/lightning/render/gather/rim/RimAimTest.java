package lightning.render.gather.rim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import lightning.render.gather.cell.DirectionTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests how many rays pass a cell with a rim, and where. */
class RimAimTest {

    /** 64 rays of a point allow 32 more. */
    @ParameterizedTest
    @CsvSource({"0, 16", "1, 16", "2, 16", "3, 8", "4, 8", "5, 4", "10, 4", "11, 2", "32, 2", "33, 1", "64, 1"})
    void raysPerCell_areAtMostHalfAsManyMore(int cells, int expected) {
        assertThat(RimAim.raysPerCell(cells, 64)).isEqualTo(expected);
    }

    /** However many rays there are, each column and each line of the parts contains as many. */
    @ParameterizedTest
    @ValueSource(ints = {4, 8, 16})
    void partsOfRays_fillColumnsAndLinesAlike(int rays) {
        for (int own = 0; own < 16; own++) {
            Map<Integer, Integer> columns = new HashMap<>();
            Map<Integer, Integer> lines = new HashMap<>();
            for (int ray = 0; ray < rays; ray++) {
                int part = own ^ RimAim.turn(ray);
                columns.merge(part % 4, 1, Integer::sum);
                lines.merge(part / 4, 1, Integer::sum);
            }
            int used = rays == 4 ? 2 : 4;
            assertThat(columns).hasSize(used).allSatisfy((_, count) -> assertThat(count).isEqualTo(rays / used));
            assertThat(lines).hasSize(used).allSatisfy((_, count) -> assertThat(count).isEqualTo(rays / used));
        }
    }

    /** A turned direction lies in the same cell of the directions' grid, so in the same quarter of the hemisphere. */
    @Test
    void turnedDirections_stayInTheirCell() {
        int side = 8;
        DirectionTable table = new DirectionTable(side);
        double[][] own = directions(table, 0);
        for (int turn = 1; turn < 16; turn++) {
            double[][] turned = directions(table, turn);
            for (int k = 0; k < side * side; k++) {
                assertThat(turned[0][k]).isNotEqualTo(own[0][k]);
                assertThat(cell(turned, k, side)).isEqualTo(k);
            }
        }
    }

    private static double[][] directions(DirectionTable table, int turn) {
        double[][] to = new double[3][table.rays()];
        table.write(0x123456789L, turn, 0, 0, 1, to[0], to[1], to[2], 0);
        return to;
    }

    /** Inverse of the concentric map. */
    private static int cell(double[][] directions, int k, int side) {
        double x = directions[0][k];
        double y = directions[1][k];
        double radius = Math.hypot(x, y);
        double a;
        double b;
        if (Math.abs(x) > Math.abs(y)) {
            a = Math.copySign(radius, x);
            b = a * Math.atan(y / x) * 4 / Math.PI;
        } else {
            b = Math.copySign(radius, y);
            a = b * Math.atan(x / y) * 4 / Math.PI;
        }
        return (int) ((b + 1) / 2 * side) * side + (int) ((a + 1) / 2 * side);
    }
}
