package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.base.math.Vec3;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.TextTyping;
import lightning.scene.Scene;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class OutlinePaneTest extends EditorFixture {
    private static final Vec3 BALL = new Vec3(0, 1, 0);

    private SceneNode node(String name) {
        return model().editor().scene().stage().node(name).orElseThrow();
    }

    private String tab(String pane) {
        return robot.lookup("#" + pane).<TabPane>query().getSelectionModel().getSelectedItem().getId();
    }

    private ListView<OutlineRow> list() {
        return robot.lookup("#shape-list").query();
    }

    private List<String> listedNames() {
        return list().getItems().stream().map(row -> row.node(model().editor().scene().stage()).name()).toList();
    }

    private String selectedName() {
        OutlineRow row = list().getSelectionModel().getSelectedItem();
        return row == null ? "" : row.node(model().editor().scene().stage()).name();
    }

    private void select(String name) {
        robot.interact(() -> model().editor().selection().selectNode(name));
        // The row exists only after layout.
        waitFor("the row is laid out", () -> robot.lookup("#shape-list .list-cell").queryAllAs(ListCell.class).stream()
                .anyMatch(cell -> cell.isSelected() && cell.getGraphic() != null && name.equals(selectedName())));
    }

    private void press(KeyCode... keys) {
        robot.interact(() -> list().requestFocus());
        waitFor("the list has focus", () -> list().isFocused());
        robot.push(keys);
    }

    private void group() {
        robot.interact(() -> model().editor().edit(scene -> new lightning.document.EditOutcome.Applied(scene.replaceNode("ball",
                List.of(new NodeGroup("toys", Placement.IDENTITY, List.of(node("ball"),
                        new Shape(new Solid.Sphere(), "marble", "matt", new Placement(new Vec3(1, 0.3, 1), Vec3.ZERO,
                                new Vec3(0.3, 0.3, 0.3))))))))));
    }

    @Test
    void shapePickedInPreview_isSelectedInList() {
        assertThat(tab("lists")).isEqualTo("lights-tab");
        waitFor("the preview is drawn", () -> model().previewSettings().framesProperty().get() > 0);
        robot.clickOn(toScreen(BALL), MouseButton.SECONDARY);
        waitFor("the menu is open", () -> robot.lookup("Select ball").tryQuery().isPresent());
        robot.clickOn("Select ball");
        waitFor("the shape is selected", () -> tab("lists").equals("shapes-tab"));
        assertThat(selectedName()).isEqualTo("ball");
        assertThat(tab("side")).isEqualTo("shape-tab");
        assertThat(text("shape-about")).isEqualTo("Sphere, material matt");
        assertThat(model().editor().selection().light()).isNull();
    }

    @Test
    void lightSelection_showsLightList() {
        select("ball");
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        assertThat(tab("lists")).isEqualTo("lights-tab");
        assertThat(tab("side")).isEqualTo("light-tab");
        assertThat(model().editor().selection().node()).isEmpty();
    }

    @Test
    void eye_hidesShapeAndUndoShowsIt() {
        Scene before = model().editor().scene();
        select("ball");
        ToggleButton eye = robot.lookup("#shape-list .eye").queryAllAs(ToggleButton.class).stream()
                .filter(b -> "ball visible".equals(b.getAccessibleText())).findFirst().orElseThrow();
        robot.interact(eye::fire);
        assertThat(node("ball").visible()).isFalse();
        assertGoShowsTheScene();
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("ball: visible yes → no");
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void keyH_hidesAndShows() {
        select("ball");
        press(KeyCode.H);
        assertThat(node("ball").visible()).isFalse();
        robot.interact(() -> preview().requestFocus());
        waitFor("the preview has focus", () -> preview().isFocused());
        robot.push(KeyCode.H);
        assertThat(node("ball").visible()).isTrue();
    }

    @Test
    void delete_removesShapeAndKeepsLights() {
        select("ball");
        press(KeyCode.DELETE);
        assertThat(model().editor().scene().stage().node("ball")).isEmpty();
        assertThat(listedNames()).containsExactly("floor");
        assertThat(model().editor().scene().lights()).hasSize(3);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("delete ball");
        assertGoShowsTheScene();
    }

    @Test
    void duplicate_isOffsetAndSelected() {
        select("ball");
        press(KeyCode.CONTROL, KeyCode.D);
        assertThat(listedNames()).containsExactly("floor", "ball", "ball2");
        assertThat(selectedName()).isEqualTo("ball2");
        assertThat(node("ball2").placement().position()).isEqualTo(new Vec3(0.9, 1, 0));
        assertThat(model().editor().scene().lights()).as("no light was duplicated").hasSize(3);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("add ball2");
        assertGoShowsTheScene();
    }

    @Test
    void duplicatedGroup_hasUniqueNames() {
        group();
        select("toys");
        press(KeyCode.CONTROL, KeyCode.D);
        assertThat(((NodeGroup) node("toys2")).children()).extracting(SceneNode::name).containsExactly("ball2", "marble2");
    }

    @Test
    void renamedShape_staysSelected() {
        select("ball");
        press(KeyCode.F2);
        TextTyping.replace(robot, robot.lookup("#shape-list .text-field").queryAs(TextField.class), "globe").push(KeyCode.ENTER);
        assertThat(selectedName()).isEqualTo("globe");
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("ball: name ball → globe");
    }

    @Test
    void duplicateName_isRefused() {
        select("ball");
        press(KeyCode.F2);
        TextTyping.replace(robot, robot.lookup("#shape-list .text-field").queryAs(TextField.class), "floor").push(KeyCode.ENTER);
        assertThat(model().editor().message().textProperty().get()).contains("'floor'", "already taken");
        assertThat(model().editor().scene().stage().node("ball")).isPresent();
    }

    @Test
    void group_isCollapsedUntilItsShapeIsSelected() {
        group();
        select("floor");
        assertThat(listedNames()).containsExactly("floor", "toys");
        select("marble");
        assertThat(listedNames()).containsExactly("floor", "toys", "ball", "marble");
        assertThat(selectedName()).isEqualTo("marble");
        select("toys");
        press(KeyCode.LEFT);
        assertThat(listedNames()).containsExactly("floor", "toys");
    }

    @Test
    void hiddenGroup_hidesItsShapes() {
        group();
        select("toys");
        press(KeyCode.H);
        assertThat(model().editor().scene().stage().shapes()).extracting(Shape::name).containsExactly("floor");
        assertGoShowsTheScene();
    }

    @Test
    void typedPosition_movesShapeInOneUndoStep() {
        Scene before = model().editor().scene();
        select("ball");
        TextTyping.replace(robot, robot.lookup("#shape-at .number-field").queryAs(TextField.class), "1.5").push(KeyCode.ENTER);
        assertThat(node("ball").placement().position()).isEqualTo(new Vec3(1.5, 1, 0));
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("ball: position 0 1 0 → 1.5 1 0");
        assertGoShowsTheScene();
        click("undo");
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void typedRotationAndScale_setPlacement() {
        select("ball");
        TextTyping.replace(robot, robot.lookup("#rotate-y .number-field").queryAs(TextField.class), "30").push(KeyCode.ENTER);
        TextTyping.replace(robot, robot.lookup("#shape-scale .number-field").queryAs(TextField.class), "2").push(KeyCode.ENTER);
        assertThat(node("ball").placement()).isEqualTo(new Placement(BALL, new Vec3(0, 30, 0), new Vec3(2, 1, 1)));
        assertGoShowsTheScene();
    }

    @Test
    void zeroScale_isRefused() {
        select("ball");
        TextTyping.replace(robot, robot.lookup("#shape-scale .number-field").queryAs(TextField.class), "0").push(KeyCode.ENTER);
        assertThat(robot.lookup(".refusal").queryAll()).anyMatch(n -> n instanceof javafx.scene.control.Label l
                && l.getText().startsWith("scale must be at least"));
        assertThat(node("ball").placement().scale()).isEqualTo(Vec3.ONE);
    }

    @Test
    void savedScene_reopened_isEqual() throws Exception {
        group();
        select("toys");
        press(KeyCode.CONTROL, KeyCode.D);
        press(KeyCode.H);
        select("floor");
        press(KeyCode.DELETE);
        click("save-scene");
        waitFor("the scene is saved", () -> !model().editor().document().isDirty());
        Scene read = lightning.document.OpenDocument.open(folder.resolve("desk.jen")).scene();
        assertThat(read).isEqualTo(model().editor().scene());
    }
}
