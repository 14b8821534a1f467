package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Scale;

/** Tests cutouts in numerically difficult cases. */
class CutoutPrecisionTest {
    /** Opacity that rises from 0 at the left to 1 at the right, except for half a pixel at both ends. */
    private static final Texture RAMP = grayImage(256, 1, 0);

    private static Texture grayImage(int width, int height, float plain) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = width == 1 ? plain : (i / 3 % width) / (width - 1f);
        }
        return new Texture(width, height, rgb);
    }

    private static Geometry geometry(Texture opacity, double cutoff, Vec3 eye, Shape... shapes) {
        Material leaf = Material.of("leaf").withCutout(new AlphaCutout(Optional.of(new TextureMap("a.png", 1, 1, opacity)), cutoff));
        return Geometry.of(new Scene(PictureSettings.DEFAULT, new Camera(eye, eye.plus(new Vec3(0, 0, -1)), Vec3.Y, 40), World.DEFAULT,
                List.of(leaf), List.of(shapes), List.of()));
    }

    private static Shape shape(Solid solid, String material, Vec3 at, Vec3 scale) {
        return new Shape(solid, "s" + at.y(), material, new Placement(at, Vec3.ZERO, scale));
    }

    /** Weights of four equal pixels are rounded; their sum must still be the pixel. */
    @Property(tries = 300)
    void surfaceAtCutoff_hasNoSpeckles(@ForAll @Scale(12) @DoubleRange(min = 0.001, max = 0.999) double value,
            @ForAll @Scale(12) @DoubleRange(min = -0.49, max = 0.49) double x,
            @ForAll @Scale(12) @DoubleRange(min = -0.49, max = 0.49) double z) {
        float there = (float) value;
        Vec3 eye = new Vec3(0.1, 3, 0.2);
        Ray ray = new Ray(Vec3.ZERO, new Vec3(x, 0, z).minus(eye));
        Shape card = shape(Solid.PLANE, "leaf", Vec3.ZERO, Vec3.ONE);
        Texture even = grayImage(1, 7, there);
        assertThat(geometry(even, there, eye, card).distance(0, ray)).isLessThan(SolidGeometry.MISS);
        assertThat(geometry(even, Math.nextUp(there), eye, card).distance(0, ray)).isEqualTo(SolidGeometry.MISS);
    }

    /** The crossing with the card decides, however flat the ray is. */
    @Property(tries = 300)
    void grazingRay_hitsOpaquePartAtItsCrossing(@ForAll @Scale(12) @DoubleRange(min = 0.05, max = 0.95) double u,
            @ForAll @IntRange(min = 0, max = 7) int flat, @ForAll @Scale(12) @DoubleRange(min = 1, max = 1000) double from) {
        double threshold = 0.5;
        Vec3 eye = new Vec3(u - 0.5 - from, from * Math.pow(10, -flat), 0);
        Geometry geometry = geometry(RAMP, threshold, eye, shape(Solid.PLANE, "leaf", Vec3.ZERO, Vec3.ONE));
        Ray ray = new Ray(Vec3.ZERO, new Vec3(u - 0.5, 0, 0).minus(eye).normalized());
        // The ramp rises by 1 from the center of the first pixel to that of the last.
        double there = (u - 0.5 / 256) * 256 / 255;
        if (Math.abs(there - threshold) > 1e-4) {
            assertThat(geometry.distance(0, ray) < SolidGeometry.MISS).isEqualTo(there > threshold);
        }
    }

    /** Rays do not restart after a hole, so they skip nothing, however near it is. */
    @Property(tries = 100)
    void surfaceCloseBehindHole_isHit(@ForAll @Scale(12) @DoubleRange(min = -15, max = 0) double power,
            @ForAll @Scale(12) @DoubleRange(min = -0.4, max = 0.4) double x) {
        double gap = Math.pow(10, power);
        Vec3 eye = new Vec3(0.3, 2, 0.1);
        Geometry geometry = geometry(grayImage(1, 1, 0), 0.5, eye, shape(Solid.PLANE, "leaf", Vec3.ZERO, Vec3.ONE),
                shape(Solid.PLANE, "default", new Vec3(0, -gap, 0), new Vec3(9, 1, 9)));
        assertThat(BruteForce.nearest(geometry, new Ray(Vec3.ZERO, new Vec3(x, 0, -x).minus(eye)))).isEqualTo(1);
    }

    /** A light on a ball shines through it only where the far side has a hole; holes at the light itself are irrelevant. */
    @Example
    void shadowRayToLightOnCutoutBall_testsFarSide() {
        Vec3 eye = new Vec3(0, -5, 0);
        Shape ball = shape(Solid.SPHERE, "leaf", Vec3.ZERO, Vec3.ONE);
        // v points up from the bottom row: the lower half of the image is that of the ball.
        Texture lower = new Texture(1, 2, new float[] {0, 0, 0, 1, 1, 1});
        Texture upper = new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0});
        Vec3 top = new Vec3(0, 1, 0).minus(eye);
        assertThat(blocked(geometry(lower, 0.5, eye, ball), top)).isTrue();
        assertThat(blocked(geometry(upper, 0.5, eye, ball), top)).isFalse();
        assertThat(blocked(geometry(grayImage(1, 1, 0), 0.5, eye, ball), top)).isFalse();
    }

    private static boolean blocked(Geometry geometry, Vec3 light) {
        Vec3 from = new Vec3(0.01, 0, 0.02);
        boolean all = BruteForce.isBlocked(geometry, from, BruteForce.shadowRayTarget(geometry, light));
        assertThat(geometry.blocker(from, geometry.shadowRayTarget(light)) >= 0).isEqualTo(all);
        return all;
    }
}
