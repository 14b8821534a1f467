package lightning.bench.result;

import java.util.List;

/**
 * Results of one modern scene.
 *
 * @param scene    scene name: its file name without extension
 * @param pictures results with and without anti-aliasing
 * @param curves   time against error, one per program; empty if not measured
 * @param losses   features that POV-Ray does not support exactly, as in {@code light key: its light links are left out}
 */
public record ModernScene(String scene, List<ModernPicture> pictures, List<ErrorCurve> curves, List<String> losses) {
    public ModernScene {
        pictures = List.copyOf(pictures);
        curves = List.copyOf(curves);
        losses = List.copyOf(losses);
    }
}
