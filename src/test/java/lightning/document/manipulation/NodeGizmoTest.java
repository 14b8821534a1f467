package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.document.manipulation.NodeGizmo.Action;
import lightning.document.manipulation.NodeGizmo.Handle;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class NodeGizmoTest {
    private static final Viewport CANVAS = new Viewport(640, 480);
    private static final Placement GROUP = new Placement(new Vec3(1, 0.5, -1), new Vec3(10, 50, -20), new Vec3(2, 0.5, -1));
    private static final Placement BALL = new Placement(new Vec3(0.3, 0.4, 0.2), new Vec3(0, 20, 0), new Vec3(0.5, 1, 0.5));

    private static Scene scene(Placement ball) {
        SceneNode shape = new Shape(Solid.SPHERE, "ball", Material.DEFAULT.name(), ball);
        return new Scene(PictureSettings.DEFAULT, new Camera(new Vec3(2, 3, 9), Vec3.ZERO, Vec3.Y, 40), World.DEFAULT,
                new Stage(List.of(), List.of(new NodeGroup("g", GROUP, List.of(shape)))), LightRig.EMPTY);
    }

    private static NodeGizmo gizmo(Placement ball) {
        Scene scene = scene(ball);
        return NodeGizmo.of(scene, scene.stage().node("ball").orElseThrow(), PreviewCamera.of(scene), CANVAS).orElseThrow();
    }

    private static Vec3 inScene(Vec3 point) {
        return GROUP.transform().transformPoint(point);
    }

    private static Viewport.Pixel center(Handle handle) {
        LightGizmo.Stroke first = NodeGizmo.strokes(handle, PreviewCamera.of(scene(BALL)), CANVAS).getFirst();
        return new Viewport.Pixel((first.from().x() + first.to().x()) / 2, (first.from().y() + first.to().y()) / 2);
    }

    @Test
    void everyHandle_isPickedWhereDrawn() {
        NodeGizmo gizmo = gizmo(BALL);
        assertThat(gizmo.handles()).extracting(Handle::action).contains(Action.MOVE, Action.ROTATE, Action.SCALE, Action.MOVE_IN_VIEW);
        assertThat(gizmo.handles()).allSatisfy(
                h -> assertThat(gizmo.pick(PreviewCamera.of(scene(BALL)), CANVAS, center(h), 1)).isPresent());
    }

    @Test
    void arrowDrag_changesOnlyItsAxis() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        NodeGizmo gizmo = gizmo(BALL);
        for (Handle handle : gizmo.handles()) {
            if (handle.action() == Action.MOVE) {
                Vec3 target = BALL.position().plus(NodeGizmo.unit(handle.axis()).times(0.7));
                Vec3 at = gizmo
                        .drag(handle, view, CANVAS, CANVAS.project(view, inScene(BALL.position())), CANVAS.project(view, inScene(target)))
                        .position();
                assertThat(at.minus(target).maxAbs()).as("stays under the mouse").isLessThan(1e-9);
            }
        }
    }

    @Test
    void originDrag_followsMouse() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        NodeGizmo gizmo = gizmo(BALL);
        Viewport.Pixel from = CANVAS.project(view, inScene(BALL.position()));
        var to = new Viewport.Pixel(from.x() + 40, from.y() - 25);
        Vec3 at = gizmo.drag(gizmo.handles().getLast(), view, CANVAS, from, to).position();
        assertThat(CANVAS.project(view, inScene(at)).distance(to)).isLessThan(1e-6);
    }

    @Test
    void snappedDrags_useRoundSteps() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        NodeGizmo gizmo = gizmo(BALL);
        Viewport.Pixel from = CANVAS.project(view, gizmo.origin());
        for (Handle handle : gizmo.handles()) {
            var begin = handle.action() == Action.SCALE || handle.action() == Action.ROTATE
                    ? new Viewport.Pixel(from.x() + 30, from.y() - 30) : from;
            var to = new Viewport.Pixel(from.x() + 61, from.y() - 47);
            Placement free = gizmo.drag(handle, view, CANVAS, begin, to);
            Placement snapped = gizmo.drag(handle, view, CANVAS, begin, to, true);
            double step = Snapping.gridStep(gizmo.origin(), view, CANVAS);
            switch (handle.action()) {
                case MOVE, MOVE_IN_VIEW -> {
                    assertThat(snapped).isNotEqualTo(free);
                    assertThat(inScene(snapped.position()).minus(inScene(free.position())).maxAbs()).isLessThanOrEqualTo(step / 2 * 1.0001);
                }
                case ROTATE -> assertThat(gizmo.drag(handle, view, CANVAS, begin, begin, true).rotation()).isEqualTo(BALL.rotation());
                case SCALE -> assertThat(snapped.scale().x() / BALL.scale().x() * 10)
                        .isCloseTo(Math.rint(10 * free.scale().x() / BALL.scale().x()), within(1e-9));
            }
        }
    }

    @Test
    void squareDrag_scalesUniformly() {
        NodeGizmo gizmo = gizmo(BALL);
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        Viewport.Pixel middle = CANVAS.project(view, inScene(BALL.position()));
        var from = new Viewport.Pixel(middle.x() + 30, middle.y() - 30);
        var to = new Viewport.Pixel(middle.x() + 60, middle.y() - 60);
        Handle square = gizmo.handles().stream().filter(h -> h.action() == Action.SCALE).findFirst().orElseThrow();
        assertThat(gizmo.drag(square, view, CANVAS, from, to).scale()).isEqualTo(BALL.scale().times(2));
    }

    @Test
    void ringDrag_followsMouse() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        var plain = new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);
        Scene scene = scene(plain);
        SceneNode ball = new Shape(Solid.SPHERE, "ball", Material.DEFAULT.name(), plain);
        Scene top = scene.withNodes(List.of(ball));
        NodeGizmo gizmo = NodeGizmo.of(top, ball, view, CANVAS).orElseThrow();
        for (Handle ring : gizmo.handles().stream().filter(h -> h.action() == Action.ROTATE).toList()) {
            Vec3 before = NodeGizmo.unit((ring.axis() + 1) % 3);
            Vec3 turn = NodeGizmo.unit(ring.axis()).times(30);
            Vec3 after = Transform.rotation(turn).transformVector(before);
            Placement turned = gizmo.drag(ring, view, CANVAS, CANVAS.project(view, before), CANVAS.project(view, after));
            assertThat(turned.rotation().minus(turn).maxAbs()).isLessThan(1e-3);
        }
    }

    @Property
    void turningAboutAnAxis_isTheProductOfRotations(@ForAll @DoubleRange(min = -400, max = 400) double x,
            @ForAll @DoubleRange(min = -400, max = 400) double y, @ForAll @DoubleRange(min = -400, max = 400) double z,
            @ForAll @IntRange(max = 2) int axis, @ForAll @DoubleRange(min = -180, max = 180) double degrees) {
        Vec3 rotate = new Vec3(x, y, z);
        Transform expected = Transform.rotation(NodeGizmo.unit(axis).times(degrees)).times(Transform.rotation(rotate));
        Transform found = Transform.rotation(EulerRotation.rotate(rotate, axis, degrees));
        for (int i = 0; i < 3; i++) {
            // Three angles, each rounded to 1e-4 degrees; in gimbal lock, the effect of a cosine of 1e-6 on each of them.
            assertThat(found.transformVector(NodeGizmo.unit(i)).minus(expected.transformVector(NodeGizmo.unit(i))).maxAbs())
                    .isCloseTo(0, within(3 * Math.toRadians(0.5e-4) + 3 * 1e-6));
        }
    }

    @Test
    void rotationAboutY_continuesBeyondRightAngle() {
        assertThat(EulerRotation.rotate(new Vec3(0, 80, 0), 1, 30)).isEqualTo(new Vec3(0, 110, 0));
        assertThat(EulerRotation.rotate(new Vec3(0, 60, 0), 1, 30)).isEqualTo(new Vec3(0, 90, 0));
        assertThat(EulerRotation.rotate(new Vec3(0, 90, 0), 1, 30)).isEqualTo(new Vec3(0, 120, 0));
    }
}
