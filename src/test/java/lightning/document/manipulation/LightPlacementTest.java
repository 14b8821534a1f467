package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.document.LightEdits;
import lightning.render.shading.explanation.LightReport;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Placement of lights, verified with the renderer's pixel explanation. */
class LightPlacementTest {
    private static final int X = 20;
    private static final int BALL_Y = 15;
    private static final int FLOOR_Y = 27;

    private final Scene scene = DeskScene.scene();
    private final ScenePicker picker = new ScenePicker(scene);

    private static LightReport report(Scene scene, String light, int y) {
        return new PixelExplainer(scene).explainPixel(X, y).lights().stream().filter(r -> r.light().name().equals(light))
                .findFirst().orElseThrow();
    }

    @Test
    void pick_matchesRenderer() {
        assertThat(picker.pickPixel(X, BALL_Y)).map(ScenePicker.SurfaceHit::shape).contains("ball");
        assertThat(picker.pickPixel(X, FLOOR_Y)).map(ScenePicker.SurfaceHit::shape).contains("ground");
        assertThat(picker.pickPixel(X, 0)).isEmpty();
    }

    @Test
    void otherView_picksVisibleShape() {
        var canvas = new Viewport(100, 100);
        ScenePicker.SurfaceHit found = picker.pick(PreviewCamera.alongMinusY(scene), canvas, new Viewport.Pixel(50, 50)).orElseThrow();
        assertThat(found.shape()).isEqualTo("ball");
        PreviewCameraTest.assertClose(found.point(), new Vec3(0, 2, 0), 1e-3);
        PreviewCameraTest.assertClose(found.normal(), Vec3.Y, 1e-3);
    }

    @Test
    void picker_isReusedForSameShapes() {
        assertThat(picker.isValidFor(scene.withLights(List.of()))).isTrue();
        assertThat(picker.isValidFor(scene.withCamera(PreviewCamera.alongX(scene).camera()))).isFalse();
    }

    private Scene place(String name, LightPlacement.Goal act, ScenePicker.SurfaceHit at) {
        LightPlacement placing = LightPlacement.start(DeskScene.light(scene, name), act, at.point());
        return DeskScene.sceneOf(LightEdits.edit(scene, name, _ -> placing.place(at)));
    }

    private ScenePicker.SurfaceHit pick(int y) {
        return picker.pickPixel(X, y).orElseThrow();
    }

    @Test
    void aimedTube_turnsItsSide() {
        Light tube = DeskScene.light(scene, "key").withType(LightType.TUBE).withDirection(new Vec3(1, 1, 0));
        Vec3 point = tube.position().plus(new Vec3(0, -2, 0));
        Light aimed = LightPlacement.start(tube, new LightPlacement.Goal.Pool(), point).aimAt(point);
        PreviewCameraTest.assertClose(aimed.direction(), new Vec3(1, 0, 0), 1e-12);
        Light onEnd = tube.withDirection(Vec3.Y);
        assertThat(LightPlacement.start(onEnd, new LightPlacement.Goal.Pool(), point).aimAt(point).direction().y()).isCloseTo(0,
                within(1e-12));
    }

    @Test
    void flag_blocksTheLightAtPoint() {
        for (String name : DeskScene.names(scene)) {
            Scene lit = place(name, new LightPlacement.Goal.Diffuse(), pick(BALL_Y));
            assertThat(report(lit, name, BALL_Y).diffuse()[0]).as(name).isPositive();
            Light light = DeskScene.light(lit, name);
            Light flagged = LightPlacement.start(light, new LightPlacement.Goal.Flag(), pick(BALL_Y).point()).place(pick(BALL_Y));
            assertThat(report(lit.withLight(flagged), name, BALL_Y).diffuse()[0]).as(name).isZero();
            assertThat(flagged.withFlag(LightFlag.NONE)).isEqualTo(light);
        }
    }

