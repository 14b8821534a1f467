package lightning.render.relight;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Function;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.relight.tile.TileRecomposer;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.SamplePositions;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.World;

/**
 * What one light gives to a picture: the picture that is left when all other lights, the ambience and the background are
 * taken away, in the mirrors too. The shares of all lights and that of the ambience and the background add up to the
 * picture, but for rounding.
 */
public final class LightImage {
    private LightImage() {}

    /**
     * The scene whose picture is a light's share. A light that is off, or that another's solo darkens, has a black one.
     *
     * @param light the name; all is black where no light has it
     */
    public static Scene scene(Scene scene, String light) {
        List<Light> lights = new ArrayList<>();
        for (Light l : scene.lights()) {
            // A solo light that is switched off darkens nobody any more.
            lights.add(l.name().equals(light) && scene.isActive(l) ? l : l.withOn(false));
        }
        return new Scene(scene.picture(), scene.camera(), new World(0, Rgb.BLACK), scene.stage(), scene.rig().withLights(lights));
    }

    /**
     * The share in a picture, from what is known of it; in mirrors it is the share in the scene that they show.
     *
     * @throws IllegalStateException if mirror levels are not kept as rows
     * @throws CancellationException if {@code progress} asked to stop
     */
    static Film film(PixelCache cache, RenderOptions options, String light, WorkerPool workers, Progress progress) {
        Scene scene = scene(cache.scene(), light);
        WeightedLight[] top = WeightedLight.ofScene(scene);
        WeightedLight[] mirrors = WeightedLight.ofScene(scene(cache.mirroredScene(), light));
        List<EngineWorkers<TileRecomposer>> painters = EngineWorkers.perThread(workers.count(), options.engines(),
                engine -> new TileRecomposer(cache, engine, options.view()));
        int perPixel = scene.picture().sampling().samplesPerPixel();
        float[][][] films = new float[Math.max(cache.tileCount(), cache.fineCount())][][];
        workers.run(films.length, (worker, i) -> {
            Function<CachedTile, float[][]> share = tile -> tileImage(tile, painters.get(worker).forTile(i), top, mirrors, scene);
            CachedTile center = cache.tileCount() == 0 ? null : cache.tile(i);
            films[i] = cache.fineCount() == 0 ? share.apply(center) : cache.fineTile(i).film(center, share, perPixel);
        }, progress);
        return film(scene, films);
    }

    private static float[][] tileImage(CachedTile tile, TileRecomposer painter, WeightedLight[] top, WeightedLight[] mirrors, Scene scene) {
        if (!tile.storesRows()) {
            throw new IllegalStateException("mirror levels are stored as hit shapes");
        }
        // The share has no environment, whose colors alone would ask where the rays go.
        return painter.composeFilm(tile.levels[0], top, scene, SamplePositions.centers(0, 0),
                painter.composeImages(tile.levels, mirrors, scene.world()));
    }

    private static Film film(Scene scene, float[][][] tiles) {
        float[][][] channels = new float[3][tiles.length][];
        for (int i = 0; i < tiles.length; i++) {
            for (int c = 0; c < 3; c++) {
                channels[c][i] = tiles[i][c];
            }
        }
        return new Film(scene.picture().width(), scene.picture().height(), channels[0], channels[1], channels[2]);
    }
}
