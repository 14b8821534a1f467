package lightning.render.shading.composition;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import lightning.render.image.Film;
import lightning.render.shading.EdgeColors;
import org.jspecify.annotations.Nullable;

/**
 * Finds the pixels that anti-aliasing samples: those whose color differs visibly from a neighbor's to the left, right, top or bottom.
 *
 * @param width  width of the picture in pixels
 * @param height height of the picture in pixels
 * @param tiles  colors of its tiles, in the film's order; read on request
 */
public record EdgeDetector(int width, int height, EdgeColors[] tiles) {
    private static final int SIDE = Film.TILE_SIZE;

    /** Returns all pixels of a tile of a picture of the given size, as ascending indices in the tile. */
    public static short[] allPixels(int width, int height, int tile) {
        int tilesX = Film.tilesAlong(width);
        int columns = Math.min(SIDE, width - tile % tilesX * SIDE);
        int lines = Math.min(SIDE, height - tile / tilesX * SIDE);
        short[] all = new short[columns * lines];
        for (int i = 0; i < all.length; i++) {
            all[i] = (short) (i / columns * SIDE + i % columns);
        }
        return all;
    }

    /** Returns a set of pixels of a tile as ascending indices. */
    public static short[] toPixels(BitSet set) {
        short[] pixels = new short[set.cardinality()];
        for (int i = 0, pixel = set.nextSetBit(0); pixel >= 0; pixel = set.nextSetBit(pixel + 1)) {
            pixels[i++] = (short) pixel;
        }
        return pixels;
    }

    /** Returns some tiles of a film and their neighbors, ascending. */
    public static int[] addNeighborTiles(Film film, int[] tiles) {
        boolean[] target = new boolean[film.tileCount()];
        for (int tile : tiles) {
            int x = tile % film.tilesX();
            target[tile] = true;
            target[x > 0 ? tile - 1 : tile] = true;
            target[x + 1 < film.tilesX() ? tile + 1 : tile] = true;
            target[tile >= film.tilesX() ? tile - film.tilesX() : tile] = true;
            target[tile + film.tilesX() < target.length ? tile + film.tilesX() : tile] = true;
        }
        return IntStream.range(0, target.length).filter(i -> target[i]).toArray();
    }

    /** Returns whether another detector finds the same edges in a tile because both read the same colors. */
    public boolean hasSameEdges(int tile, EdgeDetector other) {
        int tilesX = Film.tilesAlong(width);
        int x = tile % tilesX;
        return colors(tile, true) == other.colors(tile, true) && colors(tile - 1, x > 0) == other.colors(tile - 1, x > 0)
                && colors(tile + 1, x + 1 < tilesX) == other.colors(tile + 1, x + 1 < tilesX)
                && colors(tile - tilesX, true) == other.colors(tile - tilesX, true)
                && colors(tile + tilesX, true) == other.colors(tile + tilesX, true);
    }

    /** Returns the packed colors of a tile; null outside the picture. */
    private int @Nullable [] colors(int tile, boolean inside) {
        return inside && tile >= 0 && tile < tiles.length ? tiles[tile].colors() : null;
    }

    /** Returns the pixels of a tile at an edge, as ascending indices in the tile. */
    public short[] edges(int tile) {
        int tilesX = Film.tilesAlong(width);
        int x0 = tile % tilesX * SIDE;
        int y0 = tile / tilesX * SIDE;
        int columns = Math.min(SIDE, width - x0);
        int lines = Math.min(SIDE, height - y0);
        int[] own = tiles[tile].colors();
        int[] left = colors(tile - 1, x0 > 0);
        int[] right = colors(tile + 1, x0 + SIDE < width);
        int[] above = colors(tile - tilesX, true);
        int[] below = colors(tile + tilesX, true);
        short[] found = new short[Film.TILE_PIXELS];
        int count = 0;
        for (int y = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                int i = y * SIDE + x;
                boolean isEdge = differ(own, i, x > 0 ? own : left, x > 0 ? i - 1 : i + SIDE - 1)
                        || differ(own, i, x + 1 < columns ? own : right, x + 1 < columns ? i + 1 : i - x)
                        || differ(own, i, y > 0 ? own : above, y > 0 ? i - SIDE : i + (SIDE - 1) * SIDE)
                        || differ(own, i, y + 1 < lines ? own : below, y + 1 < lines ? i + SIDE : x);
                if (isEdge) {
                    found[count++] = (short) i;
                }
            }
        }
        return Arrays.copyOf(found, count);
    }

    /** @param neighbor colors of the neighbor's tile; null if it is outside the picture */
    private static boolean differ(int[] own, int i, int @Nullable [] neighbor, int at) {
        return neighbor != null && EdgeColors.differ(own[i], neighbor[at]);
    }
}
