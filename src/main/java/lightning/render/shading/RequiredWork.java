package lightning.render.shading;

import java.util.function.Predicate;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.CandidateList;
import lightning.scene.Material;
import lightning.scene.effects.ViewEffects;

/** What of the work on a tile is called for. Asked once for each tile and light, or for each material of a tile. */
public interface RequiredWork {
    /** Which materials cast mirrored rays. */
    Predicate<Material> mirrorMaterials();

    /** Whether rows must be asked if they are in a light's cone. */
    boolean needsConeTest(LightSource source, HitRows rows, Tracer tracer);

    /** Whether rays must be cast among these shapes. */
    boolean needsShadowRays(CandidateList blockers);

    /** Whether specular terms of rows of a material are needed. */
    boolean needsSpecular(MaterialTable materials, int material);

    /** Whether falloffs to a light are needed. */
    boolean needsFalloff(LightSource source);

    /** Those of a view: of the scene, and more where it forces effects. */
    static RequiredWork of(ViewEffects view) {
        return view.forced().isEmpty() ? SCENE_ONLY : new ForcedWork(view.forced());
    }

    /** What changes the picture, and no more. */
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
