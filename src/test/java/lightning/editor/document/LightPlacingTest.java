package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.render.shading.LightReport;
import lightning.render.shading.PixelExplainer;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** The renderer's own explanation of a pixel is the judge. */
class LightPlacingTest {
    private static final int X = 20;
    private static final int BALL_Y = 15;
    private static final int FLOOR_Y = 27;

    private final Scene scene = Desk.scene();
    private final ScenePicker picker = new ScenePicker(scene);

    private static LightReport report(Scene scene, String light, int y) {
        return new PixelExplainer(scene).pixel(X, y).lights().stream().filter(r -> r.light().name().equals(light))
                .findFirst().orElseThrow();
    }

    @Test
    void pixel_showsTheShapeThatTheRendererFinds() {
        assertThat(picker.atPixel(X, BALL_Y)).map(ScenePicker.Found::shape).contains("ball");
        assertThat(picker.atPixel(X, FLOOR_Y)).map(ScenePicker.Found::shape).contains("ground");
        assertThat(picker.atPixel(X, 0)).isEmpty();
    }

    @Test
    void anotherView_findsWhatLiesThere() {
        var canvas = new Viewport(100, 100);
        ScenePicker.Found found = picker.at(PreviewCamera.alongMinusY(scene), canvas, new Viewport.Pixel(50, 50)).orElseThrow();
        assertThat(found.shape()).isEqualTo("ball");
        PreviewCameraTest.assertClose(found.point(), new Vec3(0, 2, 0), 1e-3);
        PreviewCameraTest.assertClose(found.normal(), Vec3.Y, 1e-3);
    }

    @Test
    void picker_servesScenesOfTheSameShapes() {
        assertThat(picker.serves(scene.withLights(List.of()))).isTrue();
        assertThat(picker.serves(scene.withCamera(PreviewCamera.alongX(scene).camera()))).isFalse();
    }

    private Scene placed(String name, LightPlacing.Act act, ScenePicker.Found at) {
        LightPlacing placing = LightPlacing.from(Desk.light(scene, name), act, at.point());
        return Desk.done(LightEdits.with(scene, name, _ -> placing.at(at)));
    }

    private ScenePicker.Found found(int y) {
        return picker.atPixel(X, y).orElseThrow();
    }

    @Test
    void highlight_isBrightestWhereItWasPlaced() {
        for (String name : Desk.names(scene)) {
            LightReport report = report(placed(name, new LightPlacing.Act.Highlight(), found(BALL_Y)), name, BALL_Y);
            assertThat(report.state()).isEqualTo(LightReport.State.LIT);
            assertThat(report.specular()).isCloseTo(1, within(1e-3f));
        }
    }

    @Test
    void diffuse_facesTheLightWhereItWasPlaced() {
        for (String name : Desk.names(scene)) {
            LightReport report = report(placed(name, new LightPlacing.Act.Diffuse(), found(BALL_Y)), name, BALL_Y);
            assertThat(report.state()).isEqualTo(LightReport.State.LIT);
            assertThat(report.cosine()).isCloseTo(1, within(1e-5f));
        }
    }

    /** A ball of radius 1 about (0 1 0), seen from far away along −z: its rim begins where it was asked for, above it is lit, below not. */
    @Test
    void rim_beginsWhereItWasPlacedAndIsBehind() {
        Vec3 normal = new Vec3(0, Math.sqrt(0.75), 0.5);
        Vec3 point = Vec3.Y.plus(normal);
        var at = new ScenePicker.Found("ball", point, normal, point.plus(new Vec3(0, 0, 1000)));
        Light rim = LightPlacing.from(Desk.light(scene, "fill"), new LightPlacing.Act.Rim(), point).at(at);
        PreviewCameraTest.assertClose(rim.position().minus(point).normalized(), new Vec3(0, 0.5, -Math.sqrt(0.75)), 1e-12);
    }

    @Test
    void rimWhereTheSurfaceFacesTheEye_isRefused() {
        var at = new ScenePicker.Found("ball", new Vec3(0, 1, 1), new Vec3(0, 0, 1), new Vec3(0, 1, 9));
        assertThatThrownBy(() -> LightPlacing.from(Desk.light(scene, "fill"), new LightPlacing.Act.Rim(), at.point()).at(at))
                .hasMessage("the surface faces the eye there; a rim is where it turns away");
    }

    @Test
    void shadow_fallsWhereItWasPlaced() {
        for (String name : Desk.names(scene)) {
            Scene placed = placed(name, new LightPlacing.Act.Shadow(new Vec3(0, 1, 0)), found(FLOOR_Y));
            assertThat(report(placed, name, FLOOR_Y).state()).isEqualTo(LightReport.State.SHADOWED);
        }
    }

