package lightning.render.shading;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.render.image.Film;

/** Finds the pixels that anti-aliasing samples: those with a different neighbor to the left, right, top or bottom. */
public final class EdgeDetector {
    private static final int SIDE = Film.TILE_SIZE;

    private final int width;
    private final int height;
    private final int tilesX;
    private final EdgeCodes[] codes;

    /**
     * @param width  width of the picture in pixels
     * @param height height of the picture in pixels
     * @param codes  codes of its tiles, in the film's order; read on request
     */
    public EdgeDetector(int width, int height, EdgeCodes[] codes) {
        this.width = width;
        this.height = height;
        this.codes = codes;
        tilesX = (width - 1) / SIDE + 1;
    }

    /** Returns all pixels of a tile of a picture of the given size, as ascending indices in the tile. */
    public static short[] allPixels(int width, int height, int tile) {
        int tilesX = (width - 1) / SIDE + 1;
        int columns = Math.min(SIDE, width - tile % tilesX * SIDE);
        int lines = Math.min(SIDE, height - tile / tilesX * SIDE);
        short[] all = new short[columns * lines];
        for (int i = 0; i < all.length; i++) {
            all[i] = (short) (i / columns * SIDE + i % columns);
        }
        return all;
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

    /** Returns whether another detector finds the same edges in a tile because both read the same codes. */
    public boolean hasSameEdges(int tile, EdgeDetector other) {
        int x = tile % tilesX;
        return codes[tile] == other.codes[tile] && neighbor(tile, -1, x > 0) == other.neighbor(tile, -1, x > 0)
                && neighbor(tile, 1, x + 1 < tilesX) == other.neighbor(tile, 1, x + 1 < tilesX)
                && neighbor(tile, -tilesX, true) == other.neighbor(tile, -tilesX, true)
                && neighbor(tile, tilesX, true) == other.neighbor(tile, tilesX, true);
    }

    private EdgeCodes neighbor(int tile, int step, boolean inside) {
        int other = tile + step;
        return inside && other >= 0 && other < codes.length ? codes[other] : null;
    }

    /** Returns the pixels of a tile at a shape edge, as ascending indices in the tile. */
    public short[] shapeEdges(int tile) {
        return edges(tile, true, false);
    }

    /** Returns the pixels of a tile at a light edge but not at a shape edge, as ascending indices in the tile. */
    public short[] lightEdges(int tile) {
        return edges(tile, false, true);
    }

    /** Returns the pixels of a tile at any edge, as ascending indices in the tile. */
    public short[] edges(int tile) {
        return edges(tile, true, true);
    }

    private short[] edges(int tile, boolean includesShapes, boolean includesLights) {
        int x0 = tile % tilesX * SIDE;
        int y0 = tile / tilesX * SIDE;
        int columns = Math.min(SIDE, width - x0);
        int lines = Math.min(SIDE, height - y0);
        EdgeCodes own = codes[tile];
        EdgeCodes left = neighbor(tile, -1, x0 > 0);
        EdgeCodes right = neighbor(tile, 1, x0 + SIDE < width);
        EdgeCodes above = neighbor(tile, -tilesX, true);
        EdgeCodes below = neighbor(tile, tilesX, true);
        short[] found = new short[Film.TILE_PIXELS];
        int count = 0;
        for (int y = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                int i = y * SIDE + x;
                boolean shape = differsFromNeighbor(own.shapes(), i, x, y, columns, lines, shapes(left), shapes(right), shapes(above),
                        shapes(below));
                boolean target = shape ? includesShapes : includesLights
                        && differsFromNeighbor(own.lights(), i, x, y, columns, lines, lights(left), lights(right), lights(above),
                                lights(below));
                if (target) {
                    found[count++] = (short) i;
                }
            }
        }
        return Arrays.copyOf(found, count);
    }

    private static int[] shapes(EdgeCodes codes) {
        return codes == null ? null : codes.shapes();
    }

    private static int[] lights(EdgeCodes codes) {
        return codes == null ? null : codes.lights();
    }

    private static boolean differsFromNeighbor(int[] own, int i, int x, int y, int columns, int lines, int[] left, int[] right, int[] above,
            int[] below) {
        int code = own[i];
        boolean toLeft = x > 0 ? own[i - 1] != code : left != null && left[i + SIDE - 1] != code;
        boolean toRight = x + 1 < columns ? own[i + 1] != code : right != null && right[i - x] != code;
        boolean toTop = y > 0 ? own[i - SIDE] != code : above != null && above[i + (SIDE - 1) * SIDE] != code;
        boolean toBottom = y + 1 < lines ? own[i + SIDE] != code : below != null && below[x] != code;
        return toLeft || toRight || toTop || toBottom;
    }
}
