package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.editor.document.NodeGizmo.Act;
import lightning.editor.document.NodeGizmo.Handle;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;
import lightning.scene.World;
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
        Node shape = new Shape(Solid.SPHERE, "ball", Material.DEFAULT.name(), ball);
        return new Scene(Picture.DEFAULT, new Camera(new Vec3(2, 3, 9), Vec3.ZERO, Vec3.Y, 40), World.DEFAULT,
                new Stage(List.of(), List.of(new Group("g", GROUP, List.of(shape)))), Rig.DARK);
    }

    private static NodeGizmo gizmo(Placement ball) {
        Scene scene = scene(ball);
        return NodeGizmo.of(scene, scene.stage().node("ball").orElseThrow(), PreviewCamera.of(scene), CANVAS).orElseThrow();
    }

    private static Vec3 inScene(Vec3 point) {
        return GROUP.transform().point(point);
    }

    private static Viewport.Pixel middle(Handle handle) {
        LightGizmo.Stroke first = NodeGizmo.strokes(handle, PreviewCamera.of(scene(BALL)), CANVAS).getFirst();
        return new Viewport.Pixel((first.from().x() + first.to().x()) / 2, (first.from().y() + first.to().y()) / 2);
    }

    @Test
    void everyHandle_isTakenWhereItIsDrawn() {
        NodeGizmo gizmo = gizmo(BALL);
        assertThat(gizmo.handles()).extracting(Handle::act).contains(Act.MOVE, Act.TURN, Act.SCALE, Act.FREE);
        assertThat(gizmo.handles()).allSatisfy(
                h -> assertThat(gizmo.pick(PreviewCamera.of(scene(BALL)), CANVAS, middle(h), 1)).isPresent());
    }

    @Test
    void dragOfAnArrow_changesItsAxisAlone() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        NodeGizmo gizmo = gizmo(BALL);
        for (Handle handle : gizmo.handles()) {
            if (handle.act() == Act.MOVE) {
                Vec3 target = BALL.at().plus(NodeGizmo.unit(handle.axis()).times(0.7));
                Vec3 at = gizmo.dragged(handle, view, CANVAS, CANVAS.pixel(view, inScene(BALL.at())), CANVAS.pixel(view, inScene(target)))
                        .at();
                assertThat(at.minus(target).maxAbs()).as("it stands under the mouse").isLessThan(1e-9);
            }
        }
    }

    @Test
    void dragOfTheOrigin_followsTheMouse() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        NodeGizmo gizmo = gizmo(BALL);
        Viewport.Pixel from = CANVAS.pixel(view, inScene(BALL.at()));
        var to = new Viewport.Pixel(from.x() + 40, from.y() - 25);
        Vec3 at = gizmo.dragged(gizmo.handles().getLast(), view, CANVAS, from, to).at();
        assertThat(CANVAS.pixel(view, inScene(at)).distance(to)).isLessThan(1e-6);
    }

    @Test
    void snappedDrags_moveTurnAndScaleInRoundSteps() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        NodeGizmo gizmo = gizmo(BALL);
        Viewport.Pixel from = CANVAS.pixel(view, gizmo.origin());
        for (Handle handle : gizmo.handles()) {
            var begin = handle.act() == Act.SCALE || handle.act() == Act.TURN ? new Viewport.Pixel(from.x() + 30, from.y() - 30) : from;
            var to = new Viewport.Pixel(from.x() + 61, from.y() - 47);
            Placement free = gizmo.dragged(handle, view, CANVAS, begin, to);
            Placement snapped = gizmo.dragged(handle, view, CANVAS, begin, to, true);
            double step = Snap.step(gizmo.origin(), view, CANVAS);
            switch (handle.act()) {
                case MOVE, FREE -> {
                    assertThat(snapped).isNotEqualTo(free);
                    assertThat(inScene(snapped.at()).minus(inScene(free.at())).maxAbs()).isLessThanOrEqualTo(step / 2 * 1.0001);
                }
                case TURN -> assertThat(gizmo.dragged(handle, view, CANVAS, begin, begin, true).rotate()).isEqualTo(BALL.rotate());
                case SCALE -> assertThat(snapped.scale().x() / BALL.scale().x() * 10)
                        .isCloseTo(Math.rint(10 * free.scale().x() / BALL.scale().x()), within(1e-9));
            }
        }
    }

    @Test
    void dragOfTheSquare_scalesAllAxesAlike() {
        NodeGizmo gizmo = gizmo(BALL);
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        Viewport.Pixel middle = CANVAS.pixel(view, inScene(BALL.at()));
        var from = new Viewport.Pixel(middle.x() + 30, middle.y() - 30);
        var to = new Viewport.Pixel(middle.x() + 60, middle.y() - 60);
        Handle square = gizmo.handles().stream().filter(h -> h.act() == Act.SCALE).findFirst().orElseThrow();
        assertThat(gizmo.dragged(square, view, CANVAS, from, to).scale()).isEqualTo(BALL.scale().times(2));
    }

    @Test
    void dragOfARing_turnsWithTheMouse() {
        PreviewCamera view = PreviewCamera.of(scene(BALL));
        var plain = new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE);
        Scene scene = scene(plain);
        Node ball = new Shape(Solid.SPHERE, "ball", Material.DEFAULT.name(), plain);
        Scene top = scene.withNodes(List.of(ball));
        NodeGizmo gizmo = NodeGizmo.of(top, ball, view, CANVAS).orElseThrow();
        for (Handle ring : gizmo.handles().stream().filter(h -> h.act() == Act.TURN).toList()) {
            Vec3 before = NodeGizmo.unit((ring.axis() + 1) % 3);
            Vec3 turn = NodeGizmo.unit(ring.axis()).times(30);
            Vec3 after = Transform.rotation(turn).vector(before);
            Placement turned = gizmo.dragged(ring, view, CANVAS, CANVAS.pixel(view, before), CANVAS.pixel(view, after));
            assertThat(turned.rotate().minus(turn).maxAbs()).isLessThan(1e-3);
        }
    }

    @Property
    void turningAboutAnAxis_isTheProductOfRotations(@ForAll @DoubleRange(min = -400, max = 400) double x,
            @ForAll @DoubleRange(min = -400, max = 400) double y, @ForAll @DoubleRange(min = -400, max = 400) double z,
            @ForAll @IntRange(max = 2) int axis, @ForAll @DoubleRange(min = -180, max = 180) double degrees) {
        Vec3 rotate = new Vec3(x, y, z);
        Transform expected = Transform.rotation(NodeGizmo.unit(axis).times(degrees)).times(Transform.rotation(rotate));
        Transform found = Transform.rotation(Turning.about(rotate, axis, degrees));
        for (int i = 0; i < 3; i++) {
            // Three angles, each rounded to a ten-thousandth of a degree; where the angles lock, what a cosine of 1e-6 makes in each of them.
            assertThat(found.vector(NodeGizmo.unit(i)).minus(expected.vector(NodeGizmo.unit(i))).maxAbs())
                    .isCloseTo(0, within(3 * Math.toRadians(0.5e-4) + 3 * 1e-6));
        }
    }

    @Test
    void turningAboutY_goesOnBeyondARightAngle() {
        assertThat(Turning.about(new Vec3(0, 80, 0), 1, 30)).isEqualTo(new Vec3(0, 110, 0));
        assertThat(Turning.about(new Vec3(0, 60, 0), 1, 30)).isEqualTo(new Vec3(0, 90, 0));
        assertThat(Turning.about(new Vec3(0, 90, 0), 1, 30)).isEqualTo(new Vec3(0, 120, 0));
    }
}
