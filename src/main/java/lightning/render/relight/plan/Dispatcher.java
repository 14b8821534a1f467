package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Messages;
import lightning.render.cache.CachedLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.shading.LightSource;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.AntialiasMode;
import lightning.scene.Light;
import lightning.scene.LightMatcher;
import lightning.scene.Scene;

/**
 * Finds the least update that leads from the scene rendered last to the scene wanted (paper §4.9), by
 * comparing the two. Composite edits, undo and edits of several lights at once are one case.
 */
public final class Dispatcher {
    private Dispatcher() {}

    /**
     * The plan for a scene.
     *
     * @param cache   what is known, or null
     * @param mirrors whether mirror images shall show the wanted scene too
     * @param method  how edits are carried out
     */
    public static UpdatePlan plan(PixelCache cache, Scene target, boolean mirrors, UpdateMethod method) {
        return plan(cache, target, null, mirrors, method);
    }

    /**
     * The same where it is known what rays of the scene can meet.
     *
     * @param geometry of the wanted scene, which followed from what is known, perhaps in several steps; null where it is not known
     */
    public static UpdatePlan plan(PixelCache cache, Scene target, Geometry geometry, boolean mirrors, UpdateMethod method) {
        if (cache == null) {
            return new UpdatePlan.FirstPass(Messages.key("no image yet"));
        }
        Scene known = cache.scene();
        if (known.picture().width() != target.picture().width() || known.picture().height() != target.picture().height()) {
            return new UpdatePlan.FirstPass(Messages.key("resolution changed"));
        }
        boolean resampled = !known.picture().sampling().hasSameSamples(target.picture().sampling());
        // Where rays are followed from what mirrors nothing, edges cannot be looked for in the levels that are known.
        if (resampled && (hasNoCenters(known) || hasNoCenters(target)
                || cache.geometry().castsReflections() != MaterialTable.CASTS_REFLECTIONS)) {
            return new UpdatePlan.FirstPass(Messages.key("anti-aliasing changed"));
        }
        if (!known.camera().equals(target.camera())) {
            return new UpdatePlan.FirstPass(Messages.key("camera changed"));
        }
        ShapeChange shapes = cache.geometry().canServe(target) ? ShapeChange.NONE
                : geometry != null ? cache.geometry().changeTo(geometry) : cache.geometry().changeTo(target);
        boolean reshaped = shapes != ShapeChange.NONE;
        if (!shapes.hasUnchanged() || reshaped && resampled) {
            return new UpdatePlan.FirstPass(Messages.key("objects changed"));
        }
        int oldDepth = known.picture().depth();
        int newDepth = target.picture().depth();
        boolean refresh = resampled || reshaped || oldDepth != newDepth || mirrors && !cache.mirroredScene().equals(target);
        if (known.equals(target) && !refresh) {
            return new UpdatePlan.Nothing();
        }
        MaterialTable materials = shapes.after(cache.geometry()).withMaterialsOf(target).materials();
        LevelPlan top = planLevel(cache.geometry(), known, cache.lights(), target, materials, shapes, method);
        LevelPlan mirrored = refresh ? planLevel(cache.mirroredGeometry(), cache.mirroredScene(), cache.mirroredLights(), target,
                materials, shapes, method) : null;
        if (resampled && !(top.materials().mirroringChanged().isEmpty() && mirrored.materials().mirroringChanged().isEmpty())) {
            return new UpdatePlan.FirstPass(Messages.key("anti-aliasing and reflections changed"));
        }
        return new UpdatePlan.Relight(top, mirrored, oldDepth, newDepth, resampled, shapes);
    }

    /** Whether all pixels have several samples, so that their centers are not traced. */
    private static boolean hasNoCenters(Scene scene) {
        return scene.picture().sampling().antialias() == AntialiasMode.EVERY;
    }

    /** @param lights those of {@code known} */
    private static LevelPlan planLevel(Geometry shown, Scene known, List<CachedLight> lights, Scene target, MaterialTable materials,
            ShapeChange shapes, UpdateMethod method) {
        LightMatcher match = new LightMatcher(known.rig().effectiveLights(), target.rig().effectiveLights());
        List<LayerPlan> layers = new ArrayList<>();
        boolean dropsLayers = false;
        for (int l = 0; l < match.after().size(); l++) {
            WeightedLight light = WeightedLight.of(match.after().get(l), target);
            CachedLight origin = match.originIndex(l) < 0 ? null : lights.get(match.originIndex(l));
            boolean isReusable = origin != null && isReusable(origin, known, target, shapes);
            LightUpdate update =
                    planLight(isReusable ? origin.stamp() : null, origin == null || origin.stamp() == null, light, target, method);
            // A dark light's layers that do not hold are dropped, and with them what would tell where it shone.
            boolean isDropped = origin != null && !isReusable && update instanceof LightUpdate.Keep;
            ShapeChange shadows = isReusable && origin.stamp() != null ? shapes.shadowChange(shown, origin.stamp().light().shadowedBy(),
                    LayerPlan.shadowedBy(light.light(), origin.stamp(), update)) : ShapeChange.NONE;
            layers.add(LayerPlan.of(light, isDropped ? null : origin, update, shadows, known));
            dropsLayers |= isDropped;
        }
        List<String> dropped = match.removedIndices().stream().map(i -> match.before().get(i).name()).toList();
        // A change of the order or number of lights changes how their sum is grouped.
        boolean compose = dropsLayers || !match.keepsOrder() || !known.world().equals(target.world());
        return new LevelPlan(layers, dropped, compose,
                MaterialDifference.between(shown.materials(), materials));
    }

    /**
     * Whether a light's layers hold among other shapes, but for rows that can meet those: not where the shapes decide whether it lies on
     * one that stays as it is, for then they may differ everywhere; nor where a shape that stays is linked to it now, or no more, because
     * it is in another group. Of a light that is larger than a point it is not asked for each of
     * its samples: it is computed anew.
     */
    private static boolean isReusable(CachedLight light, Scene known, Scene scene, ShapeChange shapes) {
        if (light.stamp() == null) {
            return true;
        }
        Light computed = light.stamp().light();
        return shapes == ShapeChange.NONE || !computed.isArea() && shapes.hasSameLinks(known, scene, computed.illuminates())
                && (!computed.type().hasPosition() || shapes.hasSameTarget(LightSource.of(computed, scene).position()));
    }

    /** @param added whether the light never shone */
    private static LightUpdate planLight(LayerStamp before, boolean added, WeightedLight light, Scene target, UpdateMethod method) {
        if (before == null) {
            return light.isDark() ? new LightUpdate.Keep() : new LightUpdate.FullRecompute(added);
        }
        return method.update(before, light, target);
    }
}
