package lightning.format.layer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.CachedScene;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineChoice;
import lightning.render.relight.tile.SurfelSolver;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Light of one set of lights in a picture: all lights of the scene, of which those of other sets are dark, and the light of the set at gather
 * points.
 *
 * @param lights           all lights of the shown scene
 * @param mirrored         all lights of the mirrored scene
 * @param gathered         light at the gather points, as the cache has it; null for none
 * @param mirroredGathered the same in mirrors
 * @param shines           whether any light of the set shines
 */
record SetLight(WeightedLight[] lights, WeightedLight[] mirrored, float @Nullable [][] gathered, float @Nullable [][] mirroredGathered,
        boolean shines) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * Returns the light of each set of a picture, and last that of no set: glowing materials, ambient light, a background, and in mirrors that
     * show an older scene lights that the picture does not have. Casts no ray.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    static List<SetLight> of(PixelCache cache, List<LightSet> sets, EngineChoice engines, WorkerPool workers, Progress progress) {
        Side shown = new Side(cache.shown(), cache.geometry(), sets, engines, workers, progress);
        Side mirrored = cache.hasSameIndirectInMirrors() ? shown
                : new Side(cache.mirrored(), cache.mirroredGeometry(), sets, engines, workers, progress);
        List<SetLight> result = new ArrayList<>();
        for (int s = 0; s <= sets.size(); s++) {
            progress.report(s, sets.size() + 1);
            WeightedLight[] lights = shown.lights(s);
            WeightedLight[] inMirrors = mirrored.lights(s);
            float[][] gathered = shown.gathered(s);
            boolean shines = s == sets.size() || sets.get(s).isEnvironment() || shines(lights) || shines(inMirrors);
            result.add(new SetLight(lights, inMirrors, gathered, mirrored == shown ? gathered : mirrored.gathered(s), shines));
        }
        return result;
    }

    /** Returns whether any light of a set shines. */
    private static boolean shines(WeightedLight[] lights) {
        for (WeightedLight light : lights) {
            if (!light.isDark() || !light.isDarkInFog()) {
                return true;
            }
        }
        return false;
    }

    /** The scene of the first level, or that of mirrors. */
    private static final class Side {
        private final Scene scene;
        private final List<LightSet> sets;
        private final WeightedLight[] all;
        private final @Nullable SurfelSolver solver;

        Side(CachedScene cached, Geometry geometry, List<LightSet> sets, EngineChoice engines, WorkerPool workers, Progress progress) {
            scene = cached.scene();
            this.sets = sets;
            all = WeightedLight.ofScene(scene);
            solver = cached.indirect() == null ? null
                    : new SurfelSolver(cached.indirect(), geometry.materials(), scene.world().ambience(), engines, workers, progress);
        }

        /** Returns the lights of a set; those of no set for the index after the last. */
        WeightedLight[] lights(int s) {
            boolean[] kept = new boolean[all.length];
            if (s < sets.size()) {
                Arrays.stream(sets.get(s).indices(scene)).forEach(i -> kept[i] = true);
            } else {
                Arrays.fill(kept, true);
                sets.stream().flatMapToInt(set -> Arrays.stream(set.indices(scene))).forEach(i -> kept[i] = false);
            }
            return IntStream.range(0, all.length).mapToObj(i -> kept[i] ? all[i] : all[i].darkened()).toArray(WeightedLight[]::new);
        }

        /** Returns the gathered light of a set; that of no set for the index after the last. */
        float @Nullable [][] gathered(int s) {
            if (solver == null) {
                return null;
            }
            WeightedLight[] lights = lights(s);
            if (s == sets.size()) {
                BackgroundLight whole = BackgroundLight.of(scene);
                return solver.solve(lights, whole.layers().isEmpty() ? whole
                        : background(part -> sets.stream().noneMatch(set -> set.contributions().contains(part))));
            }
            BackgroundLight background = background(sets.get(s).contributions()::contains);
            return background.layers().isEmpty() && !shines(lights) ? null : solver.solveWithoutGlow(lights, background);
        }

        /** Returns the light of some environments. */
        private BackgroundLight background(Predicate<Contribution> isKept) {
            List<Contribution> all = Contribution.environments(scene);
            return new BackgroundLight(Rgb.BLACK, IntStream.range(0, all.size()).filter(e -> isKept.test(all.get(e))).boxed()
                    .flatMap(e -> BackgroundLight.of(scene, e).layers().stream()).toList(), Rgb.BLACK);
        }
    }
}
