package lightning.scene.value;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Rotation of an environment: first about z, then about x, then about y, each counter-clockwise seen from the positive axis. So a level
 * horizon stays level when the environment turns about y.
 *
 * @param rotation degrees about y
 * @param tilt     degrees about x
 * @param roll     degrees about z
 * @param toWorld  maps a direction of the image to the scene
 */
public record DomeRotation(double rotation, double tilt, double roll, Transform toWorld) {
    public static final DomeRotation NONE = of(0, 0, 0);

    /** Shortest horizontal part of an axis that has a direction. */
    private static final double MIN_LENGTH = 1e-9;

    public static DomeRotation of(double rotation, double tilt, double roll) {
        return new DomeRotation(rotation, tilt, roll, Transform.rotation(new Vec3(0, rotation, 0))
                .times(Transform.rotation(new Vec3(tilt, 0, 0))).times(Transform.rotation(new Vec3(0, 0, roll))));
    }

    /**
     * Returns the rotation of a matrix.
     *
     * @param m maps directions of the image to the scene; a rotation, which may be scaled
     */
    public static DomeRotation of(Transform m) {
        Vec3 x = m.transformVector(new Vec3(1, 0, 0)).normalized();
        Vec3 y = m.transformVector(Vec3.Y).normalized();
        Vec3 z = m.transformVector(new Vec3(0, 0, 1)).normalized();
        double tilt = Math.toDegrees(Math.asin(Math.clamp(-z.y(), -1, 1)));
        if (Math.hypot(z.x(), z.z()) < MIN_LENGTH) {
            // The image's z axis is vertical: roll and rotation turn about the same axis.
            return of(Math.toDegrees(Math.atan2(-x.z(), x.x())), tilt, 0);
        }
        return of(Math.toDegrees(Math.atan2(z.x(), z.z())), tilt, Math.toDegrees(Math.atan2(x.y(), y.y())));
    }

    /** Returns whether it is only about y. */
    public boolean isUpright() {
        return tilt == 0 && roll == 0;
    }

    public DomeRotation withRotation(double v) {
        return of(v, tilt, roll);
    }

    public DomeRotation withTilt(double v) {
        return of(rotation, v, roll);
    }

    public DomeRotation withRoll(double v) {
        return of(rotation, tilt, v);
    }
}
