package lightning.render.cache;

import lightning.render.shading.StoredFilms;
import lightning.render.trace.SampleCells;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Samples of some pixels of a tile that are traced together.
 *
 * @param pixels indices of the pixels in the tile, ascending
 * @param rows   the samples; all of the first pixel come first
 * @param means  means of each pixel's samples in each film: red, green and blue, {@code float[pixels]} each; null if unknown
 */
public record SampleBlock(short[] pixels, CachedTile rows, @Nullable StoredFilms means) {
    // Arrays in a record: written once by their creator.

    /** Returns the positions of the samples in a tile. */
    public SamplePositions positions(SamplePositions centers, SampleCells cells) {
        return new SamplePositions(centers.x0(), centers.y0(), pixels, cells);
    }

    /** Returns the bytes of the means. */
    public long meanBytes() {
        return means == null ? 0 : means.bytes();
    }
}
