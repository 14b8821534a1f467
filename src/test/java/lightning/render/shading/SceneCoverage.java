package lightning.render.shading;

import java.util.function.BiFunction;
import java.util.function.Predicate;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Light;
import lightning.scene.Scene;
import net.jqwik.api.statistics.Statistics;

/** Counts over the cases of a property what their pictures show, and asks for a tenth of each. */
public final class SceneCoverage {
    private static final double LEAST_PERCENT = 10;
    /** Below so many cases the shares say nothing. */
    private static final int ENOUGH = 100;

    private SceneCoverage() {}

    /** Counts one case. */
    public static void collect(Scene scene) {
        SeenRows rows = new SeenRows(scene);
        collect("lit", anyLight(scene, rows, SeenRows::lit));
        collect("shadowed", anyLight(scene, rows, SeenRows::shadowed));
        collect("outside the cone", anyLight(scene, rows, SeenRows::outside));
        collect("mirrored", scene.picture().depth() >= 1 && !rows.level(1).isEmpty());
        collect("refracted", scene.picture().depth() >= 1 && rows.anyRefracted());
        collect("mirrored twice", scene.picture().depth() >= 2 && !rows.level(2).isEmpty());
    }

    private static boolean anyLight(Scene scene, SeenRows rows, BiFunction<SeenRows, Light, Predicate<SurfacePoint>> kind) {
        return scene.lights().stream().filter(scene::shines)
                .anyMatch(light -> rows.level(0).stream().anyMatch(kind.apply(rows, light)));
    }

    private static void collect(String label, boolean shown) {
        collect(label, shown, LEAST_PERCENT);
    }

    /** Counts one case, in which something is shown or not, and asks for a share of it. */
    public static void collect(String label, boolean shown, double leastPercent) {
        Statistics.label(label).collect(shown).coverage(coverage -> {
            coverage.check(true).count((count, all) -> all < ENOUGH || 100.0 * count >= leastPercent * all);
        });
    }
}
