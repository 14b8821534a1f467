package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BiFunction;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.CachedTile;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.relight.tile.SurfelSolver;
import lightning.render.relight.tile.TileRecomposer;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.FogComposer;
import lightning.render.trace.Geometry;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.material.Bulb;
import org.jspecify.annotations.Nullable;

/**
 * Image of one light's contribution: the picture without all other lights, the ambience, the glow of materials and the background, in
 * mirrors too. Apart from rounding, the images of all lights and that of ambience, glow and background add up to the picture.
 */
public final class LightImage {
    private LightImage() {}

    /**
     * Returns the scene whose picture is a light's contribution; black if the light is off or muted by a solo light. An environment stays,
     * without light, so that gathering rays are those of the picture.
     *
     * @param light name of the light; the picture is black if no light has it
     */
    public static Scene scene(Scene scene, String light) {
        List<Light> lights = new ArrayList<>();
        for (Light l : scene.lights()) {
            // A solo light that is switched off mutes no light.
            Light shown = l.name().equals(light) && scene.isActive(l) ? l : l.withOn(false);
            boolean hasFace = l.area().visibility() != FaceVisibility.HIDDEN;
            lights.add(hasFace ? shown.withArea(l.area().withVisibility(FaceVisibility.BLACK)) : shown);
        }
        Stage stage =
                scene.stage().withMaterials(scene.materials().stream()
                        .map(m -> m.glow().isBlack() && m.bulb().light().isEmpty() ? m : m.withGlow(Rgb.BLACK).withBulb(Bulb.NONE))
                        .toList());
        return new Scene(scene.picture(), scene.camera(), unlit(scene.world()), stage, scene.rig().withLights(lights));
    }

    /** Returns a world without light of its own; an environment stays, and is dark. */
    private static World unlit(World world) {
        return world.withAmbience(0).withBackground(Rgb.BLACK).mapIntensities(_ -> 0).withFog(world.fog().withAmbient(Rgb.BLACK));
    }

    /** Returns the world by whose values a contribution is composed: without the dark environment, whose colors would need ray directions. */
    public static World darkWorld(World world) {
        return unlit(world).withoutEnvironments();
    }

    /** Returns the scene by whose values a contribution is composed, with its {@link #darkWorld}. */
    private static Scene composedScene(Scene scene, String light) {
        Scene one = scene(scene, light);
        return one.withWorld(darkWorld(scene.world()));
    }

    /**
     * Composes the contribution from the cache of a picture, with the light's indirect light; in mirrors it is the contribution to the
     * mirrored scene.
     *
     * @throws IllegalStateException if mirror levels are not stored as rows
     * @throws CancellationException if {@code progress} requested cancellation
     */
    static Film film(PixelCache cache, RenderOptions options, String light, WorkerPool workers, Progress progress) {
        Scene scene = composedScene(cache.scene(), light);
        WeightedLight[] top = WeightedLight.ofScene(scene);
        WeightedLight[] mirrors = WeightedLight.ofScene(composedScene(cache.mirrored().scene(), light));
        float[][] indirect = indirect(cache.indirect(), cache.geometry(), top, options, workers, progress);
        float[][] mirroredIndirect = cache.hasSameIndirectInMirrors() ? indirect
                : indirect(cache.mirrored().indirect(), cache.mirroredGeometry(), mirrors, options, workers, progress);
        List<EngineWorkers<TileRecomposer>> recomposers = EngineWorkers.perThread(workers.count(), options.engines(), engine -> {
            TileRecomposer recomposer = new TileRecomposer(cache, engine, options.view());
            recomposer.setShowsGlow(false);
            recomposer.setIndirect(indirect, mirroredIndirect);
            recomposer.setMirrorFog(BounceFog.of(composedScene(cache.mirrored().scene(), light), cache.mirrored().fog()));
            return recomposer;
        });
        float[][][] films = new float[Math.max(cache.tileCount(), cache.fineCount())][][];
        int tilesX = Film.tilesAlong(scene.picture().width());
        workers.run(films.length, (worker, i) -> {
            BiFunction<SamplePositions, CachedTile, CachedTile> share =
                    (places, tile) -> tileImage(places, tile, recomposers.get(worker).forTile(i), top, mirrors, scene);
            SamplePositions centers = SamplePositions.centers(i % tilesX * Film.TILE_SIZE, i / tilesX * Film.TILE_SIZE);
            CachedTile center = cache.tileCount() == 0 ? null : share.apply(centers, cache.tile(i));
            films[i] = requireNonNull(cache.fineCount() == 0 ? requireNonNull(center).film
                    : cache.fineTile(i).map(center, centers, share).film());
        }, progress);
        return film(scene, films);
    }

    /** Returns the light at gather points that comes from some lights of a scene; null if it has no indirect light. */
    private static float @Nullable [][] indirect(@Nullable IndirectCache indirect, Geometry geometry, WeightedLight[] lights,
            RenderOptions options, WorkerPool workers, Progress progress) {
        return indirect == null ? null
                : new SurfelSolver(indirect, geometry.materials(), 0, options.engines(), workers, progress).solveWithoutGlow(lights,
                        BackgroundLight.NONE);
    }

    /** Returns a tile with the colors of the contribution. */
    private static CachedTile tileImage(SamplePositions places, CachedTile tile, TileRecomposer recomposer, WeightedLight[] top,
            WeightedLight[] mirrors,
            Scene scene) {
        if (!tile.storesRows()) {
            throw new IllegalStateException("mirror levels are stored as hit shapes");
        }
        // Without an environment map, no color needs ray directions.
        float[][] colors = recomposer.composeFilm(tile.levels[0], top, scene, places,
                recomposer.composeImages(places, tile.levels, mirrors, scene.world()));
        if (tile.fog != null) {
            new FogComposer().add(tile.fog, top, scene.world().fog(), colors);
        }
        return new CachedTile(tile.levels, tile.hitShapes, tile.images, colors, tile.edges, tile.fog);
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
