package lightning.render.shading;

import java.util.function.BiFunction;
import java.util.function.Predicate;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import net.jqwik.api.statistics.Statistics;

/** Coverage statistics of property tests: counts what the pictures of the cases show and requires a tenth of each kind. */
public final class SceneCoverage {
    private static final double MIN_PERCENT = 10;
    /** With fewer cases the shares are not significant. */
    private static final int MIN_CASES = 100;

    private SceneCoverage() {}

    /** Counts one case. */
    public static void collect(Scene scene) {
        ReferenceRows rows = new ReferenceRows(scene);
        collect("lit", anyLight(scene, rows, ReferenceRows::isLit));
        collect("shadowed", anyLight(scene, rows, ReferenceRows::isShadowed));
        collect("outside the cone", anyLight(scene, rows, ReferenceRows::isOutsideCone));
        collect("mirrored", scene.picture().depth() >= 1 && !rows.rowsOfLevel(1).isEmpty());
        collect("refracted", scene.picture().depth() >= 1 && rows.hasRefractedHits());
        collect("mirrored twice", scene.picture().depth() >= 2 && !rows.rowsOfLevel(2).isEmpty());
    }

    private static boolean anyLight(Scene scene, ReferenceRows rows, BiFunction<ReferenceRows, Light, Predicate<SurfacePoint>> kind) {
        return scene.lights().stream().filter(scene::isActive)
                .anyMatch(light -> rows.rowsOfLevel(0).stream().anyMatch(kind.apply(rows, light)));
    }

    private static void collect(String label, boolean shown) {
        collect(label, shown, MIN_PERCENT);
    }

    /** Counts whether one case shows something and requires a minimum share of such cases. */
    public static void collect(String label, boolean shown, double minPercent) {
        Statistics.label(label).collect(shown).coverage(coverage -> {
            coverage.check(true).count((count, all) -> all < MIN_CASES || 100.0 * count >= minPercent * all);
        });
    }
}
