package lightning.render.warmup;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;

/**
 * Warm-up of the code of edits: repeats edits of lights of a picture, which are discarded, on one thread, until they get no faster. Otherwise an artist's
 * first edits would wait for code that is not compiled.
 */
public final class EditRehearsal {
    /** Runs in a row that are not faster, after which an edit counts as warm. */
    private static final int STEADY_RUNS = 3;
    /** Largest share of the shortest time that counts as faster. */
    private static final double FASTER = 0.9;
    /** Most time for one edit, milliseconds. */
    private static final double MAX_MS = 5_000;
    private static final int MAX_KINDS = 3;
    private static final double BRIGHTER = 1.0625;

    private EditRehearsal() {}

    /**
     * Repeats edits of a picture.
     *
     * @param cache   finished picture of these options
     * @throws CancellationException if {@code progress} requested to stop; code compiled by then stays compiled
     */
    public static void run(PixelCache cache, RenderOptions options, Progress progress) {
        try (Renderer renderer = new Renderer(options.withThreads(1))) {
            for (Scene edited : edits(cache.scene())) {
                repeat(cache, edited, renderer, progress.cancellationOnly());
            }
        }
    }

    private static void repeat(PixelCache cache, Scene edited, Renderer renderer, Progress progress) {
        double shortest = Double.POSITIVE_INFINITY;
        double sum = 0;
        for (int steady = 0; steady < STEADY_RUNS && sum < MAX_MS;) {
            renderer.restore(cache);
            double milliseconds = renderer.render(edited, progress).milliseconds();
            sum += milliseconds;
            steady = milliseconds < FASTER * shortest ? 0 : steady + 1;
            shortest = Math.min(shortest, milliseconds);
        }
    }

    /** Returns the scene with another intensity, color or place of one light of each kind. */
    static List<Scene> edits(Scene scene) {
        List<Scene> edits = new ArrayList<>();
        Set<LightType> kinds = new HashSet<>();
        for (Light light : scene.lights()) {
            if (kinds.size() < MAX_KINDS && scene.isActive(scene.rig().effectiveLight(light)) && light.intensity() > 0
                    && kinds.add(light.type())) {
                if (edits.isEmpty()) {
                    edits.add(scene.withLight(light.withIntensity(light.intensity() / BRIGHTER)));
                    edits.add(scene.withLight(light.withColor(light.color().times(new Rgb(1, 1 / BRIGHTER, 1)))));
                }
                if (light.type().hasPosition()) {
                    edits.add(scene.withLight(light.withPosition(light.position().times(1 / BRIGHTER))));
                }
            }
        }
        return edits;
    }
}
