package lightning.render.relight.plan;

import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import lightning.render.cache.LayerStamp;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.ConeChange;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightTerm;

/**
 * Difference between the light that a layer was computed for and the target light, in the terms that decide the update. Attributes
 * without effect for the light's type do not count.
 *
 * @param moved      true if the source changed: position, direction of a directional light, or one for the other
 * @param coneChange rows that may enter or leave the cone
 * @param falloff    true if the falloff of any row may change
 * @param weight     true if color · intensity changes
 * @param shadows    true if other shapes cast shadows from the light
 */
public record LightDifference(boolean moved, ConeChange coneChange, boolean falloff, boolean weight, boolean shadows) {

    /** Returns the difference from the light and the fog that layers were computed for. */
    public static LightDifference between(LayerStamp before, WeightedLight target) {
        LightDifference ofLight = between(before.light(), target.light());
        return Objects.equals(before.fog(), target.source().fog()) ? ofLight
                : new LightDifference(ofLight.moved, ofLight.coneChange, true, ofLight.weight, ofLight.shadows);
    }

    /** Returns the difference in clear air. */
    public static LightDifference between(Light before, Light target) {
        Set<LightTerm> changed = changedTerms(before, target);
        ConeChange cone = coneChange(changed, before, target);
        return new LightDifference(changed.contains(LightTerm.SOURCE), cone,
                changed.contains(LightTerm.FALLOFF) || cone == ConeChange.TURN || cone != ConeChange.NONE && target.gobo().isPresent(),
                changed.contains(LightTerm.WEIGHT), changed.contains(LightTerm.SHADOW_LINKS));
    }

    /** Returns the least update to the target light: all terms if the light moved, otherwise the difference. */
    public LightUpdate update() {
        if (moved) {
            return new LightUpdate.FullRecompute(false);
        }
        if (coneChange != ConeChange.NONE || falloff || shadows) {
            return new LightUpdate.Partial(coneChange, falloff, weight, shadows);
        }
        return weight ? new LightUpdate.Reweight() : new LightUpdate.Keep();
    }

    /** Returns the terms of attributes whose effective value changes or whose effect starts or ends. */
    private static Set<LightTerm> changedTerms(Light before, Light target) {
        Set<LightTerm> changed = EnumSet.noneOf(LightTerm.class);
        for (LightAttribute<?> attribute : before == target ? List.<LightAttribute<?>>of() : LightAttribute.ALL) {
            Optional<LightTerm> was = attribute.term(before);
            Optional<LightTerm> is = attribute.term(target);
            if (!was.equals(is) || is.isPresent() && !attribute.isEquivalent(before, target)) {
                was.ifPresent(changed::add);
                is.ifPresent(changed::add);
            }
        }
        if (!before.area().surface().equals(target.area().surface())) {
            changed.add(LightTerm.SOURCE);
        }
        return changed;
    }

    private static ConeChange coneChange(Set<LightTerm> changed, Light before, Light target) {
        if (changed.contains(LightTerm.CONE_AXIS)) {
            return ConeChange.TURN;
        }
        if (changed.contains(LightTerm.ILLUMINATION_LINKS)) {
            return ConeChange.LINKS;
        }
        return !changed.contains(LightTerm.CONE_ANGLE) ? ConeChange.NONE
                : before.angle() > target.angle() ? ConeChange.ANGLE_REMOVE : ConeChange.ANGLE_ADD;
    }
}
