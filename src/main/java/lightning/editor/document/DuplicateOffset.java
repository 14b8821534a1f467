package lightning.editor.document;

import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/** How far beside its original a copy stands. The copy of a copy goes on by the same way. */
public final class DuplicateOffset {
    /** A share of the way from the camera to what it looks at. */
    private static final double DISTANCE_SHARE = 0.1;

    private DuplicateOffset() {}

    /** Along x, a length of one digit. */
    public static double length(Scene scene) {
        double length = DISTANCE_SHARE * PreviewCamera.of(scene).distance();
        double digit = Math.pow(10, Math.floor(Math.log10(length)));
        return Math.max(digit * Math.rint(length / digit), SceneLimits.MIN_SCALE);
    }

    static Vec3 duplicatePosition(Scene scene, Vec3 original) {
        return original.plus(new Vec3(length(scene), 0, 0));
    }
}
