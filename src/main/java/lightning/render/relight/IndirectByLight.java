package lightning.render.relight;

import java.lang.ref.WeakReference;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.relight.tile.SurfelSolver;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Indirect light of each light of a cached picture alone. It is linear in the lights, so it takes look-ups along the cached paths only.
 * Each light is solved when it is first needed, and kept. Holds no cache. Not thread-safe.
 */
public final class IndirectByLight {
    private final WeakReference<PixelCache> cache;
    private final Map<Integer, Solution> solutions = new HashMap<>();

    /** @param cache picture with or without indirect light */
    public IndirectByLight(PixelCache cache) {
        this.cache = new WeakReference<>(cache);
    }

    /**
     * Light at gather points, red, green and blue, of the first level and of mirrors; each null if its scene has no indirect light.
     */
    record Solution(float @Nullable [][] shown, float @Nullable [][] mirrored) {
        // Arrays in a record: written once by their creator, never after.
        static final Solution NONE = new Solution(null, null);
    }

    /** Returns whether this is the indirect light of that picture. */
    public boolean isOf(PixelCache picture) {
        return cache.get() == picture;
    }

    /**
     * Returns the indirect light of some lights, of mirrors those with the same names.
     *
     * @param picture picture of this indirect light
     * @param light   index of a light of the scene; the first light of an environment stands for all of its lights
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    Solution of(PixelCache picture, int light, Progress progress) {
        if (picture.indirect() == null && picture.mirrored().indirect() == null) {
            return Solution.NONE;
        }
        Solution known = solutions.get(light);
        if (known == null) {
            known = solve(picture, light, progress);
            solutions.put(light, known);
        }
        return known;
    }

    private static Solution solve(PixelCache picture, int light, Progress progress) {
        Scene scene = picture.scene();
        String name = light < scene.lights().size() ? scene.lights().get(light).name() : null;
        int environment = scene.rig().environmentStartingAt(light);
        try (var workers = new WorkerPool(1)) {
            float[][] shown = solve(picture.indirect(), picture.geometry(), scene, name, environment, workers, progress);
            return new Solution(shown, picture.hasSameIndirectInMirrors() ? shown
                    : solve(picture.mirrored().indirect(), picture.mirroredGeometry(), picture.mirrored().scene(), name, environment,
                            workers,
                            progress));
        }
    }

    /**
     * @param name        name of a light; null for those of an environment
     * @param environment number of the environment
     */
    private static float @Nullable [][] solve(@Nullable IndirectCache indirect, Geometry geometry, Scene scene, @Nullable String name,
            int environment,
            WorkerPool workers, Progress progress) {
        if (indirect == null) {
            return null;
        }
        WeightedLight[] lights = WeightedLight.ofScene(scene);
        int named = scene.lights().size();
        boolean exists = environment >= 0 && environment < scene.rig().environmentCount();
        int start = exists ? scene.rig().environmentStart(environment) : lights.length;
        int end = exists ? scene.rig().environmentStart(environment + 1) : lights.length;
        for (int l = 0; l < lights.length; l++) {
            boolean isIncluded = name == null ? l >= start && l < end : l < named && scene.lights().get(l).name().equals(name);
            lights[l] = isIncluded ? lights[l] : lights[l].darkened();
        }
        BackgroundLight background = exists ? BackgroundLight.of(scene, environment) : BackgroundLight.NONE;
        if (Arrays.stream(lights).allMatch(WeightedLight::isDark) && background.equals(BackgroundLight.NONE)) {
            return indirect.structure().noLight();
        }
        return new SurfelSolver(indirect, geometry.materials(), 0, RenderOptions.DEFAULT.engines(), workers, progress)
                .solveWithoutGlow(lights, background);
    }
}
