package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Vec3;
import lightning.base.text.NumberUnit;
import lightning.scene.attribute.NumericKind;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/**
 * Region in which a light is dimmer, or outside of which it is.
 *
 * @param shape    where it acts
 * @param position center of its box, scene units
 * @param rotation degrees about x, then y, then z
 * @param size     lengths of its box before the rotation, scene units
 * @param softness width of its soft edge, as a share of half its size; a ramp has no edge
 * @param density  share of the light that it takes where it acts fully, 0…1
 * @param inverted whether it acts where its shape does not
 */
@RecordBuilder
public record LightFilter(FilterShape shape, Vec3 position, Vec3 rotation, Vec3 size, double softness, double density, boolean inverted)
        implements LightFilterBuilder.With {
    static final NumericKind<Vec3> ROTATIONS =
            NumericKind.axes(SceneLimits.MAX_ROTATION, 1, NumberUnit.DEGREES, (_, v) -> Placement.IDENTITY.withRotation(v));
    static final NumericKind<Vec3> SIZES = NumericKind.lengths(SceneLimits.MAX_EXTENT);
    static final NumericKind<Double> SHARES = NumericKind.number(0, 1, 0.1);
    public static final LightFilter NONE = new LightFilter(FilterShape.NONE, Vec3.ZERO, Vec3.ZERO, new Vec3(1, 1, 1), 0, 1, false);

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public LightFilter {
        SceneLimits.checkPosition("filter_at", position);
        ROTATIONS.check("filter_rotate", rotation);
        SIZES.check("filter_size", size);
        SHARES.check("filter_softness", softness);
        SHARES.check("filter_density", density);
    }

    /** Returns whether it dims the light anywhere. */
    public boolean isActive() {
        return shape != FilterShape.NONE;
    }
}
