package lightning.render.cache;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;
import lightning.render.image.Film;
import lightning.render.shading.SampleMean;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.composition.FilmMixer;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Anti-aliased tile of the image: its finer samples and the resulting pixels.
 *
 * @param first samples of the pixels at an edge, or of all pixels
 * @param rest  further samples of those of these pixels whose first samples differ visibly
 * @param films resulting films of the pixels of {@code first}, in their order; null if they are not known
 * @param film  tile of the film: red, green, blue, {@code float[1024]} each
 */
public record FineTile(FineSamples first, FineSamples rest, @Nullable StoredFilms films, float @Nullable [][] film) {

    /**
     * Creates the tile of samples and centers.
     *
     * @param center colors of the tile's pixel centers; null if all pixels have several samples
     * @param films  films of the pixels of {@code first}
     * @param mixer  adds them
     */
    public static FineTile of(float @Nullable [][] center, FineSamples first, FineSamples rest, StoredFilms films, FilmMixer mixer) {
        float[][] film = center == null ? new float[3][Film.TILE_PIXELS]
                : new float[][] {center[0].clone(), center[1].clone(), center[2].clone()};
        short[] pixels = first.pixels();
        float[][] colors = new float[3][pixels.length];
        StoredFilms kept = mixer.mix(films, colors);
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < pixels.length; i++) {
                film[c][pixels[i]] = colors[c][i];
            }
        }
        return new FineTile(first, rest, kept, film);
    }

    /** Returns the films of the pixels of some samples, in their order. @param films number of all films */
    public static StoredFilms films(FineSamples first, FineSamples rest, int films) {
        short[] pixels = first.pixels();
        short[] place = new short[Film.TILE_PIXELS];
        for (int i = 0; i < pixels.length; i++) {
            place[pixels[i]] = (short) i;
        }
        int count = first.cells().count();
        int restCount = rest.cells().count();
        float[] @Nullable [][] colors = new float[films][][];
        for (int f = 0; f < films; f++) {
            int film = f;
            if (!shows(first, film) && !shows(rest, film)) {
                continue;
            }
            float[][] to = new float[3][pixels.length];
            first.forEachMean(block -> mean(block, film), (pixel, red, green, blue) -> {
                to[0][place[pixel]] = red;
                to[1][place[pixel]] = green;
                to[2][place[pixel]] = blue;
            });
            rest.forEachMean(block -> mean(block, film), (pixel, red, green, blue) -> {
                int i = place[pixel];
                to[0][i] = SampleMean.combine(to[0][i], count, red, restCount);
                to[1][i] = SampleMean.combine(to[1][i], count, green, restCount);
                to[2][i] = SampleMean.combine(to[2][i], count, blue, restCount);
            });
            colors[film] = to;
        }
        return new StoredFilms(colors, new BitSet());
    }

    private static boolean shows(FineSamples samples, int film) {
        return Arrays.stream(samples.blocks()).anyMatch(block -> requireNonNull(block.means()).get(film) != null);
    }

    private static float[][] mean(SampleBlock block, int film) {
        float[][] mean = requireNonNull(block.means()).get(film);
        return mean == null ? new float[3][block.pixels().length] : mean;
    }

    private static float[][] film(float @Nullable [][] center, FineSamples first, Function<SampleBlock, float[][]> firstMeans,
            FineSamples rest, Function<SampleBlock, float[][]> restMeans) {
        float[][] film = center == null ? new float[3][Film.TILE_PIXELS]
                : new float[][] {center[0].clone(), center[1].clone(), center[2].clone()};
        first.forEachMean(firstMeans, (pixel, red, green, blue) -> {
            film[0][pixel] = red;
            film[1][pixel] = green;
            film[2][pixel] = blue;
        });
        int count = first.cells().count();
        int restCount = rest.cells().count();
        rest.forEachMean(restMeans, (pixel, red, green, blue) -> {
            film[0][pixel] = SampleMean.combine(film[0][pixel], count, red, restCount);
            film[1][pixel] = SampleMean.combine(film[1][pixel], count, green, restCount);
            film[2][pixel] = SampleMean.combine(film[2][pixel], count, blue, restCount);
        });
        return film;
    }

    /**
     * Returns the film of the same samples in other colors.
     *
     * @param center colors of the pixel centers, or null if all pixels have several samples
     * @param colors returns the colors of rows at some places
     */
    public float[][] film(float @Nullable [][] center, SamplePositions centers,
            BiFunction<CachedTile, SamplePositions, float[][]> colors) {
        return film(center, first, block -> first.means(block, colors.apply(block.rows(), block.positions(centers, first.cells()))), rest,
                block -> rest.means(block, colors.apply(block.rows(), block.positions(centers, rest.cells()))));
    }

    /** Returns the film of the same samples in other colors, which do not depend on their places. */
    public float[][] film(@Nullable CachedTile center, Function<CachedTile, float[][]> colors) {
        return film(center == null ? null : colors.apply(center), first, block -> first.means(block, colors.apply(block.rows())), rest,
                block -> rest.means(block, colors.apply(block.rows())));
    }

    /** Returns all samples. */
    public List<FineSamples> stages() {
        return List.of(first, rest);
    }

    /** Returns all blocks of samples. */
    public Stream<SampleBlock> blocks() {
        return stages().stream().flatMap(samples -> Stream.of(samples.blocks()));
    }

    /** Returns the bytes of the resulting films. */
    public long filmBytes() {
        return films == null ? 0 : films.bytes();
    }
}
