package lightning.render.cache;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.render.image.Film;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Pixel cache of an image, with the scenes that it shows.
 *
 * <p>The first level and the reflection levels may show different scenes, because reflections are updated on demand (paper
 * §4.8). Layers of lights that are off may be older than the scene: the stamp of each light identifies their inputs.
 */
public final class PixelCache {
    private final Geometry geometry;
    private final CachedTile[] tiles;
    private final FineTile[] fineTiles;
    private final RenderedScenes scenes;
    private final List<CachedLight> lights;
    private final List<CachedLight> mirroredLights;
    private final @Nullable IndirectCache indirect;
    private final @Nullable IndirectCache mirroredIndirect;

    /**
     * @param tiles pixel centers; empty if all pixels have several samples
     * @param fineTiles finer samples of each tile; empty without anti-aliasing
     * @param scenes scene of the film and the first level, and scene of the reflection levels and Cr
     * @param lights all lights of the scene, in order
     * @param mirroredLights all lights of the reflected scene, in order
     * @param indirect indirect light of the scene
     * @param mirroredIndirect indirect light of the reflected scene
     */
    public PixelCache(Geometry geometry, CachedTile[] tiles, FineTile[] fineTiles, RenderedScenes scenes, List<CachedLight> lights,
            List<CachedLight> mirroredLights, @Nullable IndirectCache indirect, @Nullable IndirectCache mirroredIndirect) {
        this.geometry = geometry;
        this.tiles = tiles;
        this.fineTiles = fineTiles;
        this.scenes = scenes;
        this.lights = List.copyOf(lights);
        this.mirroredLights = List.copyOf(mirroredLights);
        this.indirect = indirect;
        this.mirroredIndirect = mirroredIndirect;
    }

    /** Returns the geometry with the materials of the first level. */
    public Geometry geometry() {
        return geometry;
    }

    /** Returns the geometry with the materials of the reflection levels. */
    public Geometry mirroredGeometry() {
        return geometry.withMaterialsOf(scenes.mirrored());
    }

    /** Returns the number of tiles of pixel centers; 0 if all pixels have several samples. */
    public int tileCount() {
        return tiles.length;
    }

    /** Returns the pixel centers of a tile. */
    public CachedTile tile(int index) {
        return tiles[index];
    }

    /** Returns the pixel centers of all tiles; empty if all pixels have several samples. */
    public CachedTile[] tiles() {
        return tiles.clone();
    }

    /** Returns the number of tiles of finer samples; 0 without anti-aliasing. */
    public int fineCount() {
        return fineTiles.length;
    }

    /** Returns the finer samples of a tile. */
    public FineTile fineTile(int index) {
        return fineTiles[index];
    }

    /** Returns all rows: those of pixel centers and of finer samples. */
    public List<CachedTile> allTiles() {
        List<CachedTile> result = new ArrayList<>(List.of(tiles));
        for (FineTile tile : fineTiles) {
            tile.blocks().map(SampleBlock::rows).forEach(result::add);
        }
        return result;
    }

    /** Returns the scene of the film. */
    public Scene scene() {
        return scenes.scene();
    }

    /** Returns whether mirror images show the same scene as the rest. */
    public boolean hasCurrentReflections() {
        return mirroredScene().equals(scene());
    }

    /** Returns the scene of the reflections. */
    public Scene mirroredScene() {
        return scenes.mirrored();
    }

    /** Returns the scenes of the film and of the reflections. */
    public RenderedScenes scenes() {
        return scenes;
    }

    /** Returns the lights of the scene, in order, with the stamps of their first-level layers. */
    public List<CachedLight> lights() {
        return lights;
    }

    /** Returns the lights of the reflected scene, in order, with the stamps of their layers in reflection levels. */
    public List<CachedLight> mirroredLights() {
        return mirroredLights;
    }

    /** Returns the indirect light of the scene; null if it has none. */
    public @Nullable IndirectCache indirect() {
        return indirect;
    }

    /** Returns the indirect light of the reflected scene; null if it has none. */
    public @Nullable IndirectCache mirroredIndirect() {
        return mirroredIndirect;
    }

    /** Returns the image as a view of the tiles' arrays. */
    public Film film() {
        int count = Math.max(tiles.length, fineTiles.length);
        float[][] red = new float[count][];
        float[][] green = new float[count][];
        float[][] blue = new float[count][];
        for (int i = 0; i < count; i++) {
            float[][] film = fineTiles.length > 0 ? fineTiles[i].film() : tiles[i].film;
            assert film != null;
            red[i] = film[0];
            green[i] = film[1];
            blue[i] = film[2];
        }
        return new Film(scene().picture().width(), scene().picture().height(), red, green, blue);
    }

    /** Returns the maximum of all stored colors of centers and samples, linear. */
    public float maxValue() {
        float max = 0;
        for (CachedTile tile : allTiles()) {
            max = Math.max(max, tile.maxValue());
        }
        return max;
    }

    /** Returns the bytes of the stored colors of all centers and samples, without the film. */
    public long colorBytes() {
        return allTiles().stream().mapToLong(CachedTile::colorBytes).sum()
                + Arrays.stream(fineTiles).flatMap(FineTile::blocks).mapToLong(SampleBlock::meanBytes).sum();
    }

    /** Returns the bytes of all rows, without colors. */
    public long bytes() {
        return allTiles().stream().mapToLong(CachedTile::bytes).sum() + indirectBytes();
    }

    /** Returns the bytes of the pixel centers: rows and colors. */
    public long centerBytes() {
        long bytes = 0;
        for (CachedTile tile : tiles) {
            bytes += tile.bytes() + tile.colorBytes();
        }
        return bytes;
    }

    /** Returns the bytes of indirect light, without the weights of rows. */
    public long indirectBytes() {
        return (indirect == null ? 0 : indirect.bytes())
                + (mirroredIndirect == null || mirroredIndirect == indirect ? 0 : mirroredIndirect.bytes());
    }

    /** Returns the number of hit rows of all samples and levels. */
    public long rowCount() {
        return allTiles().stream().mapToLong(CachedTile::rowCount).sum();
    }
}
