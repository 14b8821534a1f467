package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.ValueKind;
import lightning.scene.value.SceneLimits;

/**
 * Size of an area light. The light's type decides which values act; {@link LightAttribute} has their ranges and units.
 *
 * @param radius  radius of a point or spot light's ball, or of a disc
 * @param spread  half-angle of a directional light's cone of directions
 * @param width   width of a rectangle, across {@code up}
 * @param height  height of a rectangle, along {@code up}
 * @param up      direction of a rectangle's height, or of the top of a disc's image, projected perpendicular to its direction; any length
 * @param samples number of points or directions that are averaged
 * @param visibility whether the camera sees the light itself; a directional light is never seen
 * @param hardShadows true if the light shines from its center, with hard shadows and the mean color of its texture, in a view without soft shadows; not part of a document
 * @param shape       name of the shape that shines; empty for none
 * @param surface     surface of this shape where the scene has placed it, derived by {@link LightRig}; not part of a document
 */
@RecordBuilder
public record AreaShape(double radius, double spread, double width, double height, Vec3 up, int samples,
        FaceVisibility visibility, boolean hardShadows, String shape, Optional<ObjectSurface> surface) implements AreaShapeBuilder.With {
    static final NumericKind<Double> EXTENTS = NumericKind.number(0, SceneLimits.MAX_EXTENT, 0.1);
    static final NumericKind<Vec3> UPS = NumericKind.direction();
    static final NumericKind<Double> SPREADS = NumericKind.degrees(0, SceneLimits.MAX_SPREAD, 0.5);
    static final NumericKind<Integer> SAMPLE_COUNTS = NumericKind.integer(SceneLimits.MIN_LIGHT_SAMPLES, SceneLimits.MAX_LIGHT_SAMPLES);

    static final ValueKind.NameKind SHAPES = new ValueKind.NameKind(ValueKind.NameKind.Referent.SHAPE, Messages.key("Object that shines"));

    /** Initial values of a light. */
    public static final AreaShape DEFAULT = new AreaShape(0, 0, 1, 1, Vec3.Y, 16);

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public AreaShape {
        EXTENTS.check("radius", radius);
        SPREADS.check("spread", spread);
        EXTENTS.check("width", width);
        EXTENTS.check("height", height);
        UPS.check("up", up);
        SAMPLE_COUNTS.check("samples", samples);
        SHAPES.check("shape", shape);
    }

    /** Creates the size of a light that the camera does not see. */
    public AreaShape(double radius, double spread, double width, double height, Vec3 up, int samples) {
        this(radius, spread, width, height, up, samples, FaceVisibility.HIDDEN, false, "", Optional.empty());
    }

    /**
     * Returns the unit vector along the width of a rectangle or disc, perpendicular to its direction and {@link #up}. If these are parallel, uses the
     * axis that is least parallel to the direction.
     *
     * @param direction direction of unit length
     */
    public Vec3 right(Vec3 direction) {
        Vec3 right = direction.cross(up.normalized());
        if (right.maxAbs() < 1e-6) {
            double x = Math.abs(direction.x());
            double y = Math.abs(direction.y());
            double z = Math.abs(direction.z());
            right = direction.cross(x <= y && x <= z ? new Vec3(1, 0, 0) : y <= z ? Vec3.Y : new Vec3(0, 0, 1));
        }
        return right.normalized();
    }
}
