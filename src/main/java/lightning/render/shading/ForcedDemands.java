package lightning.render.shading;

import java.util.Set;
import java.util.function.Predicate;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Material;
import lightning.scene.effects.Effect;

/**
 * Columns are kept, loops run and rays are cast for some effects although the scene does not call for them: the picture is the
 * same, only more is done. To measure what their absence saves.
 *
 * @param forced the effects
 */
record ForcedDemands(Set<Effect> forced) implements Demands {
    private static final Predicate<Material> EVERY = _ -> true;

    @Override
    public Predicate<Material> mirrors() {
        return forced.contains(Effect.REFLECTION) ? EVERY : OF_SCENE.mirrors();
    }

    @Override
    public boolean reaches(Lamp lamp, HitRows rows, Tracer tracer) {
        return forced.contains(Effect.SPOT_CONE) || OF_SCENE.reaches(lamp, rows, tracer);
    }

    @Override
    public boolean meets(Candidates blockers) {
        return forced.contains(Effect.SHADOWS) || OF_SCENE.meets(blockers);
    }

    @Override
    public boolean isSpecular(MaterialTable materials, int material) {
        return forced.contains(Effect.SPECULAR) || OF_SCENE.isSpecular(materials, material);
    }

    @Override
    public boolean fallsOff(Lamp lamp) {
        return OF_SCENE.fallsOff(lamp)
                || !lamp.isArea() && lamp.type().hasPosition()
                        && (forced.contains(Effect.ATTENUATION) || forced.contains(Effect.DROPOFF) || forced.contains(Effect.BARN_DOORS)
                                || forced.contains(Effect.GOBOS) || forced.contains(Effect.PROFILES));
    }
}
