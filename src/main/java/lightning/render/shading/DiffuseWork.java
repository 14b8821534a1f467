package lightning.render.shading;

import java.util.function.Predicate;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.Material;

/**
 * Required work without specular terms, for surfels: they send light diffusely only.
 *
 * @param others all other work
 */
record DiffuseWork(RequiredWork others) implements RequiredWork {
    @Override
    public Predicate<Material> mirrorMaterials() {
        return others.mirrorMaterials();
    }

    @Override
    public boolean needsConeTest(LightSource source, HitRows rows, Tracer tracer) {
        return others.needsConeTest(source, rows, tracer);
    }

    @Override
    public boolean needsShadowRays(CandidateList blockers) {
        return others.needsShadowRays(blockers);
    }

    @Override
    public boolean needsSpecular(MaterialTable materials, int material) {
        return false;
    }

    @Override
    public boolean needsFalloff(LightSource source) {
        return others.needsFalloff(source);
    }
}
