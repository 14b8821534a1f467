package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.render.trace.PixelRays;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.value.LensShift;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

public class PreviewCameraTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final Scene scene = DeskScene.scene();
    private final PreviewCamera reset = PreviewCamera.of(scene);

    @Provide
    Arbitrary<PreviewCamera> cameras() {
        return ViewArbitraries.cameras();
    }

    @Provide
    Arbitrary<Viewport> canvases() {
        return ViewArbitraries.canvases();
    }

    @Provide
    Arbitrary<Double> distances() {
        return ViewArbitraries.distances();
    }

    @Provide
    Arbitrary<Vec3> points() {
        return ViewArbitraries.points();
    }

    @Test
    void reset_isSceneCamera() {
        Camera own = scene.camera();
        assertThat(reset.camera().from()).isEqualTo(own.from());
        assertThat(reset.camera().to()).isEqualTo(own.to());
        assertThat(reset.camera().fov()).isEqualTo(own.fov());
    }

    @Test
    void axisButtons_viewAlongAxesFromSameDistance() {
        PreviewCamera x = PreviewCamera.alongX(scene);
        PreviewCamera y = PreviewCamera.alongMinusY(scene);
        assertClose(x.forward(), new Vec3(1, 0, 0), 1e-12);
        assertClose(x.up(), Vec3.Y, 1e-12);
        assertClose(y.forward(), new Vec3(0, -1, 0), 1e-12);
        assertClose(y.right(), new Vec3(1, 0, 0), 1e-12);
        assertThat(x.distance()).isCloseTo(reset.distance(), within(1e-12));
        assertThat(y.camera().to()).isEqualTo(scene.camera().to());
    }

    @Test
    void zoomUp_movesNearerAndKeepsTarget() {
        PreviewCamera near = reset.zoom(100, CANVAS);
        assertThat(near.distance()).isLessThan(reset.distance());
        assertThat(near.camera().to()).isEqualTo(reset.camera().to());
        assertThat(reset.zoom(-100, CANVAS).distance()).isGreaterThan(reset.distance());
    }

    @Test
    void repeatedZoom_neverPassesTarget() {
        PreviewCamera view = reset;
        for (int i = 0; i < 100; i++) {
            view = view.zoom(400, CANVAS);
        }
        assertThat(view.distance()).isPositive();
        assertClose(view.forward(), reset.forward(), 1e-6);
    }

    @Test
    void trackball_nearSideFollowsMouse() {
        Vec3 near = reset.camera().to().minus(reset.forward());
        assertThat(CANVAS.project(reset.trackball(30, 0, CANVAS), near).x()).isGreaterThan(CANVAS.project(reset, near).x());
        assertThat(CANVAS.project(reset.trackball(0, 30, CANVAS), near).y()).isLessThan(CANVAS.project(reset, near).y());
    }

    @Test
    void drag_isDecidedByItsStart() {
        assertThat(CameraDrag.of(CANVAS, 300, 200, 1, 5)).isEqualTo(CameraDrag.ZOOM);
        assertThat(CameraDrag.of(CANVAS, 300, 200, -5, 1)).isEqualTo(CameraDrag.PAN);
        assertThat(CameraDrag.of(CANVAS, 10, 200, 1, 5)).isEqualTo(CameraDrag.TRACKBALL);
        assertThat(CameraDrag.of(CANVAS, 300, 395, 5, 1)).isEqualTo(CameraDrag.TRACKBALL);
    }

    @Test
    void drag_appliesItsKind() {
        assertThat(CameraDrag.ZOOM.apply(reset, CANVAS, 7, -20)).isEqualTo(reset.zoom(20, CANVAS));
        assertThat(CameraDrag.PAN.apply(reset, CANVAS, 7, -20)).isEqualTo(reset.pan(7, 20, CANVAS));
        assertThat(CameraDrag.TRACKBALL.apply(reset, CANVAS, 7, -20)).isEqualTo(reset.trackball(7, 20, CANVAS));
    }

    @Test
    void throughSpot_coneFillsPicture() {
        PreviewCamera view = PreviewCamera.throughLight(DeskScene.light(scene, "key"), scene);
        assertThat(view.camera().from()).isEqualTo(new Vec3(3, 5, 2));
        assertClose(view.forward(), new Vec3(-3, -4, -2).normalized(), 1e-12);
        assertThat(view.camera().fov()).isEqualTo(50);
    }

    @Test
    void throughPointLight_targetIsCentered() {
        PreviewCamera view = PreviewCamera.throughLight(DeskScene.light(scene, "fill"), scene);
        assertThat(view.camera().from()).isEqualTo(new Vec3(-3, 2, 4));
        assertThat(CANVAS.project(view, scene.camera().to()).x()).isCloseTo(300, within(1e-6));
    }

    @Test
    void throughDirectionalLight_positionDoesNotMatter() {
        var sun = DeskScene.light(scene, "sun");
        assertThat(PreviewCamera.throughLight(sun.withPosition(new Vec3(50, 60, 70)), scene))
                .isEqualTo(PreviewCamera.throughLight(sun, scene));
        assertClose(PreviewCamera.throughLight(sun, scene).forward(), new Vec3(-1, -1, -1).normalized(), 1e-12);
    }

    @Test
    void throughLightShiningDown_isValidView() {
        var down = DeskScene.spot(new Vec3(0, 5, 0), new Vec3(0, -1, 0));
        assertClose(PreviewCamera.throughLight(down, scene).forward(), new Vec3(0, -1, 0), 1e-12);
    }

    /** Compares with the renderer's rays: the hit of a pixel's ray must project to that pixel. */
    @Test
    void pointsOnPixelRay_projectToPixelCenter() {
        assertProjection(scene);
        assertProjection(scene.withCamera(Camera.SHIFT.with(scene.camera(), new LensShift(0.3, -0.2))));
    }

    private static void assertProjection(Scene scene) {
        var canvas = new Viewport(40, 30);
        PreviewCamera view = PreviewCamera.of(scene);
        for (int x = 0; x < 40; x += 13) {
            for (int y = 0; y < 30; y += 7) {
                Vec3 direction = new PixelRays(scene).ray(x, y).direction();
                Viewport.Pixel pixel = canvas.project(view, scene.camera().from().plus(direction.times(5)));
                assertThat(pixel.x()).isCloseTo(x + 0.5, within(1e-9));
                assertThat(pixel.y()).isCloseTo(y + 0.5, within(1e-9));
                assertClose(canvas.direction(view, x + 0.5, y + 0.5), direction, 1e-12);
            }
        }
    }

    @Property
    void axes_areOrthonormalAfterAnyDrag(@ForAll("cameras") PreviewCamera camera, @ForAll("canvases") Viewport canvas,
            @ForAll("distances") double right, @ForAll("distances") double up, @ForAll CameraDrag drag) {
        PreviewCamera view = drag.apply(camera, canvas, right, up);
        assertThat(view.forward().length()).isCloseTo(1, within(1e-12));
        assertThat(view.right().length()).isCloseTo(1, within(1e-12));
        assertThat(view.up().length()).isCloseTo(1, within(1e-12));
        assertThat(view.forward().dot(view.right())).isCloseTo(0, within(1e-12));
        assertThat(view.forward().dot(view.up())).isCloseTo(0, within(1e-9));
        assertThat(view.right().dot(view.up())).isCloseTo(0, within(1e-9));
    }

    @Property
    void trackball_keepsTheDistanceAndWhatIsLookedAt(@ForAll("cameras") PreviewCamera camera,
            @ForAll("distances") double right, @ForAll("distances") double up) {
        PreviewCamera view = camera.trackball(right, up, CANVAS);
        assertThat(view.distance()).isCloseTo(camera.distance(), within(1e-9));
        assertThat(view.camera().to()).isEqualTo(camera.camera().to());
    }

    /** The horizon stays level, as in other programs' turntables. */
    @Property
    void orbit_keepsTheDistanceTheTargetAndTheHorizon(@ForAll("cameras") PreviewCamera camera,
            @ForAll("distances") double right, @ForAll("distances") double up) {
        PreviewCamera view = camera.orbit(right, up, CANVAS).orbit(1, 0, CANVAS);
        assertThat(view.distance()).isCloseTo(camera.distance(), within(1e-9 * (1 + camera.distance())));
        assertThat(view.camera().to()).isEqualTo(camera.camera().to());
        assertThat(view.right().y()).isCloseTo(0, within(1e-9));
        assertThat(view.up().y()).isPositive();
    }

    @Test
    void orbit_nearSideFollowsTheMouse() {
        Vec3 near = reset.camera().to().minus(reset.forward().times(0.1));
        Viewport.Pixel before = CANVAS.project(reset, near);
        Viewport.Pixel after = CANVAS.project(reset.orbit(30, 20, CANVAS), near);
        assertThat(after.x()).isGreaterThan(before.x());
        assertThat(after.y()).isLessThan(before.y());
    }

    @Property
    void pan_whatIsLookedAtFollowsTheMouse(@ForAll("cameras") PreviewCamera camera, @ForAll("canvases") Viewport canvas,
            @ForAll("distances") double right, @ForAll("distances") double up) {
        Viewport.Pixel pixel = canvas.project(camera.pan(right, up, canvas), camera.camera().to());
        assertThat(pixel.x()).isCloseTo(canvas.width() / 2 + right, within(1e-6));
        assertThat(pixel.y()).isCloseTo(canvas.height() / 2 - up, within(1e-6));
    }

    @Property
    void zoomInAndOut_restoresCamera(@ForAll("cameras") PreviewCamera camera, @ForAll("distances") double up) {
        PreviewCamera back = camera.zoom(up, CANVAS).zoom(-up, CANVAS);
        assertClose(back.camera().from(), camera.camera().from(), 1e-9 * (1 + camera.camera().from().length()));
    }

    @Property
    void placeOfAPoint_liesOnItsRay(@ForAll("cameras") PreviewCamera camera, @ForAll("canvases") Viewport canvas,
            @ForAll("points") Vec3 point) {
        if (camera.depth(point) > 0.1) {
            Viewport.Pixel pixel = canvas.project(camera, point);
            Vec3 way = point.minus(camera.camera().from()).normalized();
            assertClose(canvas.direction(camera, pixel.x(), pixel.y()), way, 1e-9);
        }
    }

    public static void assertClose(Vec3 actual, Vec3 expected, double tolerance) {
        assertThat(actual.minus(expected).length()).as("%s, expected %s", actual, expected).isLessThanOrEqualTo(tolerance);
    }
}
