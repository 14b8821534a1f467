package lightning.render.relight.plan;

import static java.util.Objects.requireNonNull;

import java.util.stream.IntStream;
import lightning.render.cache.PixelCache;
import lightning.render.gather.reflection.ReflectionMemo;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;

/** Update of the paths of indirect light. */
public enum PathUpdate {
    /** The scene has neither indirect light nor an environment. */
    NONE,
    /** No path can differ. Lights and materials change only what the paths carry. */
    KEEP,
    /** Rays that may meet changed objects are traced again, and all paths if too much changed. */
    REPEAT,
    /** There are no paths yet, or those of other settings. */
    BUILD;

    /** Returns the update for a scene whose shapes, materials and settings are those of the cache. */
    public static PathUpdate unchanged(PixelCache cache) {
        return cache.indirect() == null ? NONE : KEEP;
    }

    /**
     * Returns the update to a target scene with the same camera and size.
     *
     * @param materials materials of the target scene
     */
    static PathUpdate between(PixelCache cache, Scene target, MaterialTable materials, ShapeChange shapes) {
        if (cache.indirect() == null || !cache.indirect().settings().canServe(target)) {
            return GatherSettings.of(target).isEmpty() ? NONE : BUILD;
        }
        return shapes == ShapeChange.NONE && cache.scene().picture().depth() == target.picture().depth()
                && haveSamePaths(cache, materials) ? KEEP : REPEAT;
    }

    private static boolean haveSamePaths(PixelCache cache, MaterialTable after) {
        MaterialTable before = cache.geometry().materials();
        boolean blurs = requireNonNull(cache.indirect()).structure().reflections() != null;
        return before == after || before.count() == after.count()
                && IntStream.range(0, after.count()).allMatch(m -> mirrors(before, m) == mirrors(after, m) && before.hasSamePaths(m, after)
                        && (!blurs || ReflectionMemo.reflectAlike(before.material(m), after.material(m))))
                && requireNonNull(cache.indirect()).structure().canServe(cache.geometry(), after);
    }

    /** Returns whether a material mirrors or transmits light, even if the view casts reflected rays from all materials. */
    private static boolean mirrors(MaterialTable materials, int m) {
        return MaterialTable.CASTS_REFLECTIONS.test(materials.material(m));
    }
}
