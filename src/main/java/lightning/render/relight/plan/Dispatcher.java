package lightning.render.relight.plan;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Messages;
import lightning.render.cache.CachedLight;
import lightning.render.cache.CachedScene;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightSource;
import lightning.render.shading.ObjectGains;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.AntialiasMode;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightMatcher;
import org.jspecify.annotations.Nullable;

/**
 * Plans the least update from the scene rendered last to the target scene by comparing both (paper §4.9). Composite edits, undo and
 * simultaneous edits of several lights need no special case.
 */
public final class Dispatcher {
    private Dispatcher() {}

    /**
     * Plans the update to a scene.
     *
     * @param cache   cache of the last picture
     * @param mirrors true if mirror images must show the target scene too
     * @param method  update method
     */
    public static UpdatePlan plan(@Nullable PixelCache cache, Scene target, boolean mirrors, UpdateMethod method) {
        return plan(cache, target, null, mirrors, method);
    }

    /**
     * Plans the update to a scene with existing geometry.
     *
     * @param geometry geometry of the target scene, derived from the cached one in one or more steps; null if unknown
     */
    public static UpdatePlan plan(@Nullable PixelCache cache, Scene target, @Nullable Geometry geometry, boolean mirrors,
            UpdateMethod method) {
        if (cache == null) {
            return new UpdatePlan.FirstPass(Messages.key("no image yet"));
        }
        Scene known = cache.scene();
        if (known.picture().width() != target.picture().width() || known.picture().height() != target.picture().height()) {
            return new UpdatePlan.FirstPass(Messages.key("resolution changed"));
        }
        boolean resampled = !known.hasSameSamples(target);
        // If rays are followed from materials that do not mirror, edges cannot be found in the cached levels.
        if (resampled && (hasNoCenters(known) || hasNoCenters(target)
                || cache.geometry().castsReflections() != MaterialTable.CASTS_REFLECTIONS)) {
            return new UpdatePlan.FirstPass(Messages.key("anti-aliasing changed"));
        }
        if (!known.camera().hasSameView(target.camera())) {
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
        boolean refresh = resampled || reshaped || oldDepth != newDepth || mirrors && !cache.mirrored().scene().hasSameImage(target);
        if (known.hasSameImage(target) && !refresh) {
            return new UpdatePlan.Nothing();
        }
        MaterialTable materials = shapes.after(cache.geometry()).withMaterialsOf(target).materials();
        LevelPlan top = planLevel(cache.geometry(), cache.shown(), target, materials, shapes, method);
        LevelPlan mirrored = refresh ? planLevel(cache.mirroredGeometry(), cache.mirrored(), target,
                materials, shapes, method) : null;
        if (resampled
                && !(top.materials().mirroringChanged().isEmpty() && requireNonNull(mirrored).materials().mirroringChanged().isEmpty())) {
            return new UpdatePlan.FirstPass(Messages.key("anti-aliasing and reflections changed"));
        }
        return new UpdatePlan.Relight(top, mirrored, oldDepth, newDepth, resampled, shapes,
                PathUpdate.between(cache, target, materials, shapes));
    }

    /** Returns whether all pixels have several samples, so that their centers are not traced. */
    private static boolean hasNoCenters(Scene scene) {
        return scene.picture().sampling().antialias() == AntialiasMode.EVERY;
    }

    private static LevelPlan planLevel(Geometry shown, CachedScene before, Scene target, MaterialTable materials, ShapeChange shapes,
            UpdateMethod method) {
        Scene known = before.scene();
        LightMatcher match = new LightMatcher(known.rig().effectiveLights(), target.rig().effectiveLights());
        WeightedLight[] rendered = FilmParts.of(target).lights();
        List<LayerPlan> layers = new ArrayList<>();
        for (int l = 0; l < match.after().size(); l++) {
            WeightedLight lit = WeightedLight.of(match.after().get(l), target);
            // A gain may lift a weight above 0 that is 0 in its film.
            WeightedLight light = rendered[l].isDark() ? lit.darkened() : lit;
            CachedLight origin = match.originIndex(l) < 0 ? null : before.lights().get(match.originIndex(l));
            boolean isReusable = origin != null && isReusable(origin, known, target, shapes, method);
            LayerStamp stamp = origin != null && isReusable ? origin.stamp() : null;
            LightUpdate update =
                    planLight(stamp, origin == null || origin.stamp() == null, light, target, method);
            // Layers of a dark light that are invalid are dropped, and with them the record of the rows that it lit.
            boolean isDropped = origin != null && !isReusable && update instanceof LightUpdate.Keep;
            ShapeChange shadows = stamp != null ? shapes.shadowChange(shown, stamp.light().shadowCasters(),
                    LayerPlan.shadowing(light.light(), stamp, update).shadowCasters()) : ShapeChange.NONE;
            layers.add(LayerPlan.of(light, isDropped ? null : origin, update, shadows, known, target.stage(), shapes));
        }
        List<String> dropped = match.removedIndices().stream().map(i -> match.before().get(i).name()).toList();
        return new LevelPlan(layers, dropped, MaterialDifference.between(shown.materials(), materials));
    }

    /**
     * Returns whether a light's layers stay valid after a geometry change, except for rows whose shadow rays meet changed shapes.
     * They do not if the shapes decide whether the light lies on an unchanged one, because then all rows may differ. They do not if
     * the links, or gains that layers contain, of an unchanged shape change because its group does.
     */
    private static boolean isReusable(CachedLight light, Scene known, Scene scene, ShapeChange shapes, UpdateMethod method) {
        if (light.stamp() == null) {
            return true;
        }
        Light computed = light.stamp().light();
        return shapes == ShapeChange.NONE || shapes.hasSameLinks(known, scene, computed.illuminates())
                && (!method.storesGains() || hasSameGains(computed, known, scene, shapes))
                && (!computed.type().hasPosition() || LightSource.of(computed, scene).targets().allMatch(shapes::hasSameTarget));
    }

    private static boolean hasSameGains(Light light, Scene known, Scene scene, ShapeChange shapes) {
        return ObjectGains.areSame(ObjectGains.of(light, known.stage()), ObjectGains.of(light, scene.stage()), shapes);
    }

    /** @param added true if the light never shone */
    private static LightUpdate planLight(@Nullable LayerStamp before, boolean added, WeightedLight light, Scene target,
            UpdateMethod method) {
        if (before == null) {
            return light.isDark() ? new LightUpdate.Keep() : new LightUpdate.FullRecompute(added);
        }
        return method.update(before, light, target);
    }
}
