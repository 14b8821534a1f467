package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class LightGizmoTest {
    private static final Viewport CANVAS = new Viewport(600, 400);

    private final PreviewCamera view = PreviewCamera.of(DeskScene.scene());
    private final Vec3 target = view.camera().to();

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
        return DeskScene.spot(target, new Vec3(1, 0, 0)).withType(type);
    }

    private static Stream<Vec3> endpoints(LightGizmo gizmo) {
        return gizmo.lines().stream().flatMap(l -> Stream.of(l.from(), l.to()));
    }

    @Test
    void pointLight_isSphere() {
        double pixel = view.pixelScale(view.depth(target), 400);
        assertThat(endpoints(LightGizmo.of(light(LightType.POINT), view, CANVAS, 1)))
                .allSatisfy(p -> assertThat(p.minus(target).length() / pixel).isCloseTo(12, within(1e-9)));
    }

    /** Returns a light without an outline, whose size would depend on the light. */
    private Light lightAtTarget(LightType type) {
        return light(type).withArea(AreaShape.DEFAULT.withWidth(0).withHeight(0));
    }

    @Test
    void outlineOfAreaLight_hasItsSize() {
        Light rect = light(LightType.RECT).withArea(AreaShape.DEFAULT.withWidth(3).withHeight(1));
        List<LightGizmo.Segment> small = LightGizmo.of(rect, view, CANVAS, 1).lines();
        List<LightGizmo.Segment> large = LightGizmo.of(rect, view, CANVAS, 1.6).lines();
        assertThat(large.subList(large.size() - 4, large.size())).isEqualTo(small.subList(small.size() - 4, small.size()))
                .extracting(line -> line.to().minus(line.from()).length()).satisfies(lengths -> {
                    assertThat(lengths.get(0)).isCloseTo(3, within(1e-9));
                    assertThat(lengths.get(1)).isCloseTo(1, within(1e-9));
                });
    }

    @Test
    void size_multipliesEveryLengthOfTheGizmo() {
        for (LightType type : LightType.values()) {
            List<LightGizmo.Segment> small = LightGizmo.of(lightAtTarget(type), view, CANVAS, 1).lines();
            List<LightGizmo.Segment> large = LightGizmo.of(lightAtTarget(type), view, CANVAS, 1.6).lines();
            for (int i = 0; i < small.size(); i++) {
                Vec3 expected = target.plus(small.get(i).to().minus(target).times(1.6));
                assertThat(large.get(i).to().minus(expected).length()).isLessThan(1e-9);
            }
        }
    }

    @Test
    void spot_opensByItsAngle() {
        for (double angle : new double[] {5, 25, 60, 120}) {
            Light spot = light(LightType.SPOT).withAngle(angle);
            List<Vec3> rim = endpoints(LightGizmo.of(spot, view, CANVAS, 1)).filter(p -> p.minus(target).length() > 1e-9).toList();
            assertThat(rim).isNotEmpty()
                    .allSatisfy(p -> assertThat(Math.toDegrees(Math.acos(p.minus(target).normalized().dot(new Vec3(1, 0, 0)))))
                            .isCloseTo(angle, within(1e-6)));
        }
    }

    @Test
    void directionalLight_isLongAndThinAlongItsDirection() {
        LightGizmo gizmo = LightGizmo.of(light(LightType.DIRECTIONAL), view, CANVAS, 1);
        double length = endpoints(gizmo).mapToDouble(p -> p.minus(target).x()).max().orElseThrow();
        double radius = endpoints(gizmo).mapToDouble(p -> Math.abs(p.minus(target).y())).max().orElseThrow();
        assertThat(length).isGreaterThan(8 * radius);
    }

    @Test
    void click_picksNearestGizmo() {
        Light left = light(LightType.POINT).withName("left").withPosition(target.minus(view.right()));
        Light right = light(LightType.POINT).withName("right").withPosition(target.plus(view.right()));
        Viewport.Pixel place = CANVAS.project(view, right.position());
        assertThat(LightGizmo.pick(List.of(left, right), view, CANVAS, 1, place, 8)).contains(right);
    }

    @Test
    void clickOnEmptyCanvas_picksNothing() {
        assertThat(LightGizmo.pick(List.of(light(LightType.SPOT)), view, CANVAS, 1, new Viewport.Pixel(5, 5), 8)).isEmpty();
        assertThat(LightGizmo.pick(List.of(), view, CANVAS, 1, new Viewport.Pixel(5, 5), 8)).isEmpty();
    }

    @Test
    void lightsOnOneRay_pickNearer() {
        Light far = light(LightType.POINT).withName("far");
        Light near = light(LightType.POINT).withName("near").withPosition(target.minus(view.forward().times(2)));
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
    void sphere_hasConstantSizeOnCanvas(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 position) {
        Light point = light(LightType.POINT).withPosition(position);
        Viewport.Pixel middlePixel = CANVAS.project(camera, position);
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
        Light any = DeskScene.spot(position, direction).withType(type);
        assertThat(LightGizmo.of(any, camera, CANVAS, 1).strokes(camera, CANVAS)).allSatisfy(s -> {
            assertThat(s.from().x() + s.from().y() + s.to().x() + s.to().y()).isFinite();
        });
    }

    @Property
    void clickOnLightPosition_picksLight(@ForAll("cameras") PreviewCamera camera, @ForAll("points") Vec3 position, @ForAll LightType type) {
        if (camera.depth(position) > 0.1 * camera.distance()) {
            Light any = DeskScene.spot(position, new Vec3(0, -1, 0)).withType(type);
            assertThat(LightGizmo.pick(List.of(any), camera, CANVAS, 1, CANVAS.project(camera, position), 0.001)).contains(any);
        }
    }
}
