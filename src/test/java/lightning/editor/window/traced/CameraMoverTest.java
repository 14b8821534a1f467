package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.document.manipulation.PreviewCamera;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.PictureView;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Moves the scene's camera by drags in the traced picture. */
class CameraMoverTest extends EditorFixture {
    @BeforeEach
    void moveCamera() {
        robot.interact(() -> model().commands().run(Command.MOVE_CAMERA));
    }

    private Point2D corner() {
        PictureView view = robot.lookup("#traced-picture").query();
        Bounds place = view.pictureBoundsProperty().getValue();
        return view.localToScreen(place.getMinX() + 20, place.getMinY() + 20);
    }

    private Camera camera() {
        return model().editor().scene().camera();
    }

    private void drag(MouseButton button, double right, double down) {
        robot.moveTo(corner()).press(button).moveBy(right, down).release(button);
    }

    @Test
    void leftDrag_orbitsInOneUndoStep() {
        Camera before = camera();
        drag(MouseButton.PRIMARY, 30, 10);
        double distance = camera().to().minus(camera().from()).length();
        assertThat(camera().from()).isNotEqualTo(before.from());
        assertThat(camera().fov()).isEqualTo(before.fov());
        assertThat(distance).as("the point in the middle stays").isPositive();
        waitForPicture();
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(camera()).isEqualTo(before);
    }

    @Test
    void middleDrag_movesCameraAndTarget() {
        Camera before = camera();
        drag(MouseButton.MIDDLE, 30, 0);
        assertThat(camera().from()).isNotEqualTo(before.from());
        assertThat(PreviewCamera.of(model().editor().scene()).forward().dot(new PreviewCamera(before).forward())).isCloseTo(1,
                within(1e-9));
    }

    @Test
    void rightDrag_comesNearer() {
        Camera before = camera();
        drag(MouseButton.SECONDARY, 0, -40);
        assertThat(camera().from().minus(before.from()).dot(new PreviewCamera(before).forward())).isPositive();
    }

    @Test
    void escape_duringDrag_restoresTheCamera() {
        Camera before = camera();
        robot.moveTo(corner()).press(MouseButton.PRIMARY).moveBy(30, 0);
        assertThat(camera()).isNotEqualTo(before);
        robot.push(KeyCode.ESCAPE).moveBy(10, 0).release(MouseButton.PRIMARY);
        assertThat(camera()).isEqualTo(before);
        assertThat(model().commands().isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void escape_endsMoving() {
        robot.push(KeyCode.ESCAPE);
        Camera before = camera();
        drag(MouseButton.SECONDARY, 30, 0);
        assertThat(camera()).isEqualTo(before);
    }

    @Test
    void previewThroughTheCamera_followsIt() {
        robot.interact(() -> model().commands().run(Command.VIEW_Z));
        drag(MouseButton.PRIMARY, 30, 10);
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(PreviewCamera.of(model().editor().scene()));
    }

    @Test
    void viewOfThePreview_becomesTheCamera() {
        robot.interact(() -> {
            model().commands().run(Command.VIEW_X);
            model().commands().run(Command.USE_VIEW);
        });
        PreviewCamera view = model().previewSettings().cameraProperty().get();
        assertThat(camera().from()).isEqualTo(view.camera().from());
        assertThat(camera().to()).isEqualTo(view.camera().to());
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(camera().from()).isNotEqualTo(view.camera().from());
    }
}
