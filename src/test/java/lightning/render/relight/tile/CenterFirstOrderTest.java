package lightning.render.relight.tile;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class CenterFirstOrderTest {

    @Test
    void tilesOfThreeRows_startAtCenter() {
        assertThat(CenterFirstOrder.tileOrder(5, 15)).startsWith(7).endsWith(0, 4, 10, 14).containsSubsequence(7, 2, 12, 1, 0)
                .containsSubsequence(7, 6, 5, 0);
    }

    @Property
    void everyTile_occursOnce(@ForAll @IntRange(min = 1, max = 40) int tilesPerRow, @ForAll @IntRange(min = 1, max = 40) int tileRows) {
        int[] order = CenterFirstOrder.tileOrder(tilesPerRow, tilesPerRow * tileRows);
        Arrays.sort(order);
        assertThat(order).isEqualTo(IntStream.range(0, tilesPerRow * tileRows).toArray());
    }
}
