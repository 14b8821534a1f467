package lightning.scene.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import org.junit.jupiter.api.Test;

class PlacementTest {

    @Test
    void transform_scalesRotatesTranslates() {
        Placement placement = new Placement(new Vec3(10, 20, 30), new Vec3(0, 0, 90), new Vec3(2, 3, 5));
        assertThat(placement.transform().transformPoint(new Vec3(1, 1, 1))).isEqualTo(new Vec3(10 - 3, 20 + 2, 30 + 5));
    }

    /** Stretches one axis and shrinks another to the limits; neither may lose precision. */
    @Test
    void directionsToLocal_invertsDirections() {
        for (Vec3 scale : new Vec3[] {Vec3.ONE, new Vec3(2, -3, 5), new Vec3(SceneLimits.MAX_SCALE, SceneLimits.MIN_SCALE, 1)}) {
            Placement placement = new Placement(new Vec3(1, 2, 3), new Vec3(11, 23, 37), scale);
            Transform forth = Transform.rotation(placement.rotation());
            for (Vec3 v : new Vec3[] {new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1)}) {
                // A direction along a shape's axis, rotated but not scaled, maps back divided by the axis's factor.
                Vec3 back = placement.directionsToLocal().transformVector(forth.transformVector(v));
                Vec3 expected = new Vec3(v.x() / scale.x(), v.y() / scale.y(), v.z() / scale.z());
                assertThat(back.x() * scale.x()).isCloseTo(expected.x() * scale.x(), within(1e-15));
                assertThat(back.y() * scale.y()).isCloseTo(expected.y() * scale.y(), within(1e-15));
                assertThat(back.z() * scale.z()).isCloseTo(expected.z() * scale.z(), within(1e-15));
            }
        }
    }

    @Test
    void scaleAtLimits_isAccepted_beyondIsRejected() {
        new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(SceneLimits.MIN_SCALE, -SceneLimits.MIN_SCALE, SceneLimits.MAX_SCALE));
        assertThatThrownBy(() -> new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(1, Math.nextDown(SceneLimits.MIN_SCALE), 1)))
                .hasMessageContaining("scale must be at least 1e-9 in absolute value on every axis");
        assertThatThrownBy(() -> new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(1, 1, Math.nextUp(SceneLimits.MAX_SCALE))))
                .hasMessageContaining("scale");
    }

    @Test
    void minAndMaxScale_areAbsolute() {
        Placement placement = new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(-2, 3, -5));
        assertThat(placement.minScale()).isEqualTo(2);
        assertThat(placement.maxScale()).isEqualTo(5);
    }

    @Test
    void equality_comparesBits() {
        Vec3 at = new Vec3(0, 2, 3);
        Vec3 rotate = new Vec3(4, 5, 6);
        Vec3 scale = new Vec3(7, 8, 9);
        Placement placement = new Placement(at, rotate, scale);
        assertThat(placement).isEqualTo(new Placement(at, rotate, scale)).hasSameHashCodeAs(new Placement(at, rotate, scale))
                .isNotEqualTo(new Placement(new Vec3(-0.0, 2, 3), rotate, scale)).isNotEqualTo(new Placement(at, Vec3.ZERO, scale))
                .isNotEqualTo(new Placement(at, rotate, new Vec3(7, 8, -9)));
        assertThat(placement.position()).isEqualTo(at);
        assertThat(placement.rotation()).isEqualTo(rotate);
        assertThat(placement.scale()).isEqualTo(scale);
    }
}
