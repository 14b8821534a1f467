package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.FilmParts;
import lightning.render.shading.FilmSum;
import lightning.render.shading.LightWeight;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.TermKernel;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Adds the films of a tile to its colors, and to those by which edges are detected. If mirrors show an earlier scene, what they show is a film of
 * its own, added after the others, and another one for edges. Scratch memory for one thread.
 */
public final class FilmMixer {
    /** Films of mirrors that show an earlier scene: for colors, and for edges. */
    public static final int EARLIER_FILMS = 2;

    private final LightWeight[] weights;
    private final LightWeight[] edgeWeights;
    private final @Nullable FilmParts mirrored;
    /** Film whose weight alone changes; −1 if there is none. */
    private final int faded;
    private final FilmSum sum = new FilmSum();
    private long bytesMoved;
    private final float[][] edges = new float[3][TermKernel.MAX_ROWS];
    private final BounceImages images = new BounceImages(new float[3][TermKernel.MAX_ROWS], new float[3][TermKernel.MAX_ROWS]);

    /**
     * @param parts    films of the scene
     * @param mirrored those of the earlier scene in mirrors; null if mirrors are current
     * @param faded    film whose weight alone is being edited; −1 if there is none
     */
    public FilmMixer(FilmParts parts, @Nullable FilmParts mirrored, int faded) {
        this.faded = faded;
        weights = parts.weights();
        edgeWeights = parts.edgeWeights();
        this.mirrored = mirrored;
    }

    /** Returns the number of films, with those of earlier mirrors. */
    public int films() {
        return weights.length + EARLIER_FILMS;
    }

    /** Writes the colors. */
    public void mix(FilmSum.Films films, float[][] to) {
        mix(films, weights, weights.length, to[0].length, to);
    }

    /** Writes the colors of stored films; returns these with the sums that the next edit of the same weight needs. */
    public StoredFilms mix(StoredFilms films, float[][] to) {
        long before = sum.bytesRead();
        StoredFilms kept;
        if (faded >= 0) {
            kept = sum.add(weights, films, faded, to);
        } else {
            mix(films::get, to);
            kept = films.branches() == null ? films : new StoredFilms(films.colors(), films.known());
        }
        bytesMoved += sum.bytesRead() - before + 3L * Float.BYTES * to[0].length;
        return kept;
    }

    /** Returns the bytes of stored films that were read, and of colors that were written from them. */
    public long bytesMoved() {
        return bytesMoved;
    }

    /** Returns packed colors by which edges are detected. @param positions their number */
    public int[] edgeColors(FilmSum.Films films, int positions) {
        mix(films, edgeWeights, weights.length + 1, positions, edges);
        return EdgeColors.pack(edges, positions);
    }

    /** @param earlier film of earlier mirrors */
    private void mix(FilmSum.Films films, LightWeight[] of, int earlier, int positions, float[][] to) {
        sum.add(of, films, positions, to);
        float[][] mirrors = films.get(earlier);
        for (int c = 0; mirrors != null && c < 3; c++) {
            for (int i = 0; i < positions; i++) {
                to[c][i] += mirrors[c][i];
            }
        }
    }

    /**
     * Returns what the rays that bounce from a level's rows show, all films added; scratch memory, valid until the next call.
     *
     * @param rows     the level
     * @param bounced  films of these rays, by {@link BounceKind}
     * @param isForEdges whether weights are rounded
     */
    public BounceImages images(HitRows rows, FilmColors[] bounced, boolean isForEdges) {
        LightWeight[] of = mirrored == null ? isForEdges ? edgeWeights : weights
                : isForEdges ? mirrored.edgeWeights() : mirrored.weights();
        sum.add(of, bounced[BounceKind.MIRRORED.ordinal()]::get, rows.reflectiveCount, images.mirrored());
        sum.add(of, bounced[BounceKind.REFRACTED.ordinal()]::get, rows.clearCount, requireNonNull(images.refracted()));
        return images;
    }

    /**
     * Adds what mirrors show of an earlier scene.
     *
     * @param rows         the first level
     * @param earlier      colors of the rays that bounce from its rows
     * @param earlierEdges the same for edges; null if edges are not detected
     * @param composer     of the first level, which was composed last
     */
    public void addEarlierMirrors(HitRows rows, BounceImages earlier, @Nullable BounceImages earlierEdges, TileComposer composer,
            FilmColors films) {
        composer.composeImages(rows, earlier, films.toWrite(weights.length));
        if (earlierEdges != null) {
            composer.composeImages(rows, earlierEdges, films.toWrite(weights.length + 1));
        }
    }
}
