package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.value.LensShift;
import org.junit.jupiter.api.Test;

/** Camera rays. */
class CameraRaysTest {
    private static final Vec3 FROM = new Vec3(1, 2, 9);
    private static final Vec3 TO = new Vec3(0, 1, 0.5);
    private static final Vec3 UP = new Vec3(0.1, 1, 0);
    private static final double FOV = 35;

    /** A shifted picture is cut out of a larger one around the same view direction. */
    @Test
    void shiftedRays_areThoseOfALargerPicture() {
        double tripled = 2 * Math.toDegrees(Math.atan(3 * Math.tan(Math.toRadians(FOV / 2))));
        var large = new CameraRays(new Camera(FROM, TO, UP, tripled), new PictureSettings(90, 72, 1));
        var shifted = new CameraRays(new Camera(FROM, TO, UP, FOV, new LensShift(0.5, -1)), new PictureSettings(30, 24, 1));
        for (int x = 0; x < 30; x += 7) {
            for (int y = 0; y < 24; y += 5) {
                // To the right by half of 30 pixels, and down by 24.
                Vec3 expected = large.pixelRay(30 + 15 + x, 24 + 24 + y).direction();
                assertThat(shifted.pixelRay(x, y).direction().minus(expected).maxAbs()).isLessThan(1e-14);
            }
        }
    }

    @Test
    void zeroShift_keepsEveryBit() {
        var picture = new PictureSettings(31, 23, 1);
        var plain = new CameraRays(new Camera(FROM, TO, UP, FOV), picture);
        Vec3 forward = TO.minus(FROM).normalized();
        assertThat(plain.corner).isEqualTo(forward.minus(plain.right.times(31 / 2.0)).minus(plain.down.times(23 / 2.0)));
    }
}
