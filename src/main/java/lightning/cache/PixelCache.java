package lightning.cache;

import lightning.image.Film;
import lightning.scene.Scene;
import lightning.trace.Geometry;

/**
 * Everything kept of a picture, and which scene it shows.
 *
 * <p>The first level and the mirror levels may show different scenes, because reflections are updated
 * on demand (paper §4.8). A layer may be older than its scene where its light does not shine: the
 * stamps tell for which light each layer was computed.
 */
public final class PixelCache {
    private final Geometry geometry;
    private final CachedTile[] tiles;
    private final Scene scene;
    private final Scene mirroredScene;
    private final LayerStamp[] stamps;
    private final LayerStamp[] mirroredStamps;

    /**
     * @param scene          what the film and the first level show
     * @param mirroredScene  what the mirror levels and Cr show
     * @param stamps         for each light of {@code scene} the light that its layer was computed for,
     *                       null where there is no layer
     * @param mirroredStamps the same for {@code mirroredScene}
     */
    public PixelCache(Geometry geometry, CachedTile[] tiles, Scene scene, Scene mirroredScene, LayerStamp[] stamps,
            LayerStamp[] mirroredStamps) {
        this.geometry = geometry;
        this.tiles = tiles;
        this.scene = scene;
        this.mirroredScene = mirroredScene;
        this.stamps = stamps;
        this.mirroredStamps = mirroredStamps;
    }

    public Geometry geometry() {
        return geometry;
    }

    public int tileCount() {
        return tiles.length;
    }

    public CachedTile tile(int index) {
        return tiles[index];
    }

    public Scene scene() {
        return scene;
    }

    public Scene mirroredScene() {
        return mirroredScene;
    }

    /** The light that layer {@code l} of the first level was computed for, or null. */
    public LayerStamp stamp(int l) {
        return stamps[l];
    }

    /** The light that layer {@code l} of the mirror levels was computed for, or null. */
    public LayerStamp mirroredStamp(int l) {
        return mirroredStamps[l];
    }

    /** The stamps of all layers of the first level. */
    public LayerStamp[] stamps() {
        return stamps.clone();
    }

    /** The stamps of all layers of the mirror levels. */
    public LayerStamp[] mirroredStamps() {
        return mirroredStamps.clone();
    }

    /** The picture, over the tiles' own arrays. */
    public Film film() {
        float[][] red = new float[tiles.length][];
        float[][] green = new float[tiles.length][];
        float[][] blue = new float[tiles.length][];
        for (int i = 0; i < tiles.length; i++) {
            red[i] = tiles[i].film[0];
            green[i] = tiles[i].film[1];
            blue[i] = tiles[i].film[2];
        }
        return new Film(scene.picture().width(), scene.picture().height(), red, green, blue);
    }

    /** The largest value of the film, linear. */
    public float brightest() {
        float brightest = 0;
        for (CachedTile tile : tiles) {
            brightest = Math.max(brightest, tile.brightest());
        }
        return brightest;
    }

    /** The bytes of all tiles, the film left out. */
    public long bytes() {
        long bytes = 0;
        for (CachedTile tile : tiles) {
            bytes += tile.bytes();
        }
        return bytes;
    }

    /** The hit rows of all tiles and levels. */
    public long rowCount() {
        long rows = 0;
        for (CachedTile tile : tiles) {
            rows += tile.rowCount();
        }
        return rows;
    }
}
