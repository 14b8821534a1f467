package lightning.editor.window.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Point2D;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.base.math.Vec3;
import lightning.document.LightEdits;
import lightning.document.manipulation.DragRounding;
import lightning.document.manipulation.LightManipulation;
import lightning.document.manipulation.NodeGizmo;
import lightning.document.manipulation.PreviewCamera;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.FastRobot;
import lightning.editor.window.model.CameraNavigation;
import lightning.editor.window.model.GizmoSize;
import lightning.scene.light.Light;
import lightning.scene.node.SceneNode;
import org.junit.jupiter.api.Test;

class PreviewTest extends EditorFixture {

    private void drag(Light light, MouseButton button, double right, double down) {
        Point2D from = toScreen(light.position());
        robot.moveTo(from);
        robot.press(button);
        robot.moveTo(from.add(right / 2, down / 2));
        robot.moveTo(from.add(right, down));
        robot.release(button);
    }

    /** Drags with a key held. The headless platform does not add modifier keys to mouse events, so this method sends the events itself. */
    private void dragHolding(KeyCode key, Point2D from, double right, double down) {
        sendMouseEvent(MouseEvent.MOUSE_PRESSED, key, from);
        sendMouseEvent(MouseEvent.MOUSE_DRAGGED, key, from.add(right / 2, down / 2));
        sendMouseEvent(MouseEvent.MOUSE_DRAGGED, key, from.add(right, down));
        sendMouseEvent(MouseEvent.MOUSE_RELEASED, key, from.add(right, down));
    }

    private void sendMouseEvent(EventType<MouseEvent> type, KeyCode key, Point2D screen) {
        robot.interact(() -> {
            Point2D at = preview().localToScene(preview().screenToLocal(screen));
            Event.fireEvent(preview(), new MouseEvent(type, at.getX(), at.getY(), screen.getX(), screen.getY(),
                    MouseButton.PRIMARY, 1, key == KeyCode.SHIFT, false, key == KeyCode.ALT, false, true, false, false, true,
                    false, false, null));
        });
    }

    @Test
    void altNavigation_orbitsCameraOverALight() {
        robot.interact(() -> model().previewSettings().navigationProperty().set(CameraNavigation.ALT));
        PreviewCamera before = model().previewSettings().cameraProperty().get();
        Light light = light("stage");
        dragHolding(KeyCode.ALT, toScreen(light.position()), 40, -10);
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(before.orbit(40, 10, preview().viewport()))
                .isNotEqualTo(before);
        assertThat(light("stage")).isEqualTo(light);
    }

    @Test
    void middleNavigation_orbitsCamera() {
        robot.interact(() -> model().previewSettings().navigationProperty().set(CameraNavigation.MIDDLE));
        PreviewCamera before = model().previewSettings().cameraProperty().get();
        Light light = light("lamp");
        drag(light, MouseButton.MIDDLE, 40, 10);
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(before.orbit(40, -10, preview().viewport()));
        assertThat(light("lamp")).isEqualTo(light);
    }

