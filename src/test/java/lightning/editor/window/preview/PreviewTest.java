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
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.LightManipulation;
import lightning.editor.document.NodeGizmo;
import lightning.editor.document.PreviewCamera;
import lightning.editor.window.EditorDesk;
import lightning.editor.window.QuickRobot;
import lightning.editor.window.model.GizmoSize;
import lightning.scene.Light;
import lightning.scene.Node;
import org.junit.jupiter.api.Test;

class PreviewTest extends EditorDesk {

    private void drag(Light light, MouseButton button, double right, double down) {
        Point2D from = inPreview(light.position());
        robot.moveTo(from);
        robot.press(button);
        robot.moveTo(from.add(right / 2, down / 2));
        robot.moveTo(from.add(right, down));
        robot.release(button);
    }

    /** Holds a key. The platform without windows does not tell mouse events of keys, so these are told by hand. */
    private void dragHolding(KeyCode held, Point2D from, double right, double down) {
        tell(MouseEvent.MOUSE_PRESSED, held, from);
        tell(MouseEvent.MOUSE_DRAGGED, held, from.add(right / 2, down / 2));
        tell(MouseEvent.MOUSE_DRAGGED, held, from.add(right, down));
        tell(MouseEvent.MOUSE_RELEASED, held, from.add(right, down));
    }

    private void tell(EventType<MouseEvent> type, KeyCode held, Point2D screen) {
        robot.interact(() -> {
            Point2D at = preview().localToScene(preview().screenToLocal(screen));
            Event.fireEvent(preview(), new MouseEvent(type, at.getX(), at.getY(), screen.getX(), screen.getY(),
                    MouseButton.PRIMARY, 1, held == KeyCode.SHIFT, false, held == KeyCode.ALT, false, true, false, false, true,
                    false, false, null));
        });
    }

