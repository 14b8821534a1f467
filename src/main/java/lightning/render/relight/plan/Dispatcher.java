package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Texts;
import lightning.render.cache.KnownLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.shading.Lamp;
import lightning.render.shading.Luminaire;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.Antialias;
import lightning.scene.Light;
import lightning.scene.LightMatch;
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
    public static UpdatePlan plan(PixelCache cache, Scene wanted, boolean mirrors, UpdateMethod method) {
        return plan(cache, wanted, null, mirrors, method);
    }

    /**
     * The same where it is known what rays of the scene can meet.
     *
     * @param geometry of the wanted scene, which followed from what is known, perhaps in several steps; null where it is not known
     */
    public static UpdatePlan plan(PixelCache cache, Scene wanted, Geometry geometry, boolean mirrors, UpdateMethod method) {
        if (cache == null) {
            return new UpdatePlan.FirstPass(Texts.key("no picture yet"));
        }
        Scene known = cache.scene();
        if (known.picture().width() != wanted.picture().width() || known.picture().height() != wanted.picture().height()) {
            return new UpdatePlan.FirstPass(Texts.key("another size"));
        }
        boolean resampled = !known.picture().sampling().samplesLike(wanted.picture().sampling());
        // Where rays are followed from what mirrors nothing, edges cannot be looked for in the levels that are known.
        if (resampled && (hasNoCentres(known) || hasNoCentres(wanted) || cache.geometry().mirrors() != MaterialTable.MIRRORS)) {
            return new UpdatePlan.FirstPass(Texts.key("other samples"));
        }
        if (!known.camera().equals(wanted.camera())) {
            return new UpdatePlan.FirstPass(Texts.key("another camera"));
        }
        ShapeChange shapes = cache.geometry().serves(wanted) ? ShapeChange.NONE
                : geometry != null ? cache.geometry().changeTo(geometry) : cache.geometry().changeTo(wanted);
        boolean reshaped = shapes != ShapeChange.NONE;
        if (!shapes.keepsAny() || reshaped && resampled) {
            return new UpdatePlan.FirstPass(Texts.key("other shapes"));
        }
        int depthFrom = known.picture().depth();
        int depthTo = wanted.picture().depth();
        boolean refresh = resampled || reshaped || depthFrom != depthTo || mirrors && !cache.mirroredScene().equals(wanted);
        if (known.equals(wanted) && !refresh) {
            return new UpdatePlan.Nothing();
        }
        MaterialTable materials = shapes.after(cache.geometry()).of(wanted).materials();
        LevelPlan top = level(cache.geometry(), known, cache.lights(), wanted, materials, shapes, method);
        LevelPlan mirrored = refresh ? level(cache.mirroredGeometry(), cache.mirroredScene(), cache.mirroredLights(), wanted,
                materials, shapes, method) : null;
        if (resampled && !(top.materials().mirrors().isEmpty() && mirrored.materials().mirrors().isEmpty())) {
            return new UpdatePlan.FirstPass(Texts.key("other samples and mirrors"));
        }
        return new UpdatePlan.Relight(top, mirrored, depthFrom, depthTo, resampled, shapes);
    }

    /** Whether all pixels have several samples, so that their centres are not traced. */
    private static boolean hasNoCentres(Scene scene) {
        return scene.picture().sampling().antialias() == Antialias.EVERY;
    }

    /** @param lights those of {@code known} */
    private static LevelPlan level(Geometry shown, Scene known, List<KnownLight> lights, Scene wanted, MaterialTable materials,
            ShapeChange shapes, UpdateMethod method) {
        LightMatch match = new LightMatch(known.rig().actingLights(), wanted.rig().actingLights());
        List<LayerPlan> layers = new ArrayList<>();
        boolean forgets = false;
        for (int l = 0; l < match.after().size(); l++) {
            Luminaire light = Luminaire.of(match.after().get(l), wanted);
            KnownLight origin = match.origin(l) < 0 ? null : lights.get(match.origin(l));
            boolean holds = origin != null && holds(origin, known, wanted, shapes);
            LightUpdate update = update(holds ? origin.stamp() : null, origin == null || origin.stamp() == null, light, wanted, method);
            // A dark light's layers that do not hold are dropped, and with them what would tell where it shone.
            boolean forgotten = origin != null && !holds && update instanceof LightUpdate.Keep;
            ShapeChange shadows = holds && origin.stamp() != null ? shapes.shadows(shown, origin.stamp().light().shadowedBy(),
                    LayerPlan.shadowedBy(light.light(), origin.stamp(), update)) : ShapeChange.NONE;
            layers.add(LayerPlan.of(light, forgotten ? null : origin, update, shadows, known));
            forgets |= forgotten;
        }
        List<String> dropped = match.gone().stream().map(i -> match.before().get(i).name()).toList();
        // A change of the order or number of lights changes how their sum is grouped.
        boolean compose = forgets || !match.keepsPlaces() || !known.world().equals(wanted.world());
        return new LevelPlan(layers, dropped, compose,
                MaterialDifference.between(shown.materials(), materials));
    }

    /**
     * Whether a light's layers hold among other shapes, but for rows that can meet those: not where the shapes decide whether it lies on
     * one that stays as it is, for then they may differ everywhere; nor where a shape that stays is linked to it now, or no more, because
     * it is in another group. Of a light that is larger than a point it is not asked for each of
     * its samples: it is computed anew.
     */
    private static boolean holds(KnownLight light, Scene known, Scene scene, ShapeChange shapes) {
        if (light.stamp() == null) {
            return true;
        }
        Light computed = light.stamp().light();
        return shapes == ShapeChange.NONE || !computed.isArea() && shapes.keepsLinks(known, scene, computed.illuminates())
                && (!computed.type().hasPosition() || shapes.keepsEnd(Lamp.of(computed, scene).source()));
    }

    /** @param added whether the light never shone */
    private static LightUpdate update(LayerStamp before, boolean added, Luminaire light, Scene wanted, UpdateMethod method) {
        if (before == null) {
            return light.isDark() ? new LightUpdate.Keep() : new LightUpdate.FullRecompute(added);
        }
        return method.update(before, light, wanted);
    }
}
