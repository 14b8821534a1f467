package lightning.shading;

import lightning.math.Vec3;
import lightning.scene.BarnDoors;
import lightning.scene.LightType;
import lightning.trace.HitRows;

/**
 * What a spot light's barn doors leave of its light in a direction, a factor of its falloff.
 *
 * <p>Seen from the light, which looks along its axis with y upwards, a point lies at an angle to the right and at one to the top, each taken
 * in the plane of the axis and that side. A door at angle θ leaves 1 up to θ less the feather, 0 beyond θ, and between them
 * t²(3 − 2t), t being how far inside of θ the point lies over the feather; without feather a point on the edge is lit. The factors of the four
 * doors are multiplied. A light that looks straight up or down has z upwards.
 */
final class DoorFactor {
    /** Below this length of axis × y the light looks straight up or down. */
    private static final double STRAIGHT = 1e-6;

    private final Vec3 source;
    private final Vec3 axis;
    private final Vec3 right;
    private final Vec3 up;
    private final BarnDoors doors;
    private final double feather;

    private DoorFactor(Lamp lamp) {
        source = lamp.source();
        axis = lamp.axis();
        Vec3 side = axis.cross(Vec3.Y);
        right = (side.length() < STRAIGHT ? axis.cross(new Vec3(0, 0, 1)) : side).normalized();
        up = right.cross(axis);
        doors = lamp.light().doors();
        feather = lamp.light().feather();
    }

    /** Whether doors of a lamp cut anything off. */
    static boolean acts(Lamp lamp) {
        return lamp.type() == LightType.SPOT && !lamp.light().doors().isOpen();
    }

    /** The doors of a lamp; null where they cut nothing off. */
    static DoorFactor of(Lamp lamp) {
        return acts(lamp) ? new DoorFactor(lamp) : null;
    }

    /** The factor at a point in render space, 0 … 1. */
    double at(float px, float py, float pz) {
        double x = px - source.x();
        double y = py - source.y();
        double z = pz - source.z();
        double ahead = x * axis.x() + y * axis.y() + z * axis.z();
        double side = x * right.x() + y * right.y() + z * right.z();
        double height = x * up.x() + y * up.y() + z * up.z();
        return left(-side, ahead, doors.left()) * left(side, ahead, doors.right())
                * left(-height, ahead, doors.bottom()) * left(height, ahead, doors.top());
    }

    /** What one door leaves; the point is so far across to its side, and so far ahead of the light. */
    private double left(double across, double ahead, double door) {
        if (door == BarnDoors.AWAY) {
            return 1;
        }
        // The same on every machine, which the quicker one of Math is not held to.
        double inside = door - Math.toDegrees(StrictMath.atan2(across, ahead));
        if (feather == 0) {
            return inside >= 0 ? 1 : 0;
        }
        double t = Math.clamp(inside / feather, 0, 1);
        return t * t * (3 - 2 * t);
    }

    /** Multiplies the factors of all rows of a tile. */
    void multiply(HitRows rows, double[] factors) {
        for (int i = 0; i < rows.count; i++) {
            factors[i] *= at(rows.px[i], rows.py[i], rows.pz[i]);
        }
    }
}
