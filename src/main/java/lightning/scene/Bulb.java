package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;

/**
 * Light whose bulb a surface is: it glows while the light shines.
 *
 * @param light name of the light; empty for none. A light that the scene does not have is dark
 * @param gain  factor of the light's color times intensity
 * @param glow  linear color of the glow, derived from the light by {@link Stage#withBulbs}
 */
@RecordBuilder
public record Bulb(String light, double gain, Rgb glow) implements BulbBuilder.With {
    /** No bulb. */
    public static final Bulb NONE = new Bulb("", 1, Rgb.BLACK);

    /** Returns this bulb with the glow of its light in a rig. */
    Bulb litBy(LightRig rig) {
        Rgb weight = rig.light(light).filter(rig::isActive).map(l -> rig.effectiveLight(l).weight()).orElse(Rgb.BLACK);
        return new Bulb(light, gain, new Rgb(limited(weight.r()), limited(weight.g()), limited(weight.b())));
    }

    private double limited(double channel) {
        return Math.min(channel * gain, SceneLimits.MAX_EMISSION);
    }
}
