package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.canvas.Canvas;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.base.math.Vec3;
import lightning.document.LightEdits;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.PictureView;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

/** Drags the selected light and shape in the traced picture. */
class TracedGizmoTest extends EditorFixture {
    private Point2D inPicture(Vec3 point) {
        PictureView view = robot.lookup("#traced-picture").query();
        Bounds place = view.pictureBoundsProperty().getValue();
        var pixel = new Viewport(place.getWidth(), place.getHeight()).project(PreviewCamera.of(model().editor().scene()), point);
        return view.localToScreen(place.getMinX() + pixel.x(), place.getMinY() + pixel.y());
    }

    private void drag(Vec3 from, MouseButton button, double right, double down) {
        robot.moveTo(inPicture(from)).press(button).moveBy(right, down).release(button);
    }

    @Test
    void rightDrag_movesLightInOneUndoStep() {
        Scene before = model().editor().scene();
        Light lamp = light("lamp");
        drag(lamp.position(), MouseButton.SECONDARY, 30, 0);
        Vec3 way = light("lamp").position().minus(lamp.position());
        assertThat(way.x()).isGreaterThan(0.2);
        Point2D now = inPicture(light("lamp").position());
        assertThat(now.getX() - inPicture(lamp.position()).getX()).isBetween(28.0, 32.0);
        click("go");
        waitForPicture();
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void leftDrag_rotatesSpot() {
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        Light stage = light("stage");
        drag(stage.position(), MouseButton.PRIMARY, 20, 0);
        assertThat(light("stage").position()).isEqualTo(stage.position());
        assertThat(light("stage").direction()).isNotEqualTo(stage.direction());
    }

    /** Changing a canvas also redraws everything below it. */
    @Test
    void mouseOutside_hidesGizmo() {
        Canvas canvas = robot.lookup("#traced-gizmo > *").queryAs(Canvas.class);
        robot.moveTo(inPicture(new Vec3(0, 1, 0)));
        assertThat(canvas.isVisible()).isTrue();
        robot.moveTo("#go");
        assertThat(canvas.isVisible()).isFalse();
        robot.interact(() -> model().editor().edit(scene -> LightEdits.edit(scene, "lamp", l -> l.withIntensity(0.5))));
        assertThat(canvas.isVisible()).isFalse();
    }

    @Test
    void hiddenGizmo_cannotBeDragged() {
        robot.interact(() -> model().commands().run(Command.HIDE_GIZMOS));
        Scene before = model().editor().scene();
        drag(light("lamp").position(), MouseButton.SECONDARY, 30, 0);
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void handleDrag_movesShape() {
        robot.interact(() -> model().editor().selection().selectNode("ball"));
        drag(new Vec3(0, 1, 0), MouseButton.PRIMARY, 30, 0);
        assertThat(model().editor().scene().stage().node("ball").orElseThrow().placement().position().x()).isGreaterThan(0.2);
    }

    @Test
    void escape_duringShapeDrag_cancelsWithoutUndoStep() {
        robot.interact(() -> model().editor().selection().selectNode("ball"));
        Scene before = model().editor().scene();
        robot.moveTo(inPicture(new Vec3(0, 1, 0))).press(MouseButton.PRIMARY).moveBy(30, 0);
        assertThat(model().editor().scene()).isNotEqualTo(before);
        robot.push(KeyCode.ESCAPE).moveBy(10, 0).release(MouseButton.PRIMARY);
        assertThat(model().editor().scene()).isEqualTo(before);
        assertThat(model().commands().isEnabled(Command.UNDO)).isFalse();
    }
}
