package lightning.render.match;

import java.util.List;
import java.util.Optional;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/**
 * Factors of lights with which a picture comes closest to a reference.
 *
 * @param moved       scene with the lights that have another place, direction, cone or temperature, or another rotation of the environment, before their
 *                    factors apply; empty if none changes
 * @param factors     one for each light that could be changed and contributes to the picture, in the scene's order
 * @param errorBefore weighted root mean square of the difference from the reference before, relative to the reference,
 *                    where it shall change
 * @param errorAfter  the same after; not larger than before, up to rounding
 * @param exposure    factors by which red, green and blue of the reference were scaled to fit; 1 if brightness and tint count
 * @param alike       pairs of lights whose light looks alike in this picture, so that only their sum is known
 * @param unseen      lights that contribute nothing to the picture
 */
public record MatchResult(Optional<Scene> moved, List<LightFactor> factors, double errorBefore, double errorAfter, List<Double> exposure,
        List<LightPair> alike, List<Contribution> unseen) {
    /** Two lights or environments. */
    public record LightPair(Contribution first, Contribution second) {}
}
