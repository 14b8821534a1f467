package lightning.scene.material;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;
import lightning.scene.Stage;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;

/**
 * Light whose bulb a surface is: it glows while the light shines.
 *
 * @param light    name of the light; empty for none. A light that the scene does not have is dark
 * @param exposure stops, relative to the light's color times intensity
 * @param glow     linear color of the glow before the material's glow map, derived from the light by {@link Stage#withBulbs}
 * @param unit     the same for a light of weight 1 in each channel, on or off
 */
@RecordBuilder
public record Bulb(String light, double exposure, Rgb glow, Rgb unit) implements BulbBuilder.With {
    /** No bulb. */
    public static final Bulb NONE = new Bulb("", 0, Rgb.BLACK, Rgb.BLACK);

    /** Returns this bulb with the glow of its light in a rig: its color and intensity, or of a light of an object the radiance of its surface. */
    public Bulb litBy(LightRig rig) {
        return rig.light(light).map(l -> litBy(l, rig, l.type() == LightType.OBJECT ? rig.radianceFactor(l) : 1, SceneLimits.MAX_EMISSION))
                .orElse(withGlow(Rgb.BLACK).withUnit(Rgb.BLACK));
    }

    /**
     * Returns this bulb with the glow of a light of a rig.
     *
     * @param factor of its color times intensity, before the exposure
     * @param max    largest glow
     */
    public Bulb litBy(Light its, LightRig rig, double factor, double max) {
        Light effective = rig.effectiveLight(its);
        double gain = factor * StrictMath.pow(2, exposure);
        Rgb shine = effective.weight().times(gain);
        Rgb limited = new Rgb(Math.min(shine.r(), max), Math.min(shine.g(), max), Math.min(shine.b(), max));
        Rgb weight = effective.limitedWeight();
        boolean isLimited = !limited.equals(shine) || !weight.equals(effective.weight());
        Rgb ofOne = !isLimited ? Rgb.gray(gain)
                : new Rgb(ratio(limited.r(), weight.r(), gain), ratio(limited.g(), weight.g(), gain), ratio(limited.b(), weight.b(), gain));
        return new Bulb(its.name(), exposure, rig.isActive(its) ? limited : Rgb.BLACK, ofOne);
    }

    private static double ratio(double glow, double weight, double otherwise) {
        return weight > 0 ? Math.min(glow / weight, otherwise) : otherwise;
    }
}
