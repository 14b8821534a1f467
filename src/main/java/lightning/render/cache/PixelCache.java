package lightning.render.cache;

import java.util.ArrayList;
import java.util.List;
import lightning.render.image.Film;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Everything kept of a picture, and which scene it shows.
 *
 * <p>The first level and the mirror levels may show different scenes, because reflections are updated
 * on demand (paper §4.8). A layer may be older than its scene where its light does not shine: each
 * light tells what its layers were computed for.
 */
public final class PixelCache {
    private final Geometry geometry;
    private final CachedTile[] tiles;
    private final FineTile[] fineTiles;
    private final RenderedScenes scenes;
    private final List<CachedLight> lights;
    private final List<CachedLight> mirroredLights;

    /**
     * @param tiles          the pixels' centers; none where all pixels have several samples
     * @param fineTiles           finer samples of each tile; none without anti-aliasing
     * @param scenes          what the film and the first level show, and what the mirror levels and Cr show
     * @param lights         all lights of the scene, in its order
     * @param mirroredLights the same of the mirrored scene
     */
    public PixelCache(Geometry geometry, CachedTile[] tiles, FineTile[] fineTiles, RenderedScenes scenes, List<CachedLight> lights,
            List<CachedLight> mirroredLights) {
        this.geometry = geometry;
        this.tiles = tiles;
        this.fineTiles = fineTiles;
        this.scenes = scenes;
        this.lights = List.copyOf(lights);
        this.mirroredLights = List.copyOf(mirroredLights);
    }

    /** With the materials of the first level. */
    public Geometry geometry() {
        return geometry;
    }

    /** The same shapes with the materials that mirrors show. */
    public Geometry mirroredGeometry() {
        return geometry.withMaterialsOf(scenes.mirrored());
    }

    /** How many tiles of pixels' centers there are: none where all pixels have several samples. */
    public int tileCount() {
        return tiles.length;
    }

    /** The centers of a tile's pixels. */
    public CachedTile tile(int index) {
        return tiles[index];
    }

    /** The centers of all tiles' pixels; none where all pixels have several samples. */
    public CachedTile[] tiles() {
        return tiles.clone();
    }

    /** How many tiles of finer samples there are: none without anti-aliasing. */
    public int fineCount() {
        return fineTiles.length;
    }

    /** The finer samples of a tile. */
    public FineTile fineTile(int index) {
        return fineTiles[index];
    }

    /** All rows there are: the pixels' centers and all finer samples. */
    public List<CachedTile> allTiles() {
        List<CachedTile> result = new ArrayList<>(List.of(tiles));
        for (FineTile tile : fineTiles) {
            result.addAll(List.of(tile.shapes().blocks()));
            result.addAll(List.of(tile.lights().blocks()));
        }
        return result;
    }

    /** What the film shows. */
    public Scene scene() {
        return scenes.scene();
    }

    /** What mirrors show. */
    public Scene mirroredScene() {
        return scenes.mirrored();
    }

    /** What the film and the mirrors show. */
    public RenderedScenes scenes() {
        return scenes;
    }

    /** The lights of the scene, in its order, and what their layers of the first level were computed for. */
    public List<CachedLight> lights() {
        return lights;
    }

    /** The lights of the mirrored scene, in its order, and what their layers of the mirror levels were computed for. */
    public List<CachedLight> mirroredLights() {
        return mirroredLights;
    }

    /** The picture, over the tiles' own arrays. */
    public Film film() {
        int count = Math.max(tiles.length, fineTiles.length);
        float[][] red = new float[count][];
        float[][] green = new float[count][];
        float[][] blue = new float[count][];
        for (int i = 0; i < count; i++) {
            float[][] film = fineTiles.length > 0 ? fineTiles[i].film() : tiles[i].film;
            red[i] = film[0];
            green[i] = film[1];
            blue[i] = film[2];
        }
        return new Film(scene().picture().width(), scene().picture().height(), red, green, blue);
    }

    /** The largest value of all centers and samples whose colors are kept, linear. */
    public float maxValue() {
        float max = 0;
        for (CachedTile tile : allTiles()) {
            max = Math.max(max, tile.maxValue());
        }
        return max;
    }

    /** The bytes of the colors of all centers and samples, as far as they are kept; those of the film are left out. */
    public long colorBytes() {
        return allTiles().stream().mapToLong(CachedTile::colorBytes).sum();
    }

    /** The bytes of all rows; colors are left out. */
    public long bytes() {
        return allTiles().stream().mapToLong(CachedTile::bytes).sum();
    }

    /** The hit rows of all samples and levels. */
    public long rowCount() {
        return allTiles().stream().mapToLong(CachedTile::rowCount).sum();
    }
}
