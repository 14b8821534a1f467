package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import lightning.render.trace.Eye;
import lightning.scene.Camera;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

public class PreviewCameraTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final Scene scene = Desk.scene();
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
    Arbitrary<Double> ways() {
        return ViewArbitraries.ways();
    }

    @Provide
    Arbitrary<Vec3> points() {
        return ViewArbitraries.points();
    }

    @Test
    void reset_isTheScenesOwnView() {
        Camera own = scene.camera();
        assertThat(reset.camera().from()).isEqualTo(own.from());
        assertThat(reset.camera().to()).isEqualTo(own.to());
        assertThat(reset.camera().fov()).isEqualTo(own.fov());
    }

    @Test
    void axisButtons_lookDownTheirAxesFromTheSameDistance() {
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
    void zoom_upComesNearerAndKeepsWhatIsLookedAt() {
        PreviewCamera near = reset.zoomed(100, CANVAS);
        assertThat(near.distance()).isLessThan(reset.distance());
        assertThat(near.camera().to()).isEqualTo(reset.camera().to());
        assertThat(reset.zoomed(-100, CANVAS).distance()).isGreaterThan(reset.distance());
    }

    @Test
    void zoomWithoutEnd_neverPassesWhatIsLookedAt() {
        PreviewCamera view = reset;
        for (int i = 0; i < 100; i++) {
            view = view.zoomed(400, CANVAS);
        }
        assertThat(view.distance()).isPositive();
        assertClose(view.forward(), reset.forward(), 1e-6);
    }

    @Test
    void trackball_nearSideGoesWithTheMouse() {
        Vec3 near = reset.camera().to().minus(reset.forward());
        assertThat(CANVAS.pixel(reset.trackball(30, 0, CANVAS), near).x()).isGreaterThan(CANVAS.pixel(reset, near).x());
        assertThat(CANVAS.pixel(reset.trackball(0, 30, CANVAS), near).y()).isLessThan(CANVAS.pixel(reset, near).y());
    }

    @Test
    void drag_isDecidedByItsBegin() {
        assertThat(CameraDrag.begun(CANVAS, 300, 200, 1, 5)).isEqualTo(CameraDrag.ZOOM);
        assertThat(CameraDrag.begun(CANVAS, 300, 200, -5, 1)).isEqualTo(CameraDrag.PAN);
        assertThat(CameraDrag.begun(CANVAS, 10, 200, 1, 5)).isEqualTo(CameraDrag.TRACKBALL);
        assertThat(CameraDrag.begun(CANVAS, 300, 395, 5, 1)).isEqualTo(CameraDrag.TRACKBALL);
    }

    @Test
    void drag_doesWhatItsKindSays() {
        assertThat(CameraDrag.ZOOM.applied(reset, CANVAS, 7, -20)).isEqualTo(reset.zoomed(20, CANVAS));
        assertThat(CameraDrag.PAN.applied(reset, CANVAS, 7, -20)).isEqualTo(reset.panned(7, 20, CANVAS));
        assertThat(CameraDrag.TRACKBALL.applied(reset, CANVAS, 7, -20)).isEqualTo(reset.trackball(7, 20, CANVAS));
    }

    @Test
    void throughASpot_itsConeFillsThePicture() {
        PreviewCamera view = PreviewCamera.through(Desk.light(scene, "key"), scene);
        assertThat(view.camera().from()).isEqualTo(new Vec3(3, 5, 2));
        assertClose(view.forward(), new Vec3(-3, -4, -2).normalized(), 1e-12);
        assertThat(view.camera().fov()).isEqualTo(50);
    }

    @Test
    void throughAPointLight_whatTheCameraLooksAtIsInTheMiddle() {
        PreviewCamera view = PreviewCamera.through(Desk.light(scene, "fill"), scene);
        assertThat(view.camera().from()).isEqualTo(new Vec3(-3, 2, 4));
        assertThat(CANVAS.pixel(view, scene.camera().to()).x()).isCloseTo(300, within(1e-6));
    }

    @Test
    void throughADirectionalLight_itsPlaceDoesNotMatter() {
        var sun = Desk.light(scene, "sun");
        assertThat(PreviewCamera.through(sun.withPosition(new Vec3(50, 60, 70)), scene))
                .isEqualTo(PreviewCamera.through(sun, scene));
        assertClose(PreviewCamera.through(sun, scene).forward(), new Vec3(-1, -1, -1).normalized(), 1e-12);
    }

    @Test
    void throughALightThatShinesDown_isAViewToo() {
        var down = Desk.spot(new Vec3(0, 5, 0), new Vec3(0, -1, 0));
        assertClose(PreviewCamera.through(down, scene).forward(), new Vec3(0, -1, 0), 1e-12);
    }

    /** The renderer's own rays are the oracle: what a pixel's ray meets falls on that pixel. */
    @Test
    void pointsOnAPixelsRay_fallOnThePixelsMiddle() {
        var canvas = new Viewport(40, 30);
        for (int x = 0; x < 40; x += 13) {
            for (int y = 0; y < 30; y += 7) {
                Vec3 direction = new Eye(scene).through(x, y).direction();
                Viewport.Pixel pixel = canvas.pixel(reset, scene.camera().from().plus(direction.times(5)));
                assertThat(pixel.x()).isCloseTo(x + 0.5, within(1e-9));
                assertThat(pixel.y()).isCloseTo(y + 0.5, within(1e-9));
                assertClose(canvas.direction(reset, x + 0.5, y + 0.5), direction, 1e-12);
            }
        }
    }

    @Property
    void axes_areOrthonormalAfterAnyDrag(@ForAll("cameras") PreviewCamera camera, @ForAll("canvases") Viewport canvas,
            @ForAll("ways") double right, @ForAll("ways") double up, @ForAll CameraDrag drag) {
        PreviewCamera view = drag.applied(camera, canvas, right, up);
        assertThat(view.forward().length()).isCloseTo(1, within(1e-12));
        assertThat(view.right().length()).isCloseTo(1, within(1e-12));
        assertThat(view.up().length()).isCloseTo(1, within(1e-12));
        assertThat(view.forward().dot(view.right())).isCloseTo(0, within(1e-12));
        assertThat(view.forward().dot(view.up())).isCloseTo(0, within(1e-9));
        assertThat(view.right().dot(view.up())).isCloseTo(0, within(1e-9));
    }

    @Property
    void trackball_keepsTheDistanceAndWhatIsLookedAt(@ForAll("cameras") PreviewCamera camera,
            @ForAll("ways") double right, @ForAll("ways") double up) {
        PreviewCamera view = camera.trackball(right, up, CANVAS);
        assertThat(view.distance()).isCloseTo(camera.distance(), within(1e-9));
        assertThat(view.camera().to()).isEqualTo(camera.camera().to());
    }

    @Property
    void pan_whatIsLookedAtFollowsTheMouse(@ForAll("cameras") PreviewCamera camera, @ForAll("canvases") Viewport canvas,
            @ForAll("ways") double right, @ForAll("ways") double up) {
        Viewport.Pixel pixel = canvas.pixel(camera.panned(right, up, canvas), camera.camera().to());
        assertThat(pixel.x()).isCloseTo(canvas.width() / 2 + right, within(1e-6));
        assertThat(pixel.y()).isCloseTo(canvas.height() / 2 - up, within(1e-6));
    }

    @Property
    void zoomThereAndBack_isWhereItWas(@ForAll("cameras") PreviewCamera camera, @ForAll("ways") double up) {
        PreviewCamera back = camera.zoomed(up, CANVAS).zoomed(-up, CANVAS);
        assertClose(back.camera().from(), camera.camera().from(), 1e-9 * (1 + camera.camera().from().length()));
    }

    @Property
    void placeOfAPoint_liesOnItsRay(@ForAll("cameras") PreviewCamera camera, @ForAll("canvases") Viewport canvas,
            @ForAll("points") Vec3 point) {
        if (camera.depth(point) > 0.1) {
            Viewport.Pixel pixel = canvas.pixel(camera, point);
            Vec3 way = point.minus(camera.camera().from()).normalized();
            assertClose(canvas.direction(camera, pixel.x(), pixel.y()), way, 1e-9);
        }
    }

    public static void assertClose(Vec3 actual, Vec3 expected, double tolerance) {
        assertThat(actual.minus(expected).length()).as("%s, expected %s", actual, expected).isLessThanOrEqualTo(tolerance);
    }
}