    @Test
    void clickOnAGizmo_selectsItsLight() {
        robot.clickOn(toScreen(light("stage").position()));
        assertThat(model().editor().selection().light().name()).isEqualTo("stage");
        robot.clickOn(toScreen(light("lamp").position()));
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    private void addStage2AtStage() {
        model().editor().edit(scene -> LightEdits.duplicate(scene, "stage"));
        model().editor().edit(scene -> LightEdits.edit(scene, "stage2", l -> l.withPosition(light("stage").position())));
    }

    @Test
    void repeatedClicks_onOverlappingGizmos_cycleSelection() {
        robot.interact(this::addStage2AtStage);
        Point2D place = toScreen(light("stage").position());
        robot.clickOn(place);
        String first = model().editor().selection().light().name();
        robot.clickOn(place);
        assertThat(List.of(first, model().editor().selection().light().name())).containsExactlyInAnyOrder("stage", "stage2");
        robot.clickOn(place);
        assertThat(model().editor().selection().light().name()).isEqualTo(first);
    }

    @Test
    void dragOfSelectedLight_underOthers_keepsSelection() {
        robot.interact(() -> {
            addStage2AtStage();
            model().editor().selection().selectLight("stage2");
        });
        Light other = light("stage");
        drag(light("stage2"), MouseButton.SECONDARY, 20, 10);
        assertThat(light("stage2").position()).isNotEqualTo(other.position());
        assertThat(light("stage")).isEqualTo(other);
    }

    private Light rounded(Light before, Light dragged) {
        return DragRounding.round(before, dragged, model().previewSettings().cameraProperty().get(), preview().viewport());
    }

    @Test
    void leftDrag_rotatesLightInOneUndoStep() {
        Light before = light("stage");
        drag(before, MouseButton.PRIMARY, 40, 10);
        Light expected = rounded(before,
                LightManipulation.rotate(before, model().previewSettings().cameraProperty().get(), preview().viewport(), 40, -10));
        assertThat(light("stage")).isEqualTo(expected).isNotEqualTo(before);
        click("undo");
        assertThat(light("stage")).isEqualTo(before);
    }

    @Test
    void leftDragOfAPointLight_changesNothing() {
        Light before = light("lamp");
        drag(before, MouseButton.PRIMARY, 40, 10);
        assertThat(light("lamp")).isEqualTo(before);
        assertThat(isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void rightDrag_movesLight() {
        Light before = light("lamp");
        Point2D target = toScreen(before.position()).add(30, 20);
        drag(before, MouseButton.SECONDARY, 30, 20);
        assertThat(toScreen(light("lamp").position()).distance(target)).isLessThan(0.01);
    }

    @Test
    void middleDragUp_movesLightAway() {
        Light before = light("lamp");
        drag(before, MouseButton.MIDDLE, 0, -40);
        PreviewCamera view = model().previewSettings().cameraProperty().get();
        assertThat(view.depth(light("lamp").position())).isGreaterThan(view.depth(before.position()));
    }

    @Test
    void altAndLeftDrag_isAMiddleDrag() {
        Light before = light("stage");
        dragHolding(KeyCode.ALT, toScreen(before.position()), 0, -40);
        Light expected = rounded(before,
                LightManipulation.dolly(before, model().previewSettings().cameraProperty().get(), preview().viewport(), 40));
        assertThat(light("stage")).isEqualTo(expected).isNotEqualTo(before);
    }

    @Test
    void movingADirectionalLight_leavesNothingToRender() {
        Light before = light("sun");
        drag(before, MouseButton.SECONDARY, 20, 10);
        assertThat(light("sun").position()).isNotEqualTo(before.position());
        assertThat(isEnabled(Command.GO)).isFalse();
        assertThat(isEnabled(Command.SAVE_SCENE)).isTrue();
    }

    @Test
    void shiftDragUp_zoomsAndResetRestores() {
        PreviewCamera before = model().previewSettings().cameraProperty().get();
        dragHolding(KeyCode.SHIFT, toScreen(Vec3.ZERO), 3, -60);
        assertThat(model().previewSettings().cameraProperty().get().distance()).isLessThan(before.distance());
        click("view-z");
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(before);
    }

    @Test
    void shiftDragRight_pansTheScene() {
        double before = toScreen(Vec3.ZERO).getX();
        dragHolding(KeyCode.SHIFT, toScreen(Vec3.ZERO), 50, 2);
        assertThat(toScreen(Vec3.ZERO).getX()).isGreaterThan(before + 40);
    }

    @Test
    void viewButtons_setAxisViews() {
        click("view-x");
        assertThat(model().previewSettings().cameraProperty().get().forward().x()).isGreaterThan(0.99);
        click("view-y");
        assertThat(model().previewSettings().cameraProperty().get().forward().y()).isLessThan(-0.99);
    }

    @Test
    void previewCamera_neverChangesPicture() {
        click("view-x");
        assertThat(isEnabled(Command.GO)).isFalse();
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    @Test
    void heldArrowKey_rotatesLightInOneUndoStep() {
        robot.clickOn(toScreen(light("stage").position()));
        Light before = light("stage");
        robot.press(KeyCode.RIGHT);
        robot.press(KeyCode.RIGHT);
        robot.release(KeyCode.RIGHT);
        assertThat(light("stage").direction()).isNotEqualTo(before.direction());
        click("undo");
        assertThat(light("stage")).isEqualTo(before);
    }

    @Test
    void pageUp_movesTheLightAway() {
        robot.clickOn(toScreen(light("lamp").position()));
        Light before = light("lamp");
        robot.type(KeyCode.PAGE_UP);
        assertThat(light("lamp").position().z()).isLessThan(before.position().z());
    }

    @Test
    void bracketKeys_selectTheNextLight() {
        robot.clickOn(toScreen(light("lamp").position()));
        robot.type(KeyCode.CLOSE_BRACKET);
        assertThat(model().editor().selection().light().name()).isEqualTo("sun");
        robot.type(KeyCode.OPEN_BRACKET);
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void lightOutOfView_isDraggedByMarker() {
        robot.interact(() -> model().previewSettings().cameraProperty().set(
                model().previewSettings().cameraProperty().get().pan(-400, 0, preview().viewport())));
        assertThat(
                LightMarker.of(model().editor().scene().lights(), model().previewSettings().cameraProperty().get(), preview().viewport()))
                .hasSize(3);
        var marker =
                LightMarker.of(model().editor().scene().lights(), model().previewSettings().cameraProperty().get(), preview().viewport())
                        .getLast();
        robot.clickOn(preview().toScreen(marker.tip()));
        assertThat(model().editor().selection().light()).isIn(model().editor().scene().lights());
        click("view-all");
        assertThat(
                LightMarker.of(model().editor().scene().lights(), model().previewSettings().cameraProperty().get(), preview().viewport()))
                .isEmpty();
    }

    @Test
    void hiddenGizmo_isNeitherDraggedNorSelected() {
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        click("hide-gizmos");
        Light lamp = light("lamp");
        robot.clickOn(toScreen(lamp.position()));
        drag(lamp, MouseButton.SECONDARY, 30, 20);
        assertThat(model().editor().selection().light().name()).isEqualTo("stage");
        assertThat(light("lamp")).isEqualTo(lamp);
        assertThat(isEnabled(Command.UNDO)).isFalse();
        click("hide-gizmos");
        robot.clickOn(toScreen(lamp.position()));
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void hiddenMarker_isNotDragged() {
        robot.interact(() -> model().previewSettings().cameraProperty().set(
                model().previewSettings().cameraProperty().get().pan(-400, 0, preview().viewport())));
        var marker =
                LightMarker.of(model().editor().scene().lights(), model().previewSettings().cameraProperty().get(), preview().viewport())
                        .getLast();
        robot.interact(() -> {
            model().editor().selection().selectLight("lamp");
            preview().requestFocus();
        });
        robot.type(KeyCode.G);
        assertThat(model().previewSettings().gizmosHiddenProperty().get()).isTrue();
        robot.clickOn(preview().toScreen(marker.tip()));
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void largeGizmo_isDraggedWhereDrawn() {
        // The sphere of a point light has a radius of 12 pixels, or 19.2 when enlarged; a click may miss it by 8.
        Point2D rim = toScreen(light("lamp").position()).add(0, -24);
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        robot.clickOn(rim);
        assertThat(model().editor().selection().light().name()).isEqualTo("stage");
        robot.interact(() -> model().previewSettings().gizmoSizeProperty().set(GizmoSize.LARGE));
        robot.clickOn(rim);
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void openedScene_initiallyHasFramingOfThePicture() throws Exception {
        PreviewCamera own = PreviewCamera.of(model().editor().scene());
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(own);
        assertThat(text("preview-caption")).startsWith("Scene camera · only shadows of lamp");
        String text = Files.readString(folder.resolve("desk.jen")).replace("at -2 2.2 0.5", "at -2 6.2 0.5");
        Path other = Files.writeString(folder.resolve("high.jen"), text);
        robot.interact(() -> editor.files().load(other));
        waitFor("the scene is open", () -> model().editor().document().name().equals("high.jen"));
        waitForPicture();
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(own);
        click("view-all");
        assertThat(model().previewSettings().cameraProperty().get().distance()).isGreaterThan(own.distance());
        assertThat(text("preview-caption")).startsWith("Free view");
        assertThat(
                LightMarker.of(model().editor().scene().lights(), model().previewSettings().cameraProperty().get(), preview().viewport()))
                .isEmpty();
        assertThat(model().picture().frame().scene().camera()).as("of the traced picture").isEqualTo(model().editor().scene().camera());
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    @Test
    void edit_keepsView() {
        PreviewCamera before = model().previewSettings().cameraProperty().get();
        robot.interact(() -> model().editor().edit(scene -> LightEdits.edit(scene, "lamp", l -> l.withPosition(new Vec3(0, 50, 0)))));
        FastRobot.settle();
        assertThat(model().previewSettings().cameraProperty().get()).isEqualTo(before);
    }

    private NodeGizmo.Handle handle(NodeGizmo of, NodeGizmo.Action act, int axis) {
        return of.handles().stream().filter(h -> h.action() == act && h.axis() == axis).findFirst().orElseThrow();
    }

    @Test
    void clickOnAShape_selectsItAndAnArrowMovesIt() {
        robot.clickOn(toScreen(new Vec3(0, 0.6, 0)));
        waitFor("the object is selected", () -> model().editor().selection().node().isPresent());
        SceneNode ball = model().editor().selection().node().orElseThrow();
        assertThat(ball.name()).isEqualTo("ball");
        PreviewCamera view = model().previewSettings().cameraProperty().get();
        NodeGizmo gizmo = NodeGizmo.of(model().editor().scene(), ball, view, preview().viewport()).orElseThrow();
        Vec3 tip = handle(gizmo, NodeGizmo.Action.MOVE, 1).lines().getFirst().to();
        Point2D from = toScreen(tip);
        robot.moveTo(from);
        robot.press(MouseButton.PRIMARY);
        robot.moveTo(from.add(0, -20));
        robot.moveTo(toScreen(tip.plus(new Vec3(0, 0.5, 0))));
        robot.release(MouseButton.PRIMARY);
        Vec3 at = model().editor().selection().node().orElseThrow().placement().position();
        assertThat(at.x()).isZero();
        assertThat(at.z()).isZero();
        assertThat(at.y()).isBetween(1.4, 1.6);
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().selection().node()).as("all of the drag was one step").contains(ball);
    }
}
