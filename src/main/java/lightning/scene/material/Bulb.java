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
 */
@RecordBuilder
public record Bulb(String light, double exposure, Rgb glow) implements BulbBuilder.With {
    /** No bulb. */
    public static final Bulb NONE = new Bulb("", 0, Rgb.BLACK);

    /** Returns this bulb with the glow of its light in a rig: its color and intensity, or of a light of an object the radiance of its surface. */
    public Bulb litBy(LightRig rig) {
        Rgb weight = rig.light(light).filter(rig::isActive)
                .map(l -> l.type() == LightType.OBJECT ? rig.radiance(l) : rig.effectiveLight(l).weight()).orElse(Rgb.BLACK);
        double gain = StrictMath.pow(2, exposure);
        return new Bulb(light, exposure, limited(weight.times(gain)));
    }

    /** Returns a color that a surface may emit. */
    public static Rgb limited(Rgb color) {
        return new Rgb(limited(color.r()), limited(color.g()), limited(color.b()));
    }

    private static double limited(double channel) {
        return Math.min(channel, SceneLimits.MAX_EMISSION);
    }
}
