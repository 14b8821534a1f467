package lightning.render.shading;

import lightning.base.math.Vec3;
import lightning.render.trace.HitRows;
import lightning.scene.BarnDoors;
import lightning.scene.Gobo;
import lightning.scene.IesProfile;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Photometry;
import lightning.scene.Texture;

/**
 * What the barn doors of a spot or rectangle, a spot's gobo and a light's profile leave of its light in a direction, a factor of its falloff.
 *
 * <p>Seen from the light, which looks along its axis with y upwards, a point lies at an angle to the right and at one to the top, each taken
 * in the plane of the axis and that side. A door at angle θ leaves 1 up to θ less the feather, 0 beyond θ, and between them
 * t²(3 − 2t), t being how far inside of θ the point lies over the feather; without feather a point on the edge is lit. The factors of the four
 * doors are multiplied. A gobo is a square that just holds the cone where it is less than 89 degrees wide, and else what a cone of 89 degrees
 * would hold; seen from the light its left is left and its top is up. Between the centers of its pixels it is interpolated bilinearly,
 * beyond the outermost ones it goes on as they are; what passes is its luminance, 0.2126 R + 0.7152 G + 0.0722 B of linear light
 * (ITU-R BT.709). A light that looks straight up or down has z upwards. A rectangle lies as its {@code up} tells, and its doors cut off each of its
 * samples at the same angle, as the slats of a honeycomb do: what they leave fades over the rectangle's width.
 *
 * <p>A profile is a factor of two angles. Those of type C are from the axis and around it, counterclockwise from the right as the light looks out,
 * so that 90 is its top; where a point is on the axis the second is 0. Of type A the planes stand upright: their angle is from the axis to the right,
 * and that in a plane upwards. Of type B they share the axis from left to right: their angle is upwards, that in a plane to the right. A point
 * light has the axis −y.
 */
public final class AngularMask {
    /** Below this length of axis × y the light looks straight up or down. */
    private static final double MIN_SIDE_LENGTH = 1e-6;
    /** The widest half angle that a gobo is spread over, in degrees. */
    private static final double MAX_GOBO_ANGLE = 89;
    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private final Vec3 position;
    private final Vec3 axis;
    private final Vec3 right;
    private final Vec3 up;
    private final BarnDoors doors;
    private final double feather;
    private final Texture gobo;
    private final Photometry photometry;
    /** Half the gobo's side, at distance 1 along the axis. */
    private final double goboHalfSize;
    private final float[] color = new float[3];

    private AngularMask(LightSource source) {
        position = source.position();
        boolean spot = source.type() == LightType.SPOT;
        boolean hasDoors = LightAttribute.DOORS.appliesTo(source.type());
        axis = hasDoors ? source.axis() : DOWN;
        right = source.type() == LightType.RECT ? source.light().area().right(axis) : right(axis);
        up = right.cross(axis);
        doors = hasDoors ? source.light().doors() : BarnDoors.OPEN;
        feather = source.light().feather();
        gobo = spot ? source.light().gobo().map(Gobo::image).orElse(null) : null;
        photometry =
                LightAttribute.PROFILE.appliesTo(source.type()) ? source.light().profile().map(IesProfile::photometry).orElse(null) : null;
        goboHalfSize = StrictMath.tan(Math.toRadians(Math.min(source.light().angle(), MAX_GOBO_ANGLE)));
    }

    private static Vec3 right(Vec3 axis) {
        Vec3 side = axis.cross(Vec3.Y);
        return (side.length() < MIN_SIDE_LENGTH ? axis.cross(new Vec3(0, 0, 1)) : side).normalized();
    }

    /** Whether anything stands before a lamp. */
    static boolean isActive(LightSource source) {
        return switch (source.type()) {
            case SPOT -> !source.light().doors().isOpen() || source.light().gobo().isPresent() || source.light().profile().isPresent();
            case POINT -> source.light().profile().isPresent();
            case RECT -> !source.light().doors().isOpen();
            case DIRECTIONAL, DISC -> false;
        };
    }

    /** What stands before a lamp; null where nothing does. */
    public static AngularMask of(LightSource source) {
        return isActive(source) ? new AngularMask(source) : null;
    }

    /** The factor at a point in render space, 0 … 1. */
    double factor(float px, float py, float pz) {
        double x = px - position.x();
        double y = py - position.y();
        double z = pz - position.z();
        double forward = x * axis.x() + y * axis.y() + z * axis.z();
        double side = x * right.x() + y * right.y() + z * right.z();
        double height = x * up.x() + y * up.y() + z * up.z();
        return doorFactor(-side, forward, doors.left()) * doorFactor(side, forward, doors.right())
                * doorFactor(-height, forward, doors.bottom()) * doorFactor(height, forward, doors.top())
                * (gobo == null ? 1 : goboFactor(side, height, forward * goboHalfSize))
                * (photometry == null ? 1 : profileFactor(side, height, forward));
    }

    /** What the gobo lets through; {@code extent} is half its side where the point is. */
    private double goboFactor(double side, double height, double extent) {
        // In a cone without an opening all light goes through the middle.
        boolean middle = !(extent > 0);
        double x = middle ? 0.5 * gobo.width() : (1 + side / extent) / 2 * gobo.width();
        double y = middle ? 0.5 * gobo.height() : (1 - height / extent) / 2 * gobo.height();
        double column = Math.clamp(x - 0.5, 0, gobo.width() - 1.0);
        double row = Math.clamp(y - 0.5, 0, gobo.height() - 1.0);
        int x0 = (int) column;
        int y0 = (int) row;
        gobo.interpolate(x0, y0, Math.min(x0 + 1, gobo.width() - 1), Math.min(y0 + 1, gobo.height() - 1), column - x0, row - y0, color);
        return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    }

    private double profileFactor(double side, double height, double forward) {
        return switch (photometry.type()) {
            case C -> {
                double around = degrees(height, side);
                yield photometry.sample(degrees(Math.sqrt(side * side + height * height), forward), around < 0 ? around + 360 : around);
            }
            case B -> photometry.sample(degrees(height, forward), degrees(side, Math.sqrt(forward * forward + height * height)));
            case A -> photometry.sample(degrees(height, Math.sqrt(side * side + forward * forward)), degrees(side, forward));
        };
    }

    /** The same on every machine, which the quicker one of Math is not held to. */
    private static double degrees(double y, double x) {
        return Math.toDegrees(StrictMath.atan2(y, x));
    }

    /** What one door leaves; the point is so far across to its side, and so far ahead of the light. */
    private double doorFactor(double across, double forward, double door) {
        if (door == BarnDoors.OPEN_ANGLE) {
            return 1;
        }
        double inside = door - degrees(across, forward);
        if (feather == 0) {
            return inside >= 0 ? 1 : 0;
        }
        double t = Math.clamp(inside / feather, 0, 1);
        return t * t * (3 - 2 * t);
    }

    /** Multiplies the factors of all rows of a tile. */
    public void multiply(HitRows rows, double[] factors) {
        for (int i = 0; i < rows.count; i++) {
            factors[i] *= factor(rows.px[i], rows.py[i], rows.pz[i]);
        }
    }
}
