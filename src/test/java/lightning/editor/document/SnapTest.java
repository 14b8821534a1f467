package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import lightning.scene.Light;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class SnapTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final PreviewCamera view = PreviewCamera.of(Desk.scene());

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
        assertThat(Snap.direction(new Vec3(0.1, -2, 0.05)))
                .satisfies(v -> PreviewCameraTest.assertClose(v.normalized(), new Vec3(0, -1, 0), 0));
    }

    @Test
    void almostAlongX_isAlongX() {
        PreviewCameraTest.assertClose(Snap.direction(new Vec3(1, 0.05, -0.1)).normalized(), new Vec3(1, 0, 0), 0);
    }

    @Test
    void halfWayUp_isFortyFiveDegrees() {
        Vec3 v = Snap.direction(new Vec3(0.02, 1.05, 1));
        assertThat(v.y()).isCloseTo(v.z(), within(1e-15));
        assertThat(v.x()).isEqualTo(0);
    }

    @Test
    void turnedLight_tellsItsAngles() {
        Light spot = Desk.spot(Vec3.ZERO, new Vec3(0, -1, 0));
        assertThat(Snap.of(spot, spot.withDirection(new Vec3(1, -1.02, 1)), view, CANVAS).told()).isEqualTo("azimuth 45°, elevation -30°");
    }

    @Test
    void movedLight_standsOnTheGridAndTellsIt() {
        Light spot = Desk.spot(new Vec3(0, 1, 0), new Vec3(0, -1, 0));
        Snap snap = Snap.of(spot, spot.withPosition(new Vec3(0.61, 1.17, -0.49)), view, CANVAS);
        // 9.06 from the eye, opening 40°: 8 pixels of 400 are 0.13, so the grid is 0.2.
        assertThat(snap.light().position()).isEqualTo(new Vec3(0.6, 1.2, -0.4));
        assertThat(snap.told()).isEqualTo("at 0.6 1.2 -0.4, grid 0.2");
    }

    @Test
    void orbitedLight_standsAtRoundAnglesAndAimsThereStill() {
        Light spot = Desk.spot(new Vec3(0, 1, 4), new Vec3(0, 0, -1));
        Light moved = LightManipulation.orbit(spot, view, CANVAS, 40, 7);
        Snap snap = Snap.of(spot, moved, view, CANVAS);
        PreviewCameraTest.assertClose(snap.light().position().plus(snap.light().direction().normalized().times(4)), new Vec3(0, 1, 0),
                1e-9);
        assertThat(snap.told()).contains("azimuth 15°").contains("elevation 0°");
    }

    @Property
    void direction_keepsItsLengthIsNearAndStays(@ForAll("directions") Vec3 direction) {
        Vec3 snapped = Snap.direction(direction);
        double length = direction.length();
        assertThat(snapped.length()).isCloseTo(length, within(1e-9 * length));
        // At most half a step in each angle.
        double cosine = snapped.dot(direction) / length / length;
        assertThat(cosine).isGreaterThan(Math.cos(Math.toRadians(Snap.TURN)));
        PreviewCameraTest.assertClose(Snap.direction(snapped).times(1 / length), snapped.times(1 / length), 1e-9);
    }

    @Property
    void grid_isNearestAndStays(@ForAll("points") Vec3 point, @ForAll @DoubleRange(min = 0.01, max = 1e4) double least) {
        double step = Snap.step(least);
        assertThat(step).isBetween(least, 2.5 * least * (1 + 1e-12));
        Vec3 on = Snap.grid(point, step);
        assertThat(on.minus(point).maxAbs()).isLessThanOrEqualTo(step / 2 * (1 + 1e-9) + 1e-15 * point.maxAbs());
        assertThat(Snap.grid(on, step)).isEqualTo(on);
    }

    @Property
    void distance_hasTwoDigits(@ForAll @DoubleRange(min = 0.01, max = 1e6) double v) {
        double snapped = Snap.distance(v);
        assertThat(snapped).isCloseTo(v, within(v * 0.05 * (1 + 1e-9)));
        assertThat(Double.toString(snapped).replaceAll("[.]0(E|$)", "$1").replaceAll("E.*", "").replaceAll("^[0.]*|[.]", "")
                .replaceAll("0+$", "").length()).isLessThanOrEqualTo(2);
    }
}
