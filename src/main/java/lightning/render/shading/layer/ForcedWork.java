package lightning.render.shading.layer;

import java.util.Set;
import java.util.function.Predicate;
import lightning.render.shading.LightSource;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.effects.RenderEffect;
import lightning.scene.material.Material;

/**
 * Required work that includes effects which the scene does not use. The picture is the same. Used to measure what skipping unused
 * effects saves.
 *
 * @param forced the effects
 */
record ForcedWork(Set<RenderEffect> forced) implements RequiredWork {
    private static final Predicate<Material> ANY_MATERIAL = _ -> true;

    @Override
    public Predicate<Material> mirrorMaterials() {
        return forced.contains(RenderEffect.REFLECTION) ? ANY_MATERIAL : SCENE_ONLY.mirrorMaterials();
    }

    @Override
    public boolean needsConeTest(LightSource source, HitRows rows, Tracer tracer) {
        return forced.contains(RenderEffect.SPOT_CONE) || SCENE_ONLY.needsConeTest(source, rows, tracer);
    }

    @Override
    public boolean needsShadowRays(CandidateList blockers) {
        return forced.contains(RenderEffect.SHADOWS) || SCENE_ONLY.needsShadowRays(blockers);
    }

    @Override
    public boolean needsSpecular(MaterialTable materials, int material) {
        return forced.contains(RenderEffect.SPECULAR) || SCENE_ONLY.needsSpecular(materials, material);
    }

    @Override
    public boolean needsFalloff(LightSource source) {
        return SCENE_ONLY.needsFalloff(source)
                || !source.isArea() && source.type().hasPosition()
                        && (forced.contains(RenderEffect.ATTENUATION) || forced.contains(RenderEffect.DROPOFF)
                                || forced.contains(RenderEffect.BARN_DOORS)
                                || forced.contains(RenderEffect.GOBOS) || forced.contains(RenderEffect.PROFILES)
                                || forced.contains(RenderEffect.FLAGS) || forced.contains(RenderEffect.LIGHT_FILTERS));
    }
}