    @Test
    void highlight_isBrightestAtPoint() {
        for (String name : DeskScene.names(scene)) {
            LightReport report = report(place(name, new LightPlacement.Goal.Highlight(), pick(BALL_Y)), name, BALL_Y);
            assertThat(report.state()).isEqualTo(LightReport.State.LIT);
            assertThat(report.specular()).isCloseTo(1, within(1e-3f));
        }
    }

    @Test
    void diffuse_facesLightAtPoint() {
        for (String name : DeskScene.names(scene)) {
            LightReport report = report(place(name, new LightPlacement.Goal.Diffuse(), pick(BALL_Y)), name, BALL_Y);
            assertThat(report.state()).isEqualTo(LightReport.State.LIT);
            assertThat(report.cosine()).isCloseTo(1, within(1e-5f));
        }
    }

    /** Checks a ball of radius 1 at (0 1 0), seen from far away along −z: above the chosen point it is lit, below not. */
    @Test
    void rim_startsAtPoint() {
        Vec3 normal = new Vec3(0, Math.sqrt(0.75), 0.5);
        Vec3 point = Vec3.Y.plus(normal);
        var at = new ScenePicker.SurfaceHit("ball", point, normal, point.plus(new Vec3(0, 0, 1000)));
        Light rim = LightPlacement.start(DeskScene.light(scene, "fill"), new LightPlacement.Goal.Rim(), point).place(at);
        PreviewCameraTest.assertClose(rim.position().minus(point).normalized(), new Vec3(0, 0.5, -Math.sqrt(0.75)), 1e-12);
    }

    @Test
    void rimOnSurfaceFacingEye_isRefused() {
        var at = new ScenePicker.SurfaceHit("ball", new Vec3(0, 1, 1), new Vec3(0, 0, 1), new Vec3(0, 1, 9));
        assertThatThrownBy(() -> LightPlacement.start(DeskScene.light(scene, "fill"), new LightPlacement.Goal.Rim(), at.point()).place(at))
                .hasMessage("the surface faces the camera here; a rim light needs a silhouette");
    }

    @Test
    void shadow_fallsAtPoint() {
        for (String name : DeskScene.names(scene)) {
            Scene placed = place(name, new LightPlacement.Goal.Shadow(new Vec3(0, 1, 0)), pick(FLOOR_Y));
            assertThat(report(placed, name, FLOOR_Y).state()).isEqualTo(LightReport.State.SHADOWED);
        }
    }

    @Test
    void shadowOnItsOccluder_isRefused() {
        var at = new ScenePicker.SurfaceHit("ball", Vec3.ZERO, Vec3.Y, new Vec3(0, 0, 9));
        assertThatThrownBy(
                () -> LightPlacement.start(DeskScene.light(scene, "key"), new LightPlacement.Goal.Shadow(Vec3.ZERO), Vec3.ZERO).place(at))
                .hasMessage("the shadow falls on its own caster");
    }

    @Test
    void poolOfPointLight_isRefused() {
        var at = pick(BALL_Y);
        assertThatThrownBy(() -> LightPlacement.start(DeskScene.light(scene, "fill"), new LightPlacement.Goal.Pool(), at.point()).place(at))
                .hasMessageContaining("a point light has no direction");
    }

    @Test
    void occluder_isFoundFromShadow() {
        ScenePicker.SurfaceHit floor = pick(FLOOR_Y);
        Light light = LightPlacement.start(DeskScene.light(scene, "fill"), new LightPlacement.Goal.Shadow(new Vec3(0, 1, 0)), floor.point())
                .place(floor);
        ScenePicker.SurfaceHit thrower = picker.findOccluder(floor, light).orElseThrow();
        assertThat(thrower.shape()).isEqualTo("ball");
        assertThat(thrower.point().minus(new Vec3(0, 1, 0)).length()).isCloseTo(1, within(1e-6));
        assertThat(picker.findOccluder(pick(BALL_Y), DeskScene.light(scene, "sun").withDirection(new Vec3(0, 0, -1)))).isEmpty();
    }

