package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Vec3;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class DragRoundingTest {
    private static final Scene SCENE = StudioScene.of(LightType.SPOT);
    private static final PreviewCamera VIEW = PreviewCamera.of(SCENE);
    private static final Viewport CANVAS = new Viewport(640, 480);
    private static final int MAX_DIGITS = 8;

    private static void assertShort(double v) {
        assertThat(Double.toString(Math.abs(v)).replaceFirst("E.*", "").replace(".", "").replaceFirst("^0+", "").length())
                .as(Double.toString(v)).isLessThanOrEqualTo(MAX_DIGITS);
    }

    private static void assertShort(Vec3 v) {
        assertShort(v.x());
        assertShort(v.y());
        assertShort(v.z());
    }

    @Test
    void draggedLight_hasFewDigitsAndStaysWithinAThousandthOfAPixel() {
        Light start = SCENE.lights().getFirst();
        for (LightDrag drag : LightDrag.values()) {
            Light dragged = drag.apply(start, VIEW, CANVAS, 17, 31);
            Light rounded = DragRounding.round(start, dragged, VIEW, CANVAS);
            assertShort(rounded.position());
            assertShort(rounded.direction());
            double pixel = VIEW.pixelScale(VIEW.depth(dragged.position()), CANVAS.height());
            assertThat(rounded.position().minus(dragged.position()).maxAbs()).isLessThanOrEqualTo(pixel / 1000);
            assertThat(rounded.direction().minus(dragged.direction()).maxAbs())
                    .isLessThanOrEqualTo(1e-6 * dragged.direction().maxAbs());
        }
    }

    @Test
    void unmovedLight_keepsAllDigits() {
        Light start = SCENE.lights().getFirst().withPosition(new Vec3(0.1234567890123, 2.00000000000007, 1 / 3.0))
                .withDirection(new Vec3(-1 / 3.0, -1 / 7.0, 1e-9));
        assertThat(DragRounding.round(start, start, VIEW, CANVAS)).isEqualTo(start);
        Light moved = start.withPosition(start.position().plus(new Vec3(1, 0, 0)));
        Light rounded = DragRounding.round(start, moved, VIEW, CANVAS);
        assertThat(rounded.position().y()).isEqualTo(start.position().y());
        assertThat(rounded.direction()).isEqualTo(start.direction());
    }

    @Test
    void draggedNode_hasFewDigits() {
        var node = SCENE.stage().nodes().getFirst();
        NodeGizmo gizmo = NodeGizmo.of(SCENE, node, VIEW, CANVAS).orElseThrow();
        for (NodeGizmo.Handle handle : gizmo.handles()) {
            Placement dragged = gizmo.drag(handle, VIEW, CANVAS, new Viewport.Pixel(320, 240), new Viewport.Pixel(337, 271));
            Placement rounded = DragRounding.round(gizmo, dragged, VIEW, CANVAS);
            assertShort(rounded.position());
            assertShort(rounded.rotation());
            assertShort(rounded.scale());
        }
        assertThat(DragRounding.round(gizmo, node.placement(), VIEW, CANVAS)).isEqualTo(node.placement());
    }
}
