package lightning.render.image;

/**
 * Linear, unclamped picture, stored in square tiles so that a renderer can write tiles in parallel and an editor can refresh only
 * the changed ones.
 *
 * <p>Tile number {@code tile = tileY * tilesX() + tileX} holds the pixels with {@code x / 32 == tileX} and {@code y / 32 == tileY};
 * inside it, pixel (x, y) is at index {@code (y & 31) * 32 + (x & 31)}. Tiles at the right and bottom border are full-size arrays
 * too; their pixels outside the picture are unused and undefined.
 *
 * <p>A film does not copy its arrays. A renderer never writes to a film that it returned: an update creates a new film, which
 * shares the tiles that did not change.
 */
public final class Film {

    /** Width and height of a tile in pixels. */
    public static final int TILE_SIZE = 32;

    /** Number of pixels of a tile. */
    public static final int TILE_PIXELS = TILE_SIZE * TILE_SIZE;

    private final int width;
    private final int height;
    private final int tilesX;
    private final int tilesY;
    private final float[][] red;
    private final float[][] green;
    private final float[][] blue;

    /**
     * Creates a film over the given arrays without copying them.
     *
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     * @param red    {@code float[tileCount][TILE_PIXELS]}, linear
     * @param green  as {@code red}
     * @param blue   as {@code red}
     * @throws IllegalArgumentException if a size is below 1, or an array does not have the shape that the size requires
     */
    public Film(int width, int height, float[][] red, float[][] green, float[][] blue) {
        this.width = width;
        this.height = height;
        this.tilesX = tilesAlong(width);
        this.tilesY = tilesAlong(height);
        requireShape("red", red);
        requireShape("green", green);
        requireShape("blue", blue);
        this.red = red;
        this.green = green;
        this.blue = blue;
    }

    /**
     * Creates a black film with its own arrays.
     *
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     * @throws IllegalArgumentException if a size is below 1
     */
    public static Film black(int width, int height) {
        int tiles = Math.multiplyExact(tilesAlong(width), tilesAlong(height));
        return new Film(width, height, new float[tiles][TILE_PIXELS], new float[tiles][TILE_PIXELS],
                new float[tiles][TILE_PIXELS]);
    }

    /**
     * Creates a film from scanlines.
     *
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     * @param rgb    {@code float[width * height * 3]}, interleaved linear RGB, the top row first
     * @throws IllegalArgumentException if a size is below 1 or {@code rgb} does not have the required length
     */
    public static Film ofScanlines(int width, int height, float[] rgb) {
        Film film = black(width, height);
        if (rgb.length != 3L * width * height) {
            throw new IllegalArgumentException("a film of " + width + " × " + height + " pixels needs "
                    + 3L * width * height + " values, not " + rgb.length);
        }
        for (int y = 0, at = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int tile = film.tileOf(x, y);
                int pixel = pixelInTile(x, y);
                film.red[tile][pixel] = rgb[at++];
                film.green[tile][pixel] = rgb[at++];
                film.blue[tile][pixel] = rgb[at++];
            }
        }
        return film;
    }

    /** Returns the width in pixels. */
    public int width() {
        return width;
    }

    /** Returns the height in pixels. */
    public int height() {
        return height;
    }

    /** Returns the number of tiles in a row. */
    public int tilesX() {
        return tilesX;
    }

    /** Returns the number of rows of tiles. */
    public int tilesY() {
        return tilesY;
    }

    /** Returns the number of all tiles. */
    public int tileCount() {
        return tilesX * tilesY;
    }

    /** Returns the red values of a tile: the film's own {@code float[TILE_PIXELS]}, linear. */
    public float[] red(int tile) {
        return red[tile];
    }

    /** Returns the green values of a tile: the film's own {@code float[TILE_PIXELS]}, linear. */
    public float[] green(int tile) {
        return green[tile];
    }

    /** Returns the blue values of a tile: the film's own {@code float[TILE_PIXELS]}, linear. */
    public float[] blue(int tile) {
        return blue[tile];
    }

    /** Returns the linear red of pixel (x, y); 0 ≤ x &lt; width, 0 ≤ y &lt; height. */
    public float red(int x, int y) {
        return red[tileOf(x, y)][pixelInTile(x, y)];
    }

    /** Returns the linear green of pixel (x, y); 0 ≤ x &lt; width, 0 ≤ y &lt; height. */
    public float green(int x, int y) {
        return green[tileOf(x, y)][pixelInTile(x, y)];
    }

    /** Returns the linear blue of pixel (x, y); 0 ≤ x &lt; width, 0 ≤ y &lt; height. */
    public float blue(int x, int y) {
        return blue[tileOf(x, y)][pixelInTile(x, y)];
    }

    /**
     * Returns the number of tiles along a side.
     *
     * @param pixels length of the side
     * @throws IllegalArgumentException if that is less than 1
     */
    public static int tilesAlong(int pixels) {
        if (pixels < 1) {
            throw new IllegalArgumentException("a film is at least 1 × 1 pixel, not " + pixels);
        }
        return (pixels - 1) / TILE_SIZE + 1;
    }

    /** Returns the number of the tile that holds pixel (x, y). */
    public int tileOf(int x, int y) {
        return (y / TILE_SIZE) * tilesX + x / TILE_SIZE;
    }

    /** Returns the index of pixel (x, y) inside its tile. */
    public static int pixelInTile(int x, int y) {
        return (y & (TILE_SIZE - 1)) * TILE_SIZE + (x & (TILE_SIZE - 1));
    }

    /** Returns an equal film with its own arrays. */
    public Film copy() {
        return new Film(width, height, copyOf(red), copyOf(green), copyOf(blue));
    }

    /** Returns the visible pixels as {@code float[width * height * 3]}: interleaved linear RGB, the top row first. */
    public float[] toScanlines() {
        float[] rgb = new float[Math.multiplyExact(Math.multiplyExact(width, height), 3)];
        for (int y = 0, at = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int tile = tileOf(x, y);
                int pixel = pixelInTile(x, y);
                rgb[at++] = red[tile][pixel];
                rgb[at++] = green[tile][pixel];
                rgb[at++] = blue[tile][pixel];
            }
        }
        return rgb;
    }

    /**
     * Returns whether both films have the same size and the same bits in every visible pixel: 0 differs from −0, and a NaN equals
     * only a NaN with the same payload.
     */
    public boolean hasSameBits(Film other) {
        if (width != other.width || height != other.height) {
            return false;
        }
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int tile = tileOf(x, y);
                int pixel = pixelInTile(x, y);
                if (!hasSameBits(red[tile][pixel], other.red[tile][pixel])
                        || !hasSameBits(green[tile][pixel], other.green[tile][pixel])
                        || !hasSameBits(blue[tile][pixel], other.blue[tile][pixel])) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean hasSameBits(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }

    private static float[][] copyOf(float[][] tiles) {
        float[][] copy = new float[tiles.length][];
        for (int tile = 0; tile < tiles.length; tile++) {
            copy[tile] = tiles[tile].clone();
        }
        return copy;
    }

    private void requireShape(String name, float[][] tiles) {
        if (tiles.length != tileCount()) {
            throw new IllegalArgumentException("a film of " + width + " × " + height + " pixels has " + tileCount()
                    + " tiles, but " + name + " has " + tiles.length);
        }
        for (int tile = 0; tile < tiles.length; tile++) {
            if (tiles[tile].length != TILE_PIXELS) {
                throw new IllegalArgumentException("a tile has " + TILE_PIXELS + " pixels, but tile " + tile + " of "
                        + name + " has " + tiles[tile].length);
            }
        }
    }
}