    @Provide
    Arbitrary<Vec3> points() {
        return ViewArbitraries.points();
    }

    @Provide
    Arbitrary<Vec3> directions() {
        return ViewArbitraries.directions();
    }

    /** Checks any surface normal on the eye's side, each light type, and any distance. */
    @Property
    void placedLight_doesWhatWasAskedAtTheDistanceOfThePress(@ForAll("points") Vec3 point, @ForAll("directions") Vec3 towardsEye,
            @ForAll("directions") Vec3 leaning, @ForAll LightType type, @ForAll @DoubleRange(min = 0.01, max = 1e3) double distance) {
        Vec3 sight = towardsEye.normalized();
        Vec3 normal = leaning.normalized().dot(sight) < 0 ? leaning.normalized().negated() : leaning.normalized();
        Assume.that(normal.dot(sight) > 1e-3 && normal.dot(sight) < 0.999);
        var at = new ScenePicker.SurfaceHit("any", point, normal, point.plus(sight.times(10)));
        Light begin = Light.of("l", type).withPosition(point.plus(new Vec3(distance, 0, 0)));
        LightPlacement.Goal[] acts =
                {new LightPlacement.Goal.Highlight(), new LightPlacement.Goal.Diffuse(), new LightPlacement.Goal.Rim()};
        double[] cosines = {normal.dot(sight), 1, 0};
        for (int i = 0; i < acts.length; i++) {
            var placing = LightPlacement.start(begin, acts[i], point);
            Light placed = placing.place(at);
            double rounding = 1e-9 * (1 + point.maxAbs() / distance);
            Vec3 towardsLight =
                    type.hasPosition() ? placed.position().minus(point).normalized() : placed.direction().normalized().negated();
            assertThat(towardsLight.dot(normal)).as(acts[i].toString()).isCloseTo(cosines[i], within(1e-7 + rounding));
            if (type.hasPosition()) {
                assertThat(placed.position().minus(point).length()).isCloseTo(distance, within(distance * (1e-7 + rounding)));
                Light farther = placing.moveToDistance(placed, point, 3 * distance);
                Vec3 way = farther.position().minus(point);
                assertThat(way.normalized().dot(towardsLight)).isCloseTo(1, within(1e-7 + rounding));
                assertThat(way.length()).isCloseTo(3 * distance, within(distance * (1e-6 + rounding)));
            }
            if (type.hasDirection()) {
                // The side of a tube shines there.
                double cosine = type == LightType.TUBE ? 0 : -1;
                assertThat(placed.direction().normalized().dot(towardsLight)).isCloseTo(cosine, within(1e-7 + rounding));
            }
        }
    }

    @Test
    void shadowDistance_keepsLightBehindOccluder() {
        var placing = LightPlacement.start(DeskScene.light(scene, "fill"), new LightPlacement.Goal.Shadow(new Vec3(0, 2, 0)), Vec3.ZERO);
        Light placed = placing.place(new ScenePicker.SurfaceHit("ground", Vec3.ZERO, Vec3.Y, new Vec3(0, 2, 9)));
        PreviewCameraTest.assertClose(placing.moveToDistance(placed, Vec3.ZERO, 5).position(), new Vec3(0, 5, 0), 1e-12);
        assertThat(placing.moveToDistance(placed, Vec3.ZERO, 0.1).position().y()).isBetween(2.0, 2.1);
    }

    @Test
    void directionalLight_keepsPositionAtEveryDistance() {
        var placing = LightPlacement.start(DeskScene.light(scene, "sun"), new LightPlacement.Goal.Diffuse(), Vec3.ZERO);
        assertThat(placing.moveToDistance(DeskScene.light(scene, "sun"), Vec3.ZERO, 9)).isEqualTo(DeskScene.light(scene, "sun"));
    }
}
