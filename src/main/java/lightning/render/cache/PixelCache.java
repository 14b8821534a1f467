package lightning.render.cache;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.render.image.Film;
import lightning.render.shading.FilmParts;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Pixel cache of an image, with the scenes that it shows.
 *
 * <p>The first level and the reflection levels may show different scenes, because reflections are updated on demand (paper
 * §4.8). Layers of lights that are off may be older than the scene: the stamp of each light identifies their inputs.
 *
 * @param geometry        geometry with the materials of the first level
 * @param tiles           pixel centers; empty if all pixels have several samples
 * @param fineTiles       finer samples of each tile; empty without anti-aliasing
 * @param shown           scene of the film and the first level
 * @param mirrored        scene of the reflection levels and Cr
 * @param containsWeights whether layers and gathered light contain the weights of lights, as the method of 1998 stores them
 */
public record PixelCache(Geometry geometry, CachedTile[] tiles, FineTile[] fineTiles, CachedScene shown, CachedScene mirrored,
        boolean containsWeights) {
    /** Returns the geometry with the materials of the reflection levels. */
    public Geometry mirroredGeometry() {
        return geometry.withMaterialsOf(mirrored.scene());
    }

    /** Returns the films of the scene, as its layers contain them. */
    public FilmParts parts() {
        return FilmParts.of(shown.scene(), containsWeights);
    }

    /** Returns the films of the scene that mirrors show. */
    public FilmParts mirroredParts() {
        return FilmParts.of(mirrored.scene(), containsWeights);
    }

    /** Returns the same pixel centers with other finer samples; none for an empty array. */
    public PixelCache withFineTiles(FineTile[] fine) {
        return new PixelCache(geometry, tiles, fine, shown, mirrored, containsWeights);
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
        return shown.scene();
    }

    /** Returns the indirect light of the scene of the film; null if it has none. */
    public @Nullable IndirectCache indirect() {
        return shown.indirect();
    }

    /** Returns whether mirror images show the same scene as the rest. */
    public boolean hasCurrentReflections() {
        return mirrored.scene().hasSameImage(shown.scene());
    }

    /** Returns whether what mirrors show is a film of its own: they visibly show an earlier scene. */
    public boolean areMirrorsOutdated() {
        return !scenes().areReflectionsCurrent();
    }

    /** Returns whether mirror images show the same scene by the same indirect light. */
    public boolean hasSameIndirectInMirrors() {
        return mirrored.indirect() == shown.indirect() && hasCurrentReflections();
    }

    /** Returns the scenes of the film and of the reflections. */
    public RenderedScenes scenes() {
        return new RenderedScenes(shown.scene(), mirrored.scene());
    }

    /** Returns the image as a view of the tiles' arrays. */
    public Film film() {
        int count = Math.max(tiles.length, fineTiles.length);
        float[][] red = new float[count][];
        float[][] green = new float[count][];
        float[][] blue = new float[count][];
        for (int i = 0; i < count; i++) {
            float[][] film = fineTiles.length > 0 ? fineTiles[i].film() : tiles[i].film();
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
        return allTiles().stream().mapToLong(CachedTile::colorBytes).sum() + sampleFilmBytes();
    }

    /** Returns the bytes of the films of finer samples. */
    public long sampleFilmBytes() {
        return Arrays.stream(fineTiles).mapToLong(tile -> tile.blocks().mapToLong(SampleBlock::meanBytes).sum() + tile.filmBytes()).sum();
    }

    /** Returns the bytes of the films that pixel centers keep. */
    public long centerFilmBytes() {
        return Arrays.stream(tiles).mapToLong(tile -> tile.films() == null ? 0 : tile.films().bytes()).sum();
    }

    /** Returns whether any tile keeps the films of its centers. */
    public boolean keepsFilms() {
        return Arrays.stream(tiles).anyMatch(tile -> tile.films() != null);
    }

    /** Returns the bytes of all rows, without colors. Visits all layers, so it takes as long as a small update. */
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
        return (shown.indirect() == null ? 0 : shown.indirect().bytes())
                + (mirrored.indirect() == null || mirrored.indirect() == shown.indirect() ? 0 : mirrored.indirect().bytes());
    }

    /** Returns the number of hit rows of all samples and levels. */
    public long rowCount() {
        return allTiles().stream().mapToLong(CachedTile::rowCount).sum();
    }
}