    @Test
    void clickOnAGizmo_selectsItsLight() {
        robot.clickOn(inPreview(light("stage").position()));
        assertThat(model().editor().selection().light().name()).isEqualTo("stage");
        robot.clickOn(inPreview(light("lamp").position()));
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    private void addStage2AtStage() {
        model().editor().edit(scene -> LightEdits.duplicate(scene, "stage"));
        model().editor().edit(scene -> LightEdits.with(scene, "stage2", l -> l.withPosition(light("stage").position())));
    }

    @Test
    void clicksOnGizmosAtOnePlace_selectOneAfterTheOther() {
        robot.interact(this::addStage2AtStage);
        Point2D place = inPreview(light("stage").position());
        robot.clickOn(place);
        String first = model().editor().selection().light().name();
        robot.clickOn(place);
        assertThat(List.of(first, model().editor().selection().light().name())).containsExactlyInAnyOrder("stage", "stage2");
        robot.clickOn(place);
        assertThat(model().editor().selection().light().name()).isEqualTo(first);
    }

    @Test
    void dragOfTheSelectedLight_keepsItWhereOthersLieOverIt() {
        robot.interact(() -> {
            addStage2AtStage();
            model().editor().selection().selectLight("stage2");
        });
        Light other = light("stage");
        drag(light("stage2"), MouseButton.SECONDARY, 20, 10);
        assertThat(light("stage2").position()).isNotEqualTo(other.position());
        assertThat(light("stage")).isEqualTo(other);
    }

    @Test
    void leftDrag_turnsTheLightInOneStep() {
        Light before = light("stage");
        drag(before, MouseButton.PRIMARY, 40, 10);
        Light expected = LightManipulation.rotate(before, model().previewLook().cameraProperty().get(), preview().viewport(), 40, -10);
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
    void rightDrag_movesTheLightUnderTheMouse() {
        Light before = light("lamp");
        Point2D target = inPreview(before.position()).add(30, 20);
        drag(before, MouseButton.SECONDARY, 30, 20);
        assertThat(inPreview(light("lamp").position()).distance(target)).isLessThan(0.01);
    }

    @Test
    void middleDragUp_movesTheLightAway() {
        Light before = light("lamp");
        drag(before, MouseButton.MIDDLE, 0, -40);
        PreviewCamera view = model().previewLook().cameraProperty().get();
        assertThat(view.depth(light("lamp").position())).isGreaterThan(view.depth(before.position()));
    }

    @Test
    void altAndLeftDrag_isAMiddleDrag() {
        Light before = light("stage");
        dragHolding(KeyCode.ALT, inPreview(before.position()), 0, -40);
        Light expected = LightManipulation.dolly(before, model().previewLook().cameraProperty().get(), preview().viewport(), 40);
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
        PreviewCamera before = model().previewLook().cameraProperty().get();
        dragHolding(KeyCode.SHIFT, inPreview(Vec3.ZERO), 3, -60);
        assertThat(model().previewLook().cameraProperty().get().distance()).isLessThan(before.distance());
        click("view-z");
        assertThat(model().previewLook().cameraProperty().get()).isEqualTo(before);
    }

    @Test
    void shiftDragRight_pansTheScene() {
        double before = inPreview(Vec3.ZERO).getX();
        dragHolding(KeyCode.SHIFT, inPreview(Vec3.ZERO), 50, 2);
        assertThat(inPreview(Vec3.ZERO).getX()).isGreaterThan(before + 40);
    }

    @Test
    void viewButtons_lookAlongTheirAxis() {
        click("view-x");
        assertThat(model().previewLook().cameraProperty().get().forward().x()).isGreaterThan(0.99);
        click("view-y");
        assertThat(model().previewLook().cameraProperty().get().forward().y()).isLessThan(-0.99);
    }

    @Test
    void cameraOfThePreview_neverTouchesThePicture() {
        click("view-x");
        assertThat(isEnabled(Command.GO)).isFalse();
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    @Test
    void heldArrowKey_turnsTheLightInOneStep() {
        robot.clickOn(inPreview(light("stage").position()));
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
        robot.clickOn(inPreview(light("lamp").position()));
        Light before = light("lamp");
        robot.type(KeyCode.PAGE_UP);
        assertThat(light("lamp").position().z()).isLessThan(before.position().z());
    }

    @Test
    void bracketKeys_selectTheNextLight() {
        robot.clickOn(inPreview(light("lamp").position()));
        robot.type(KeyCode.CLOSE_BRACKET);
        assertThat(model().editor().selection().light().name()).isEqualTo("sun");
        robot.type(KeyCode.OPEN_BRACKET);
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void lightOutOfView_isTakenAtItsMarker() {
        robot.interact(() -> model().previewLook().cameraProperty().set(
                model().previewLook().cameraProperty().get().panned(-400, 0, preview().viewport())));
        assertThat(LightMarker.of(model().editor().scene().lights(), model().previewLook().cameraProperty().get(), preview().viewport()))
                .hasSize(3);
        var marker = LightMarker.of(model().editor().scene().lights(), model().previewLook().cameraProperty().get(), preview().viewport())
                .getLast();
        robot.clickOn(preview().onScreen(marker.at()));
        assertThat(model().editor().selection().light()).isIn(model().editor().scene().lights());
        click("view-all");
        assertThat(LightMarker.of(model().editor().scene().lights(), model().previewLook().cameraProperty().get(), preview().viewport()))
                .isEmpty();
    }

    @Test
    void hiddenGizmo_isNeitherTakenNorSelected() {
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        click("hide-gizmos");
        Light lamp = light("lamp");
        robot.clickOn(inPreview(lamp.position()));
        drag(lamp, MouseButton.SECONDARY, 30, 20);
        assertThat(model().editor().selection().light().name()).isEqualTo("stage");
        assertThat(light("lamp")).isEqualTo(lamp);
        assertThat(isEnabled(Command.UNDO)).isFalse();
        click("hide-gizmos");
        robot.clickOn(inPreview(lamp.position()));
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void hiddenMarker_isNotTaken() {
        robot.interact(() -> model().previewLook().cameraProperty().set(
                model().previewLook().cameraProperty().get().panned(-400, 0, preview().viewport())));
        var marker = LightMarker.of(model().editor().scene().lights(), model().previewLook().cameraProperty().get(), preview().viewport())
                .getLast();
        robot.interact(() -> {
            model().editor().selection().selectLight("lamp");
            preview().requestFocus();
        });
        robot.type(KeyCode.G);
        assertThat(model().previewLook().gizmosHiddenProperty().get()).isTrue();
        robot.clickOn(preview().onScreen(marker.at()));
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void largeGizmo_isTakenWhereItIsDrawn() {
        // The sphere of a point light has a radius of 12 pixels, 19.2 where it is large; a click may be 8 beside it.
        Point2D rim = inPreview(light("lamp").position()).add(0, -24);
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        robot.clickOn(rim);
        assertThat(model().editor().selection().light().name()).isEqualTo("stage");
        robot.interact(() -> model().previewLook().sizeProperty().set(GizmoSize.LARGE));
        robot.clickOn(rim);
        assertThat(model().editor().selection().light().name()).isEqualTo("lamp");
    }

    @Test
    void openedScene_isFirstSeenWithAllItsLights() throws Exception {
        PreviewCamera own = PreviewCamera.of(model().editor().scene());
        assertThat(model().previewLook().cameraProperty().get()).as("all lights are in view").isEqualTo(own);
        String text = Files.readString(folder.resolve("desk.jen")).replace("at -2 2.2 0.5", "at -2 6.2 0.5");
        Path other = Files.writeString(folder.resolve("high.jen"), text);
        robot.interact(() -> editor.files().load(other));
        waitFor("the scene is open", () -> model().editor().document().name().equals("high.jen"));
        waitForPicture();
        assertThat(model().previewLook().cameraProperty().get().distance()).isGreaterThan(own.distance());
        assertThat(LightMarker.of(model().editor().scene().lights(), model().previewLook().cameraProperty().get(), preview().viewport()))
                .isEmpty();
        assertThat(model().picture().frame().scene().camera()).as("of the traced picture").isEqualTo(model().editor().scene().camera());
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    @Test
    void edit_leavesTheViewAsItIs() {
        PreviewCamera before = model().previewLook().cameraProperty().get();
        robot.interact(() -> model().editor().edit(scene -> LightEdits.with(scene, "lamp", l -> l.withPosition(new Vec3(0, 50, 0)))));
        QuickRobot.settle();
        assertThat(model().previewLook().cameraProperty().get()).isEqualTo(before);
    }

    private NodeGizmo.Handle handle(NodeGizmo of, NodeGizmo.Act act, int axis) {
        return of.handles().stream().filter(h -> h.act() == act && h.axis() == axis).findFirst().orElseThrow();
    }

    @Test
    void clickOnAShape_selectsItAndAnArrowMovesIt() {
        robot.clickOn(inPreview(new Vec3(0, 0.6, 0)));
        waitFor("it is selected", () -> model().editor().selection().node().isPresent());
        Node ball = model().editor().selection().node().orElseThrow();
        assertThat(ball.name()).isEqualTo("ball");
        PreviewCamera view = model().previewLook().cameraProperty().get();
        NodeGizmo gizmo = NodeGizmo.of(model().editor().scene(), ball, view, preview().viewport()).orElseThrow();
        Vec3 tip = handle(gizmo, NodeGizmo.Act.MOVE, 1).lines().getFirst().to();
        Point2D from = inPreview(tip);
        robot.moveTo(from);
        robot.press(MouseButton.PRIMARY);
        robot.moveTo(from.add(0, -20));
        robot.moveTo(inPreview(tip.plus(new Vec3(0, 0.5, 0))));
        robot.release(MouseButton.PRIMARY);
        Vec3 at = model().editor().selection().node().orElseThrow().placement().at();
        assertThat(at.x()).isZero();
        assertThat(at.z()).isZero();
        assertThat(at.y()).isBetween(1.4, 1.6);
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().selection().node()).as("all of the drag was one step").contains(ball);
    }
}
