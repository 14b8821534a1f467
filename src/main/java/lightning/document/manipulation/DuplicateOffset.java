package lightning.document.manipulation;

import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.value.SceneLimits;

/** Offset of a copy from its original. A copy of a copy moves on by the same offset. */
public final class DuplicateOffset {
    /** Offset as a share of the distance from the camera to its target. */
    private static final double DISTANCE_SHARE = 0.1;

    private DuplicateOffset() {}

    /** Returns the offset along x, rounded to one digit. */
    public static double length(Scene scene) {
        double length = DISTANCE_SHARE * PreviewCamera.of(scene).distance();
        double digit = Math.pow(10, Math.floor(Math.log10(length)));
        return Math.max(digit * Math.rint(length / digit), SceneLimits.MIN_SCALE);
    }

    public static Vec3 duplicatePosition(Scene scene, Vec3 original) {
        return original.plus(new Vec3(length(scene), 0, 0));
    }
}
