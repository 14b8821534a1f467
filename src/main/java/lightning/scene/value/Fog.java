package lightning.scene.value;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;

/**
 * Air that scatters light: fog, haze or smoke that stands still.
 *
 * @param density    share of light that is lost per scene unit, up to the height: the extinction coefficient, ≥ 0; 0 for clear air
 * @param color      share of the lost light that is scattered, not absorbed: the single-scattering albedo, 0…1
 * @param ambient    linear color of light that comes evenly from all sides and that the fog scatters, ≥ 0
 * @param anisotropy mean cosine of the scattering angle: above 0 light keeps its direction, below 0 it turns back
 * @param height     y up to which the density is full, scene units
 * @param falloff    decrease of the density's logarithm per scene unit above the height, ≥ 0; 0 for the same density everywhere
 * @param center     center of the box that contains the fog, scene units
 * @param size       lengths of the box along x, y and z, scene units; 0 for fog everywhere
 */
@RecordBuilder
public record Fog(double density, Rgb color, Rgb ambient, double anisotropy, double height, double falloff, Vec3 center, Vec3 size)
        implements FogBuilder.With {
    /** Clear air. */
    public static final Fog NONE = new Fog(0, Rgb.gray(1), Rgb.BLACK, 0, 0, 0, Vec3.ZERO, Vec3.ZERO);

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public Fog {
        SceneLimits.checkRange("fog", density, 0, SceneLimits.MAX_FOG_DENSITY);
        SceneLimits.checkRange("fog_color", color, 1);
        SceneLimits.checkRange("fog_ambient", ambient, SceneLimits.MAX_EMISSION);
        SceneLimits.checkRange("fog_anisotropy", anisotropy, -SceneLimits.MAX_ANISOTROPY, SceneLimits.MAX_ANISOTROPY);
        SceneLimits.checkRange("fog_height", height, -SceneLimits.MAX_COORDINATE, SceneLimits.MAX_COORDINATE);
        SceneLimits.checkRange("fog_falloff", falloff, 0, SceneLimits.MAX_FOG_DENSITY);
        SceneLimits.checkPosition("fog_center", center);
        SceneLimits.checkRange("fog_size", size, 0, SceneLimits.MAX_COORDINATE);
    }

    /** Returns whether the air scatters light. */
    public boolean isPresent() {
        return density > 0;
    }

    /** Returns whether the fog is only in a box. */
    public boolean hasBox() {
        return size.maxAbs() > 0;
    }
}
