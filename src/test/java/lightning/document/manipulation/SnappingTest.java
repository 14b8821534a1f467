package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.scene.light.Light;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class SnappingTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final PreviewCamera view = PreviewCamera.of(DeskScene.scene());

    @Provide
    Arbitrary<Vec3> directions() {
        return ViewArbitraries.directions();
    }

    @Provide
    Arbitrary<Vec3> points() {
        return ViewArbitraries.points();
    }

    @Test
    void almostDown_isDown() {
        assertThat(Snapping.snapDirection(new Vec3(0.1, -2, 0.05)))
                .satisfies(v -> PreviewCameraTest.assertClose(v.normalized(), new Vec3(0, -1, 0), 0));
    }

    @Test
    void almostAlongX_isAlongX() {
        PreviewCameraTest.assertClose(Snapping.snapDirection(new Vec3(1, 0.05, -0.1)).normalized(), new Vec3(1, 0, 0), 0);
    }

    @Test
    void halfWayUp_isFortyFiveDegrees() {
        Vec3 v = Snapping.snapDirection(new Vec3(0.02, 1.05, 1));
        assertThat(v.y()).isCloseTo(v.z(), within(1e-15));
        assertThat(v.x()).isEqualTo(0);
    }

    @Test
    void rotatedLight_reportsItsAngles() {
        Light spot = DeskScene.spot(Vec3.ZERO, new Vec3(0, -1, 0));
        assertThat(Snapping.of(spot, spot.withDirection(new Vec3(1, -1.02, 1)), view, CANVAS).message())
                .isEqualTo("azimuth 45°, elevation -30°");
    }

    @Test
    void movedLight_isOnGridAndReportsPosition() {
        Light spot = DeskScene.spot(new Vec3(0, 1, 0), new Vec3(0, -1, 0));
        Snapping snap = Snapping.of(spot, spot.withPosition(new Vec3(0.61, 1.17, -0.49)), view, CANVAS);
        // At distance 9.06 with an opening of 40°, 8 of 400 pixels are 0.13, so the grid is 0.2.
        assertThat(snap.light().position()).isEqualTo(new Vec3(0.6, 1.2, -0.4));
        assertThat(snap.message()).isEqualTo("at 0.6 1.2 -0.4, grid 0.2");
    }

    @Test
    void orbitedLight_hasRoundAnglesAndKeepsTarget() {
        Light spot = DeskScene.spot(new Vec3(0, 1, 4), new Vec3(0, 0, -1));
        Light moved = LightManipulation.orbit(spot, view, CANVAS, 40, 7);
        Snapping snap = Snapping.of(spot, moved, view, CANVAS);
        PreviewCameraTest.assertClose(snap.light().position().plus(snap.light().direction().normalized().times(4)), new Vec3(0, 1, 0),
                1e-9);
        assertThat(snap.message()).contains("azimuth 15°").contains("elevation 0°");
    }

    @Property
    void snapDirection_keepsLengthIsNearAndIdempotent(@ForAll("directions") Vec3 direction) {
        Vec3 snapped = Snapping.snapDirection(direction);
        double length = direction.length();
        assertThat(snapped.length()).isCloseTo(length, within(1e-9 * length));
        // At most half a step in each angle.
        double cosine = snapped.dot(direction) / length / length;
        assertThat(cosine).isGreaterThan(Math.cos(Math.toRadians(Snapping.ANGLE_STEP)));
        PreviewCameraTest.assertClose(Snapping.snapDirection(snapped).times(1 / length), snapped.times(1 / length), 1e-9);
    }

    @Property
    void snapToGrid_isNearestAndIdempotent(@ForAll("points") Vec3 point, @ForAll @DoubleRange(min = 0.01, max = 1e4) double minStep) {
        double step = Snapping.roundStep(minStep);
        assertThat(step).isBetween(minStep, 2.5 * minStep * (1 + 1e-12));
        Vec3 on = Snapping.snapToGrid(point, step);
        assertThat(on.minus(point).maxAbs()).isLessThanOrEqualTo(step / 2 * (1 + 1e-9) + 1e-15 * point.maxAbs());
        assertThat(Snapping.snapToGrid(on, step)).isEqualTo(on);
    }

    @Property
    void distance_hasTwoDigits(@ForAll @DoubleRange(min = 0.01, max = 1e6) double v) {
        double snapped = Snapping.snapDistance(v);
        assertThat(snapped).isCloseTo(v, within(v * 0.05 * (1 + 1e-9)));
        assertThat(Double.toString(snapped).replaceAll("[.]0(E|$)", "$1").replaceAll("E.*", "").replaceAll("^[0.]*|[.]", "")
                .replaceAll("0+$", "").length()).isLessThanOrEqualTo(2);
    }
}
