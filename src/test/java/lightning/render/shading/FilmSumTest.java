package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class FilmSumTest {
    private static final int LENGTH = 37;

    @Property
    void sum_isBalancedTreeOverAllFilms_withBlackOnesAndZeroWeights(@ForAll @IntRange(max = 40) int count, @ForAll long seed) {
        Random random = new Random(seed);
        double share = random.nextDouble();
        float[][][] films = new float[count][][];
        LightWeight[] weights = new LightWeight[count];
        for (int film = 0; film < count; film++) {
            films[film] = random.nextDouble() < share ? film(random) : null;
            weights[film] = random.nextInt(8) == 0 ? LightWeight.ZERO : new LightWeight(value(random), 0, value(random));
        }
        float[][] sum = film(random);

        new FilmSum().add(weights, film -> films[film], LENGTH, sum);

        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < LENGTH; i++) {
                float[] terms = new float[count];
                for (int film = 0; film < count; film++) {
                    terms[film] = films[film] == null ? 0 : weights[film].channel(c) * films[film][c][i];
                }
                assertThat(sum[c][i]).isEqualTo(LightingEquation.sum(terms, 0, count));
            }
        }
    }

    /** The weight of one film changes, then that of another one. */
    @Property
    void sumsBesideAFilm_addUpToTheSame(@ForAll @IntRange(min = 1, max = 40) int count, @ForAll long seed) {
        Random random = new Random(seed);
        float[][][] films = new float[count][][];
        LightWeight[] weights = new LightWeight[count];
        Arrays.setAll(films, _ -> random.nextBoolean() ? film(random) : null);
        Arrays.setAll(weights, _ -> new LightWeight(value(random), 0, value(random)));
        StoredFilms stored = new StoredFilms(films, new BitSet());
        FilmSum sum = new FilmSum();
        for (int edit = 0; edit < 6; edit++) {
            int film = edit < 3 ? 0 : count - 1;
            weights = weights.clone();
            weights[film] = random.nextInt(4) == 0 ? LightWeight.ZERO : new LightWeight(value(random), value(random), value(random));
            float[][] faded = film(random);
            float[][] all = film(random);
            FilmBranches before = stored.branches();
            stored = sum.add(weights, stored, film, faded);
            assertThat(stored.branches() == before).isEqualTo(edit != 0 && (edit != 3 || count == 1));
            sum.add(weights, stored::get, LENGTH, all);
            assertThat(faded).isDeepEqualTo(all);
        }
    }

    private static float[][] film(Random random) {
        float[][] film = new float[3][LENGTH];
        Arrays.stream(film).forEach(channel -> {
            for (int i = 0; i < LENGTH; i++) {
                channel[i] = value(random);
            }
        });
        return film;
    }

    /** Returns a number of random magnitude, so that sums in another order differ. */
    private static float value(Random random) {
        return (float) Math.scalb(random.nextDouble(), random.nextInt(30) - 15);
    }
}