    @Test
    void shadowOnItsOwnThrower_isRefused() {
        var at = new ScenePicker.Found("ball", Vec3.ZERO, Vec3.Y, new Vec3(0, 0, 9));
        assertThatThrownBy(() -> LightPlacing.from(Desk.light(scene, "key"), new LightPlacing.Act.Shadow(Vec3.ZERO), Vec3.ZERO).at(at))
                .hasMessage("the shadow falls on what throws it");
    }

    @Test
    void poolOfAPointLight_isRefused() {
        var at = found(BALL_Y);
        assertThatThrownBy(() -> LightPlacing.from(Desk.light(scene, "fill"), new LightPlacing.Act.Pool(), at.point()).at(at))
                .hasMessageContaining("a point light has no direction");
    }

    @Test
    void whatThrowsAShadow_isFoundFromTheShadow() {
        ScenePicker.Found floor = found(FLOOR_Y);
        Light light = LightPlacing.from(Desk.light(scene, "fill"), new LightPlacing.Act.Shadow(new Vec3(0, 1, 0)), floor.point()).at(floor);
        ScenePicker.Found thrower = picker.between(floor, light).orElseThrow();
        assertThat(thrower.shape()).isEqualTo("ball");
        assertThat(thrower.point().minus(new Vec3(0, 1, 0)).length()).isCloseTo(1, within(1e-6));
        assertThat(picker.between(found(BALL_Y), Desk.light(scene, "sun").withDirection(new Vec3(0, 0, -1)))).isEmpty();
    }

    @Provide
    Arbitrary<Vec3> points() {
        return ViewArbitraries.points();
    }

    @Provide
    Arbitrary<Vec3> directions() {
        return ViewArbitraries.directions();
    }

    /** A surface of any normal on the side of the eye, a light of each type, at any distance. */
    @Property
    void placedLight_doesWhatWasAskedAtTheDistanceOfThePress(@ForAll("points") Vec3 point, @ForAll("directions") Vec3 towardsEye,
            @ForAll("directions") Vec3 leaning, @ForAll LightType type, @ForAll @DoubleRange(min = 0.01, max = 1e3) double distance) {
        Vec3 sight = towardsEye.normalized();
        Vec3 normal = leaning.normalized().dot(sight) < 0 ? leaning.normalized().negated() : leaning.normalized();
        Assume.that(normal.dot(sight) > 1e-3 && normal.dot(sight) < 0.999);
        var at = new ScenePicker.Found("any", point, normal, point.plus(sight.times(10)));
        Light begin = Light.of("l", type).withPosition(point.plus(new Vec3(distance, 0, 0)));
        LightPlacing.Act[] acts = {new LightPlacing.Act.Highlight(), new LightPlacing.Act.Diffuse(), new LightPlacing.Act.Rim()};
        double[] cosines = {normal.dot(sight), 1, 0};
        for (int i = 0; i < acts.length; i++) {
            var placing = LightPlacing.from(begin, acts[i], point);
            Light placed = placing.at(at);
            double rounding = 1e-9 * (1 + point.maxAbs() / distance);
            Vec3 towardsLight =
                    type.hasPosition() ? placed.position().minus(point).normalized() : placed.direction().normalized().negated();
            assertThat(towardsLight.dot(normal)).as(acts[i].toString()).isCloseTo(cosines[i], within(1e-7 + rounding));
            if (type.hasPosition()) {
                assertThat(placed.position().minus(point).length()).isCloseTo(distance, within(distance * (1e-7 + rounding)));
                Light farther = placing.atDistance(placed, point, 3 * distance);
                Vec3 way = farther.position().minus(point);
                assertThat(way.normalized().dot(towardsLight)).isCloseTo(1, within(1e-7 + rounding));
                assertThat(way.length()).isCloseTo(3 * distance, within(distance * (1e-6 + rounding)));
            }
            if (type.hasDirection()) {
                assertThat(placed.direction().normalized().dot(towardsLight)).isCloseTo(-1, within(1e-7 + rounding));
            }
        }
    }

    @Test
    void distanceOfAShadow_neverPutsTheLightBeforeWhatThrowsIt() {
        var placing = LightPlacing.from(Desk.light(scene, "fill"), new LightPlacing.Act.Shadow(new Vec3(0, 2, 0)), Vec3.ZERO);
        Light placed = placing.at(new ScenePicker.Found("ground", Vec3.ZERO, Vec3.Y, new Vec3(0, 2, 9)));
        PreviewCameraTest.assertClose(placing.atDistance(placed, Vec3.ZERO, 5).position(), new Vec3(0, 5, 0), 1e-12);
        assertThat(placing.atDistance(placed, Vec3.ZERO, 0.1).position().y()).isBetween(2.0, 2.1);
    }

    @Test
    void directionalLight_keepsItsPlaceAtEveryDistance() {
        var placing = LightPlacing.from(Desk.light(scene, "sun"), new LightPlacing.Act.Diffuse(), Vec3.ZERO);
        assertThat(placing.atDistance(Desk.light(scene, "sun"), Vec3.ZERO, 9)).isEqualTo(Desk.light(scene, "sun"));
    }
}
