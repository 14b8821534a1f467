package lightning.textures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class NoiseTest {

    @Property
    void everyNoise_repeatsAfterOneTexture(@ForAll @IntRange(max = 4095) int x, @ForAll @IntRange(max = 4095) int y,
            @ForAll @IntRange(min = 1, max = 40) int cells, @ForAll int seed) {
        // Fractions of a power of two, so that adding 1 does not round.
        double u = x / 4096.0;
        double v = y / 4096.0;

        assertThat(Noise.at(u + 1, v - 1, cells, cells, seed)).isCloseTo(Noise.at(u, v, cells, cells, seed), within(1e-9));
        assertThat(Noise.fbm(u - 2, v + 1, cells, 3, 4, seed)).isCloseTo(Noise.fbm(u, v, cells, 3, 4, seed), within(1e-9));
        assertThat(Noise.cells(u + 1, v + 3, cells, 5, 1, seed).nearest())
                .isCloseTo(Noise.cells(u, v, cells, 5, 1, seed).nearest(), within(1e-9));
    }

    @Property
    void neighbouringPoints_haveNeighbouringNoise(@ForAll @IntRange(max = 1 << 20) int x, @ForAll @IntRange(max = 1 << 20) int y,
            @ForAll int seed) {
        double u = x / (double) (1 << 20);
        double v = y / (double) (1 << 20);

        assertThat(Noise.at(u + 1e-7, v, 8, 8, seed)).isCloseTo(Noise.at(u, v, 8, 8, seed), within(1e-5));
        assertThat(Noise.at(u, v, 8, 8, seed)).isBetween(-1.5, 1.5);
        assertThat(Noise.hash(x, y, seed)).isBetween(0.0, Math.nextDown(1.0));
    }
}
