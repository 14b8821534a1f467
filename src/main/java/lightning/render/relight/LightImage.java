package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.CachedScene;
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
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Contribution;
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
        return scene(scene, light, _ -> false);
    }

    /** @param glows selects lights by name whose faces and bulbs glow while they shine */
    private static Scene scene(Scene scene, String light, Predicate<String> glows) {
        List<Light> lights = new ArrayList<>();
        for (Light l : scene.lights()) {
            // A solo light that is switched off mutes no light.
            Light shown = l.name().equals(light) && scene.isActive(l) ? l : l.withOn(false);
            boolean isBlack = l.area().visibility() != FaceVisibility.HIDDEN && !glows.test(l.name());
            lights.add(isBlack ? shown.withArea(l.area().withVisibility(FaceVisibility.BLACK)) : shown);
        }
        Stage stage = scene.stage().withMaterials(scene.materials().stream()
                .map(m -> m.glow().isBlack() && m.bulb().light().isEmpty() ? m
                        : m.withGlow(Rgb.BLACK).withBulb(glows.test(m.bulb().light()) ? m.bulb() : Bulb.NONE))
                .toList());
        return new Scene(scene.picture(), scene.camera(), unlit(scene.world()), stage, scene.rig().withLights(lights));
    }

    /** Returns a world without light of its own; an environment stays, and is dark. */
    private static World unlit(World world) {
        return dark(world).mapIntensities(_ -> 0);
    }

    /** Returns a world without light but that of its environments. */
    private static World dark(World world) {
        return world.withAmbience(0).withBackground(Rgb.BLACK).withFog(world.fog().withAmbient(Rgb.BLACK));
    }

    /** Returns the world by whose values a contribution is composed: without the dark environment, whose colors would need ray directions. */
    public static World darkWorld(World world) {
        return unlit(world).withoutEnvironments();
    }

    /**
     * Light of one side of a picture, the shown or the mirrored, from which a contribution is composed.
     *
     * @param scene      the side's scene, with the world of the contribution
     * @param materials  materials, which glow if that belongs to the contribution
     * @param lights     all lights; those of other contributions are dark
     * @param background light of rays that leave the scene
     */
    private record Side(Scene scene, MaterialTable materials, WeightedLight[] lights, BackgroundLight background) {
        // Arrays in a record: written once by their creator, never after.

        /** Returns a light alone, without what it shows of itself. */
        static Side image(CachedScene cached, Geometry geometry, String light) {
            Scene one = LightImage.scene(cached.scene(), light);
            Scene composed = one.withWorld(darkWorld(cached.scene().world()));
            return new Side(composed, geometry.materialsOf(one), WeightedLight.ofScene(composed), BackgroundLight.NONE);
        }

        static Side contribution(CachedScene cached, Geometry geometry, Contribution contribution) {
            Scene scene = cached.scene();
            return switch (contribution) {
                case Contribution.OfLight(String light) -> {
                    Scene one = LightImage.scene(scene, light, light::equals);
                    yield new Side(one.withWorld(darkWorld(scene.world())), geometry.materialsOf(one),
                            lightsOf(scene, contribution), BackgroundLight.NONE);
                }
                case Contribution.OfEnvironment _,Contribution.OfDome _ -> {
                    int index = contribution.environmentIndex(scene);
                    World world = dark(scene.world());
                    for (int e = 0; e < scene.rig().environmentCount(); e++) {
                        world = e == index ? world : world.withDarkEnvironment(e);
                    }
                    yield new Side(scene.withWorld(world), geometry.materialsOf(LightImage.scene(scene, "")),
                            lightsOf(scene, contribution),
                            index < 0 ? BackgroundLight.NONE : BackgroundLight.of(scene, index));
                }
                case Contribution.OfAmbience _,Contribution.OfRest _ -> throw new IllegalArgumentException("has no weight");
            };
        }

        /** Returns all lights; those of other contributions are dark. */
        private static WeightedLight[] lightsOf(Scene scene, Contribution contribution) {
            WeightedLight[] all = WeightedLight.ofScene(scene);
            WeightedLight[] kept = Arrays.stream(all).map(WeightedLight::darkened).toArray(WeightedLight[]::new);
            Arrays.stream(contribution.effectiveLights(scene)).forEach(i -> kept[i] = all[i]);
            return kept;
        }
    }

    /**
     * Composes the light's image from the cache of a picture, with its indirect light; in mirrors it is the image of the mirrored scene.
     *
     * @throws IllegalStateException if mirror levels are not stored as rows
     * @throws CancellationException if {@code progress} requested cancellation
     */
    static Film film(PixelCache cache, RenderOptions options, String light, WorkerPool workers, Progress progress) {
        return film(cache, options, Side.image(cache.shown(), cache.geometry(), light),
                Side.image(cache.mirrored(), cache.mirroredGeometry(), light), workers, progress);
    }

    /** Composes a contribution: of a light with its visible face and its bulbs, or of an environment with its visible background. */
    static Film film(PixelCache cache, RenderOptions options, Contribution contribution, WorkerPool workers, Progress progress) {
        return film(cache, options, Side.contribution(cache.shown(), cache.geometry(), contribution),
                Side.contribution(cache.mirrored(), cache.mirroredGeometry(), contribution), workers, progress);
    }

    private static Film film(PixelCache cache, RenderOptions options, Side shown, Side mirrored, WorkerPool workers, Progress progress) {
        float[][] indirect = indirect(cache.indirect(), shown, options, workers, progress);
        float[][] mirroredIndirect = cache.hasSameIndirectInMirrors() ? indirect
                : indirect(cache.mirrored().indirect(), mirrored, options, workers, progress);
        List<EngineWorkers<TileRecomposer>> recomposers = EngineWorkers.perThread(workers.count(), options.engines(), engine -> {
            TileRecomposer recomposer = new TileRecomposer(shown.scene, shown.materials, mirrored.materials,
                    shown.scene.picture().depth(), engine, options.view());
            recomposer.setIndirect(indirect, mirroredIndirect);
            recomposer.setMirrorFog(BounceFog.of(mirrored.scene, cache.mirrored().fog()));
            return recomposer;
        });
        float[][][] films = new float[Math.max(cache.tileCount(), cache.fineCount())][][];
        int tilesX = Film.tilesAlong(shown.scene.picture().width());
        workers.run(films.length, (worker, i) -> {
            BiFunction<SamplePositions, CachedTile, CachedTile> share =
                    (places, tile) -> tileImage(places, tile, recomposers.get(worker).forTile(i), shown, mirrored);
            SamplePositions centers = SamplePositions.centers(i % tilesX * Film.TILE_SIZE, i / tilesX * Film.TILE_SIZE);
            CachedTile center = cache.tileCount() == 0 ? null : share.apply(centers, cache.tile(i));
            films[i] = requireNonNull(cache.fineCount() == 0 ? requireNonNull(center).film
                    : cache.fineTile(i).map(center, centers, share).film());
        }, progress);
        return film(shown.scene, films);
    }

    /** Returns the light of a side at gather points; null if its scene has no indirect light. */
    private static float @Nullable [][] indirect(@Nullable IndirectCache indirect, Side side, RenderOptions options, WorkerPool workers,
            Progress progress) {
        return indirect == null ? null
                : new SurfelSolver(indirect, side.materials, 0, options.engines(), workers, progress).solve(side.lights, side.background);
    }

    /** Returns a tile with the colors of the contribution. */
    private static CachedTile tileImage(SamplePositions places, CachedTile tile, TileRecomposer recomposer, Side shown, Side mirrored) {
        if (!tile.storesRows()) {
            throw new IllegalStateException("mirror levels are stored as hit shapes");
        }
        float[][] colors = recomposer.composeFilm(tile.levels[0], shown.lights, shown.scene, places,
                recomposer.composeImages(places, tile.levels, mirrored.lights, mirrored.scene.world()));
        if (tile.fog != null) {
            new FogComposer().add(tile.fog, shown.lights, shown.scene.world().fog(), colors);
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
