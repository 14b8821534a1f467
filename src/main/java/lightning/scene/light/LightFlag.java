package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Vec3;
import lightning.scene.attribute.NumericKind;
import lightning.scene.value.SceneLimits;

/**
 * Card between a light and the scene that only this light sees: a flag, or a scrim if it lets some light through.
 *
 * @param on       whether the light has it
 * @param position its center, scene units
 * @param rotation degrees about x, then y, then z; without one it is upright and faces z
 * @param width    scene units
 * @param height   scene units
 * @param softness width of its soft edge inside its outline, as a share of half its size
 * @param density  share of the light that it takes, 0…1
 */
@RecordBuilder
public record LightFlag(boolean on, Vec3 position, Vec3 rotation, double width, double height, double softness, double density)
        implements LightFlagBuilder.With {
    static final NumericKind<Double> LENGTHS = NumericKind.number(0, SceneLimits.MAX_EXTENT, 0.1);
    public static final LightFlag NONE = new LightFlag(false, Vec3.ZERO, Vec3.ZERO, 1, 1, 0, 1);

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public LightFlag {
        SceneLimits.checkPosition("flag_at", position);
        LightFilter.ROTATIONS.check("flag_rotate", rotation);
        LENGTHS.check("flag_width", width);
        LENGTHS.check("flag_height", height);
        LightFilter.SHARES.check("flag_softness", softness);
        LightFilter.SHARES.check("flag_density", density);
    }
}
