package lightning.shading;

import java.util.ArrayList;
import java.util.List;
import lightning.math.Rgb;
import lightning.scene.Material;
import lightning.scene.Scene;

/**
 * Which effects a view shows: a state of looking, no part of the scene. The editor's preview is the
 * engine with effects taken away.
 *
 * @param shadows     whether lights are blocked; else every row that faces a light in its cone is lit
 * @param reflections whether mirrors are followed; else reflectivity counts as 0
 * @param litTextures whether lights fall on textures; else a texture emits its own colour, as the
 *                    paper's preview has it (§3.1)
 */
public record ViewEffects(boolean shadows, boolean reflections, boolean litTextures) {
    /** Everything: what a picture is. */
    public static final ViewEffects ALL = new ViewEffects(true, true, true);
    /** The fast shading of the preview (paper §3.3). */
    public static final ViewEffects PREVIEW = new ViewEffects(false, false, false);

    /** The scene that this view traces: the same, or one without mirrors. */
    public Scene of(Scene scene) {
        if (reflections) {
            return scene;
        }
        List<Material> dull = new ArrayList<>();
        for (Material m : scene.materials()) {
            dull.add(m.withReflective(Rgb.BLACK));
        }
        return new Scene(scene.picture().withDepth(0), scene.camera(), scene.world(), dull, scene.nodes(), scene.lights());
    }
}
