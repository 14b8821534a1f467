package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Vec3;

/**
 * How large a light is. Its type decides which of these act; {@link LightAttribute} tells their ranges and units.
 *
 * @param radius  of the ball that a point or spot light is, and of a disc
 * @param spread  the angle between a directional light's direction and the farthest from which it shines too
 * @param width   of a rectangle, across {@code up}
 * @param height  of a rectangle, along {@code up}
 * @param up      to where a rectangle's height goes, as far as its direction lets it, any length
 * @param samples of how many points, or directions, its light is the mean
 */
@RecordBuilder
public record AreaShape(double radius, double spread, double width, double height, Vec3 up, int samples) implements AreaShapeBuilder.With {
    /** What a light has of which nothing else was said. */
    public static final AreaShape DEFAULT = new AreaShape(0, 0, 1, 1, Vec3.Y, 16);

    /**
     * The unit vector along a rectangle's width: across its direction and {@link #up}, or across the direction and that axis which
     * lies least along it where {@code up} lies along it.
     *
     * @param direction of unit length
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
