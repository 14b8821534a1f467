package lightning.shot.cluster;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import lightning.render.image.Film;
import lightning.shot.cluster.wire.Message;

/** Binary format of film tiles: for each tile all red, all green, all blue, as big-endian floats. */
final class FilmTiles {
    /** Bytes of a tile. */
    static final int TILE_BYTES = 3 * Film.TILE_PIXELS * Float.BYTES;
    /** Maximum number of tiles in one message. */
    static final int MAX_TILES = Message.PART_BYTES / TILE_BYTES;

    private FilmTiles() {}

    /** @return empty if the film does not have these tiles, or they are too many */
    static byte[] encode(Film film, int first, int count) {
        if (count > MAX_TILES || (long) first + count > film.tileCount()) {
            return new byte[0];
        }
        ByteBuffer bytes = ByteBuffer.allocate(count * TILE_BYTES);
        FloatBuffer floats = bytes.asFloatBuffer();
        for (int tile = first; tile < first + count; tile++) {
            floats.put(film.red(tile)).put(film.green(tile)).put(film.blue(tile));
        }
        return bytes.array();
    }

    /**
     * Decodes tiles into a film that is not shown yet.
     *
     * @return whether the bytes match the number of tiles
     */
    static boolean decode(byte[] bytes, Film film, int first, int count) {
        if (bytes.length != count * TILE_BYTES) {
            return false;
        }
        FloatBuffer floats = ByteBuffer.wrap(bytes).asFloatBuffer();
        for (int tile = first; tile < first + count; tile++) {
            floats.get(film.red(tile)).get(film.green(tile)).get(film.blue(tile));
        }
        return true;
    }
}
