package lightning.cache;

/**
 * The samples of some pixels of a tile.
 *
 * @param pixels the pixels' indices in the tile, ascending
 * @param blocks the samples, those of as many pixels in each block as have room in 1024 rows
 */
public record FineSamples(short[] pixels, CachedTile[] blocks) {
    // Arrays in a record: written once by their maker, never after.
}
