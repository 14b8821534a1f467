package lightning.render.shading;

import java.util.function.Predicate;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Material;
import lightning.scene.effects.ViewEffects;

/** What of the work on a tile is called for. Asked once for each tile and light, or for each material of a tile. */
public interface Demands {
    /** Which materials cast mirrored rays. */
    Predicate<Material> mirrors();

    /** Whether rows must be asked if they are in a light's cone. */
    boolean reaches(Lamp lamp, HitRows rows, Tracer tracer);

    /** Whether rays must be cast among these shapes. */
    boolean meets(Candidates blockers);

    /** Whether specular terms of rows of a material are needed. */
    boolean isSpecular(MaterialTable materials, int material);

    /** Whether falloffs to a light are needed. */
    boolean fallsOff(Lamp lamp);

    /** Those of a view: of the scene, and more where it forces effects. */
    static Demands of(ViewEffects view) {
        return view.forced().isEmpty() ? OF_SCENE : new ForcedDemands(view.forced());
    }

    /** What changes the picture, and no more. */
    Demands OF_SCENE = new Demands() {
        @Override
        public Predicate<Material> mirrors() {
            return MaterialTable.MIRRORS;
        }

        @Override
        public boolean reaches(Lamp lamp, HitRows rows, Tracer tracer) {
            return rows.count == 0 || !lamp.hasCone() || ConeReach.mayReach(lamp, rows.box(tracer));
        }

        @Override
        public boolean meets(Candidates blockers) {
            return !blockers.isEmpty();
        }

        @Override
        public boolean isSpecular(MaterialTable materials, int material) {
            return materials.isSpecular(material);
        }

        @Override
        public boolean fallsOff(Lamp lamp) {
            return lamp.fallsOff();
        }
    };
}
