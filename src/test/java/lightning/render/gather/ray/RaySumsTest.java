package lightning.render.gather.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the light of films side by side is added in the order of the rays for each film. */
class RaySumsTest {
    private static final int RAYS = 100;
    private static final int NUMBERS = 300;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5})
    void filmsSideBySide_areAddedInOrder(int films) {
        assertSums(Engines.SCALAR, films, false);
        assertSums(Engines.LANES, films, false);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 5})
    void tintedRays_multiplyTheLightOfEachFilm(int films) {
        assertSums(Engines.SCALAR, films, true);
    }

    private static void assertSums(Engine engine, int films, boolean isTinted) {
        Random random = new Random(films);
        FilmLight light = FilmLight.black(films, NUMBERS);
        float[][][] its = new float[NUMBERS][films][3];
        for (int number = 0; number < NUMBERS; number++) {
            for (int film = 0; film < films; film++) {
                float[] rgb = {random.nextFloat(), random.nextFloat(), random.nextFloat()};
                its[number][film] = rgb;
                light.set(number, film, rgb[0], rgb[1], rgb[2]);
            }
        }
        int[] number = random.ints(RAYS, 0, NUMBERS).toArray();
        RaySums sums = new RaySums(engine.sums());
        System.arraycopy(number, 0, sums.numbers(RAYS), 0, RAYS);
        float[][] tint = sums.tints();
        for (float[] channel : tint) {
            for (int ray = 0; ray < RAYS; ray++) {
                channel[ray] = random.nextFloat();
            }
        }
        sums.addUp(light, RAYS, isTinted);
        for (int film = 0; film < films; film++) {
            for (int c = 0; c < 3; c++) {
                float expected = 0;
                for (int ray = 0; ray < RAYS; ray++) {
                    expected += its[number[ray]][film][c] * (isTinted ? tint[c][ray] : 1);
                }
                assertThat(sums.get(film, c)).isEqualTo(expected);
            }
        }
        float[] written = new float[3 * films];
        FilmLight copy = FilmLight.black(films, 2);
        sums.writeTo(copy, 1);
        System.arraycopy(copy.values(), copy.at(1, 0), written, 0, written.length);
        assertThat(written).isEqualTo(sumsOf(sums, films));
        assertThat(Arrays.copyOf(copy.values(), copy.stride())).containsOnly(0);
    }

    private static float[] sumsOf(RaySums sums, int films) {
        float[] all = new float[3 * films];
        for (int i = 0; i < all.length; i++) {
            all[i] = sums.get(i / 3, i % 3);
        }
        return all;
    }
}
