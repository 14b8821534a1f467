package lightning.textures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class TileableNoiseTest {

    @Property
    void everyNoise_isTileable(@ForAll @IntRange(max = 4095) int x, @ForAll @IntRange(max = 4095) int y,
            @ForAll @IntRange(min = 1, max = 40) int cells, @ForAll int seed) {
        // Fractions of a power of two, so that adding 1 does not round.
        double u = x / 4096.0;
        double v = y / 4096.0;

        assertThat(TileableNoise.at(u + 1, v - 1, cells, cells, seed)).isCloseTo(TileableNoise.at(u, v, cells, cells, seed), within(1e-9));
        assertThat(TileableNoise.fbm(u - 2, v + 1, cells, 3, 4, seed)).isCloseTo(TileableNoise.fbm(u, v, cells, 3, 4, seed), within(1e-9));
        assertThat(TileableNoise.cells(u + 1, v + 3, cells, 5, 1, seed).nearest())
                .isCloseTo(TileableNoise.cells(u, v, cells, 5, 1, seed).nearest(), within(1e-9));
    }

    @Property
    void adjacentPoints_haveSimilarNoise(@ForAll @IntRange(max = 1 << 20) int x, @ForAll @IntRange(max = 1 << 20) int y,
            @ForAll int seed) {
        double u = x / (double) (1 << 20);
        double v = y / (double) (1 << 20);

        assertThat(TileableNoise.at(u + 1e-7, v, 8, 8, seed)).isCloseTo(TileableNoise.at(u, v, 8, 8, seed), within(1e-5));
        assertThat(TileableNoise.at(u, v, 8, 8, seed)).isBetween(-1.5, 1.5);
        assertThat(TileableNoise.hash(x, y, seed)).isBetween(0.0, Math.nextDown(1.0));
    }
}
