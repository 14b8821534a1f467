package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.scene.Area;
import lightning.scene.Light;
import lightning.scene.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class LightGizmoTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final PreviewCamera view = PreviewCamera.of(Desk.scene());
    private final Vec3 middle = view.camera().to();

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

    private Light light(LightType type) {
        return Desk.spot(middle, new Vec3(1, 0, 0)).withType(type);
    }

    private static Stream<Vec3> ends(LightGizmo gizmo) {
        return gizmo.lines().stream().flatMap(l -> Stream.of(l.from(), l.to()));
    }

    @Test
    void pointLight_isASphereAboutIt() {
        double pixel = view.pixelScale(view.depth(middle), 400);
        assertThat(ends(LightGizmo.of(light(LightType.POINT), view, CANVAS, 1)))
                .allSatisfy(p -> assertThat(p.minus(middle).length() / pixel).isCloseTo(12, within(1e-9)));
    }

    /** Without an outline, which has the size of the light. */
    private Light point(LightType type) {
        return light(type).withArea(Area.DEFAULT.withWidth(0).withHeight(0));
    }

    @Test
    void outlineOfALargerLight_hasItsOwnSize() {
        Light rect = light(LightType.RECT).withArea(Area.DEFAULT.withWidth(3).withHeight(1));
        List<LightGizmo.Line> small = LightGizmo.of(rect, view, CANVAS, 1).lines();
        List<LightGizmo.Line> large = LightGizmo.of(rect, view, CANVAS, 1.6).lines();
        assertThat(large.subList(large.size() - 4, large.size())).isEqualTo(small.subList(small.size() - 4, small.size()))
                .extracting(line -> line.to().minus(line.from()).length()).satisfies(lengths -> {
                    assertThat(lengths.get(0)).isCloseTo(3, within(1e-9));
                    assertThat(lengths.get(1)).isCloseTo(1, within(1e-9));
                });
    }

    @Test
    void size_multipliesEveryLengthOfTheGizmo() {
        for (LightType type : LightType.values()) {
            List<LightGizmo.Line> small = LightGizmo.of(point(type), view, CANVAS, 1).lines();
            List<LightGizmo.Line> large = LightGizmo.of(point(type), view, CANVAS, 1.6).lines();
            for (int i = 0; i < small.size(); i++) {
                Vec3 expected = middle.plus(small.get(i).to().minus(middle).times(1.6));
                assertThat(large.get(i).to().minus(expected).length()).isLessThan(1e-9);
            }
        }
    }

    @Test
    void spot_opensAsWideAsItsAngle() {
        for (double angle : new double[] {5, 25, 60, 120}) {
            Light spot = light(LightType.SPOT).withAngle(angle);
            List<Vec3> rim = ends(LightGizmo.of(spot, view, CANVAS, 1)).filter(p -> p.minus(middle).length() > 1e-9).toList();
            assertThat(rim).isNotEmpty()
                    .allSatisfy(p -> assertThat(Math.toDegrees(Math.acos(p.minus(middle).normalized().dot(new Vec3(1, 0, 0)))))
                            .isCloseTo(angle, within(1e-6)));
        }
    }

    @Test
    void directionalLight_isLongAndThinAlongItsDirection() {
        LightGizmo gizmo = LightGizmo.of(light(LightType.DIRECTIONAL), view, CANVAS, 1);
        double length = ends(gizmo).mapToDouble(p -> p.minus(middle).x()).max().orElseThrow();
        double radius = ends(gizmo).mapToDouble(p -> Math.abs(p.minus(middle).y())).max().orElseThrow();
        assertThat(length).isGreaterThan(8 * radius);
    }

    @Test
    void click_picksTheNearestGizmo() {
        Light left = light(LightType.POINT).withName("left").withPosition(middle.minus(view.right()));
        Light right = light(LightType.POINT).withName("right").withPosition(middle.plus(view.right()));
        Viewport.Pixel place = CANVAS.pixel(view, right.position());
        assertThat(LightGizmo.pick(List.of(left, right), view, CANVAS, 1, place, 8)).contains(right);
    }

    @Test
    void clickOnEmptyCanvas_picksNothing() {
        assertThat(LightGizmo.pick(List.of(light(LightType.SPOT)), view, CANVAS, 1, new Viewport.Pixel(5, 5), 8)).isEmpty();
        assertThat(LightGizmo.pick(List.of(), view, CANVAS, 1, new Viewport.Pixel(5, 5), 8)).isEmpty();
    }

    @Test
    void lightsOnOneRay_theNearerIsPicked() {
        Light far = light(LightType.POINT).withName("far");
        Light near = light(LightType.POINT).withName("near").withPosition(middle.minus(view.forward().times(2)));
        assertThat(LightGizmo.pick(List.of(far, near), view, CANVAS, 1, new Viewport.Pixel(300, 200), 8)).contains(near);
        assertThat(LightGizmo.pick(List.of(near, far), view, CANVAS, 1, new Viewport.Pixel(300, 200), 8)).contains(near);
    }

    @Test
    void lightBehindTheEye_isNeitherDrawnNorPicked() {
        Light behind = light(LightType.POINT).withPosition(view.camera().from().minus(view.forward().times(3)));
        LightGizmo gizmo = LightGizmo.of(behind, view, CANVAS, 1);
        assertThat(gizmo.strokes(view, CANVAS)).isEmpty();
        assertThat(gizmo.distance(view, CANVAS, new Viewport.Pixel(300, 200))).isInfinite();
    }

    @Property
    void sphere_hasTheSameSizeOnTheCanvasWhereverItIsSeen(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 position) {
        Light point = light(LightType.POINT).withPosition(position);
        Viewport.Pixel middlePixel = CANVAS.pixel(camera, position);
        boolean central = camera.depth(position) > 0.5
                && Math.hypot(middlePixel.x() - 300, middlePixel.y() - 200) < 100;
        if (central) {
            for (LightGizmo.Stroke stroke : LightGizmo.of(point, camera, CANVAS, 1).strokes(camera, CANVAS)) {
                assertThat(stroke.from().distance(middlePixel)).isLessThan(20);
            }
        }
    }

    @Property
    void everyStroke_isFinite(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 position,
            @ForAll("directions") Vec3 direction, @ForAll LightType type) {
        Light any = Desk.spot(position, direction).withType(type);
        assertThat(LightGizmo.of(any, camera, CANVAS, 1).strokes(camera, CANVAS)).allSatisfy(s -> {
            assertThat(s.from().x() + s.from().y() + s.to().x() + s.to().y()).isFinite();
        });
    }

    @Property
    void clickOnALightsPlace_picksIt(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 position, @ForAll LightType type) {
        if (camera.depth(position) > 0.1 * camera.distance()) {
            Light any = Desk.spot(position, new Vec3(0, -1, 0)).withType(type);
            assertThat(LightGizmo.pick(List.of(any), camera, CANVAS, 1, CANVAS.pixel(camera, position), 0.001)).contains(any);
        }
    }
}
