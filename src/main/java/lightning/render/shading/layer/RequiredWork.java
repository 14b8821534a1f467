package lightning.render.shading.layer;

import java.util.function.Predicate;
import lightning.render.shading.LightSource;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.effects.ViewEffects;
import lightning.scene.material.Material;

/** Decides which work a tile requires. Queried once for each tile and light, or for each material of a tile. */
public interface RequiredWork {
    /** Returns the materials that cast mirrored rays. */
    Predicate<Material> mirrorMaterials();

    /** Returns whether rows must be tested against a light's cone. */
    boolean needsConeTest(LightSource source, HitRows rows, Tracer tracer);

    /** Returns whether shadow rays must be cast among these shapes. */
    boolean needsShadowRays(CandidateList blockers);

    /** Returns whether specular terms of rows of a material are needed. */
    boolean needsSpecular(MaterialTable materials, int material);

    /** Returns whether falloffs of a light are needed. */
    boolean needsFalloff(LightSource source);

    /** Returns the required work of a view: that of the scene, and more for forced effects. */
    static RequiredWork of(ViewEffects view) {
        return view.forced().isEmpty() ? SCENE_ONLY : new ForcedWork(view.forced());
    }

    /** Requires only work that changes the picture. */
    RequiredWork SCENE_ONLY = new RequiredWork() {
        @Override
        public Predicate<Material> mirrorMaterials() {
            return MaterialTable.CASTS_REFLECTIONS;
        }

        @Override
        public boolean needsConeTest(LightSource lamp, HitRows rows, Tracer tracer) {
            return rows.count == 0 || !lamp.hasCone() || ConeCulling.canReach(lamp, rows.bounds(tracer));
        }

        @Override
        public boolean needsShadowRays(CandidateList blockers) {
            return !blockers.isEmpty();
        }

        @Override
        public boolean needsSpecular(MaterialTable materials, int material) {
            return materials.isSpecular(material);
        }

        @Override
        public boolean needsFalloff(LightSource lamp) {
            return lamp.needsFalloffColumn();
        }
    };
}
