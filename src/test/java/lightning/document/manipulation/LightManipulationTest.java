package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class LightManipulationTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final PreviewCamera view = PreviewCamera.of(DeskScene.scene());

    @Provide
    Arbitrary<PreviewCamera> cameras() {
        return ViewArbitraries.cameras();
    }

    @Provide
    Arbitrary<Vec3> points() {
        return ViewArbitraries.points();
    }

    @Provide
    Arbitrary<Vec3> directions() {
        return ViewArbitraries.directions();
    }

    @Provide
    Arbitrary<Double> distances() {
        return ViewArbitraries.distances();
    }

    @Test
    void rotateRight_turnsTheBeamToTheRight() {
        for (Vec3 direction : new Vec3[] {view.forward(), view.forward().negated()}) {
            Light turned = LightManipulation.rotate(DeskScene.spot(Vec3.ZERO, direction), view, CANVAS, 20, 0);
            assertThat(turned.direction().dot(view.right())).isGreaterThan(0.1);
            assertThat(turned.direction().dot(view.up())).isCloseTo(0, within(1e-12));
        }
    }

    @Test
    void rotateUp_turnsTheBeamUp() {
        for (Vec3 direction : new Vec3[] {view.forward(), view.forward().negated()}) {
            Light turned = LightManipulation.rotate(DeskScene.spot(Vec3.ZERO, direction), view, CANVAS, 0, 20);
            assertThat(turned.direction().dot(view.up())).isGreaterThan(0.1);
            assertThat(turned.direction().dot(view.right())).isCloseTo(0, within(1e-12));
        }
    }

    @Test
    void orbit_followsMouseInFrontOfTarget() {
        Vec3 at = view.camera().to().minus(view.forward().times(2));
        Light carried = LightManipulation.orbit(DeskScene.spot(at, view.forward()), view, CANVAS, 20, 10);
        assertThat(carried.position().minus(at).dot(view.right())).isGreaterThan(0.1);
        assertThat(carried.position().minus(at).dot(view.up())).isGreaterThan(0.05);
    }

    @Property
    void orbit_keepsTheDistanceAndTheAim(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 point,
            @ForAll("directions") Vec3 direction, @ForAll("distances") double right, @ForAll("distances") double up) {
        Light light = DeskScene.spot(point, direction);
        Vec3 target = LightManipulation.aimPoint(light, camera);
        double distance = target.minus(point).length();
        Light carried = LightManipulation.orbit(light, camera, CANVAS, right, up);
        Vec3 way = target.minus(carried.position());
        double slack = 1e-9 * (1 + target.length() + point.length());
        assertThat(way.length()).isCloseTo(distance, within(slack));
        assertThat(way.minus(carried.direction().normalized().times(distance)).length()).isLessThan(slack);
    }

    @Test
    void rotateOverShorterSide_isHalfTurn() {
        Light turned = LightManipulation.rotate(DeskScene.spot(Vec3.ZERO, view.forward()), view, CANVAS, 400, 0);
        PreviewCameraTest.assertClose(turned.direction(), view.forward().negated(), 1e-12);
    }

    @Test
    void pointLight_doesNotRotate() {
        Light point = DeskScene.spot(Vec3.ZERO, view.forward()).withType(LightType.POINT);
        assertThat(LightManipulation.rotate(point, view, CANVAS, 20, 30)).isSameAs(point);
    }

    @Test
    void dolly_movesAwayUpAndNearerDown() {
        Light light = DeskScene.spot(new Vec3(1, 2, 3), view.forward());
        assertThat(view.depth(LightManipulation.dolly(light, view, CANVAS, 10).position()))
                .isGreaterThan(view.depth(light.position()));
        assertThat(view.depth(LightManipulation.dolly(light, view, CANVAS, -10).position()))
                .isLessThan(view.depth(light.position()));
    }

    @Test
    void lightAtTheEye_stillMoves() {
        Light light = DeskScene.spot(view.camera().from(), view.forward());
        assertThat(view.depth(LightManipulation.dolly(light, view, CANVAS, 10).position())).isPositive();
    }

    @Test
    void moveBeyondLimits_keepsLight() {
        Light far = DeskScene.spot(new Vec3(0, 0, -SceneLimits.MAX_COORDINATE), view.forward());
        assertThat(LightManipulation.dolly(far, view, CANVAS, 100)).isSameAs(far);
    }

    @Property
    void translate_keepsTheLightUnderTheMouse(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 position,
            @ForAll("distances") double right, @ForAll("distances") double up) {
        if (camera.depth(position) > 0.1 * camera.distance()) {
            Light light = DeskScene.spot(position, new Vec3(0, -1, 0));
            Viewport.Pixel from = CANVAS.project(camera, position);
            Viewport.Pixel to = CANVAS.project(camera, LightManipulation.translate(light, camera, CANVAS, right, up).position());
            assertThat(to.x() - from.x()).isCloseTo(right, within(1e-6));
            assertThat(from.y() - to.y()).isCloseTo(up, within(1e-6));
        }
    }

    @Property
    void translate_staysInTheViewingPlaneAndDollyLeavesIt(@ForAll("cameras") PreviewCamera camera,
            @ForAll("points") Vec3 position, @ForAll("distances") double right, @ForAll("distances") double up) {
        Light light = DeskScene.spot(position, new Vec3(0, -1, 0));
        Vec3 across = LightManipulation.translate(light, camera, CANVAS, right, up).position().minus(position);
        Vec3 along = LightManipulation.dolly(light, camera, CANVAS, up).position().minus(position);
        assertThat(across.dot(camera.forward())).isCloseTo(0, within(1e-9));
        assertThat(along.cross(camera.forward()).length()).isCloseTo(0, within(1e-9));
    }

    @Property
    void rotate_keepsLengthPlaceAndAllElse(@ForAll("cameras") PreviewCamera camera, @ForAll("directions") Vec3 direction,
            @ForAll("distances") double right, @ForAll("distances") double up) {
        Light light = DeskScene.spot(new Vec3(1, 2, 3), direction);
        Light turned = LightManipulation.rotate(light, camera, CANVAS, right, up);
        assertThat(turned.direction().length()).isCloseTo(direction.length(), within(1e-9));
        assertThat(turned.withDirection(direction)).isEqualTo(light);
    }
}
