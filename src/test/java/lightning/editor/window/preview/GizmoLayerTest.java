package lightning.editor.window.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.manipulation.LightGizmo;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

/** Counts redrawn gizmos: with a thousand lights, their number determines the cost of editing one. */
class GizmoLayerTest {
    private static final Viewport CANVAS = new Viewport(300, 200);
    private static final Light KEY = Light.of("key", LightType.SPOT).withPosition(new Vec3(1, 1, 0));
    private static final Light FILL = Light.of("fill", LightType.POINT).withPosition(new Vec3(-1, 1, 0));
    private static final Light SUN = Light.of("sun", LightType.DIRECTIONAL).withPosition(new Vec3(0, 2, 0));
    private static final Scene SCENE = new Scene(new PictureSettings(30, 20, 0), Camera.DEFAULT, World.DEFAULT,
            List.of(), List.of(), List.of(KEY, FILL, SUN));
    private static final PreviewCamera CAMERA = PreviewCamera.of(SCENE);

    private final GizmoLayer layer = new GizmoLayer();

    private int drawn(Scene scene, Light selected, PreviewCamera camera) {
        int before = layer.gizmosDrawn();
        layer.draw(scene, selected, GizmoLayer.Marks.NONE, camera, CANVAS, 1);
        return layer.gizmosDrawn() - before;
    }

    @Test
    void editOfSelectedLight_redrawsOnlyIt() {
        assertThat(drawn(SCENE, KEY, CAMERA)).isEqualTo(3);
        Light moved = KEY.withPosition(new Vec3(1, 2, 0));
        assertThat(drawn(SCENE.withLight(moved), moved, CAMERA)).isEqualTo(1);
    }

    @Test
    void editWithoutGizmoChange_redrawsNothing() {
        drawn(SCENE, KEY, CAMERA);
        Light brighter = KEY.withIntensity(2).withColor(new Rgb(1, 0.5, 0.2));
        assertThat(drawn(SCENE.withLight(brighter), brighter, CAMERA)).isZero();
    }

    @Test
    void editOfOtherLight_redrawsAllButSelected() {
        drawn(SCENE, KEY, CAMERA);
        assertThat(drawn(SCENE.withLight(FILL.withPosition(new Vec3(-1, 2, 0))), KEY, CAMERA)).isEqualTo(2);
    }

    @Test
    void soloLight_darkensTheOthers() {
        drawn(SCENE, KEY, CAMERA);
        Light solo = KEY.withSolo(true);
        assertThat(drawn(SCENE.withLight(solo), solo, CAMERA)).isEqualTo(2);
    }

    @Test
    void newMarks_redrawSelectedLight() {
        drawn(SCENE, KEY, CAMERA);
        int before = layer.gizmosDrawn();
        var box = List.of(new LightGizmo.Stroke(new Viewport.Pixel(1, 1), new Viewport.Pixel(2, 2)));
        layer.draw(SCENE, KEY, new GizmoLayer.Marks(box, List.of()), CAMERA, CANVAS, 1);
        assertThat(layer.gizmosDrawn() - before).isEqualTo(1);
    }

    @Test
    void newSelectionOrView_redrawsAll() {
        drawn(SCENE, KEY, CAMERA);
        assertThat(drawn(SCENE, FILL, CAMERA)).isEqualTo(3);
        assertThat(drawn(SCENE, FILL, CAMERA.zoom(10, CANVAS))).isEqualTo(3);
    }
}
