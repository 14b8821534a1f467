package lightning.editor.window.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import javafx.geometry.Point2D;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class LinkPaneTest extends EditorFixture {

    @BeforeEach
    void open() {
        robot.interact(() -> model().commands().run(Command.LIGHT_LINKS));
        waitFor("the matrix is shown", () -> robot.lookup("#link-matrix").tryQuery().isPresent() && matrix().getWidth() > 0
                && !matrix().isEmpty());
    }

    private LinkMatrix matrix() {
        return robot.lookup("#link-matrix").query();
    }

    private int row(String name) {
        return IntStream.range(0, matrix().table().rows().size()).filter(i -> matrix().table().rows().get(i).name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private int column(String name) {
        return IntStream.range(0, matrix().table().lights().size())
                .filter(i -> matrix().table().lights().get(i).name().equals(name)).findFirst().orElseThrow();
    }

    /** Returns the center of a cell on the screen. */
    private Point2D cell(String light, String object) {
        robot.interact(() -> matrix().setCurrent(row(object), column(light)));
        LinkCell cell = matrix().currentCell();
        return cell.localToScreen(cell.getWidth() / 2, cell.getHeight() / 2);
    }

    private ShapeGains gains(String light) {
        return light(light).influence().gains();
    }

    private String undoLabel() {
        return model().editor().editorStateProperty().get().undoLabel().orElse("");
    }

    @Test
    void click_togglesLink_andIsNamed() {
        robot.moveTo(cell("lamp", "ball")).press(MouseButton.PRIMARY).release(MouseButton.PRIMARY);
        assertThat(light("lamp").illuminates()).isEqualTo(ShapeLinks.except("ball"));
        assertThat(undoLabel()).isEqualTo("Unlink lamp from ball");
        robot.moveTo(cell("lamp", "ball")).press(MouseButton.PRIMARY).release(MouseButton.PRIMARY);
        assertThat(light("lamp").illuminates()).isEqualTo(ShapeLinks.ALL);
    }

    @Test
    void drag_changesGain_asOneUndoStep() {
        robot.moveTo(cell("lamp", "ball")).press(MouseButton.PRIMARY).moveBy(-20, 0).moveBy(-20, 0).release(MouseButton.PRIMARY);
        assertThat(gains("lamp").get("ball").orElseThrow()).isBetween(0.5, 0.7);
        assertThat(undoLabel()).isEqualTo("Gain of lamp on ball");
        assertThat(text("link-status")).startsWith("lamp on ball: ");
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(gains("lamp")).isEqualTo(ShapeGains.NONE);
    }

    @Test
    void typedPercentage_isSet_andDeleteResetsIt() {
        robot.interact(() -> {
            matrix().requestFocus();
            matrix().setCurrent(row("ball"), column("lamp"));
        });
        robot.push(KeyCode.ENTER);
        robot.interact(() -> {
            TextField field = robot.lookup("#link-gain").query();
            field.setText("30 %");
            field.fireEvent(new javafx.event.ActionEvent());
        });
        assertThat(gains("lamp")).isEqualTo(ShapeGains.of("ball", 0.3));
        robot.push(KeyCode.DELETE);
        assertThat(gains("lamp")).isEqualTo(ShapeGains.NONE);
        robot.push(KeyCode.SPACE);
        assertThat(light("lamp").illuminates()).isEqualTo(ShapeLinks.except("ball"));
    }

    @Test
    void typedPercentage_isSetAndDescribed_whenAnotherCellIsClicked() {
        robot.interact(() -> {
            matrix().requestFocus();
            matrix().setCurrent(row("ball"), column("lamp"));
        });
        robot.push(KeyCode.ENTER);
        robot.interact(() -> {
            TextField field = robot.lookup("#link-gain").query();
            field.setText("30");
            matrix().requestFocus();
        });
        assertThat(gains("lamp")).isEqualTo(ShapeGains.of("ball", 0.3));
        assertThat(text("link-status")).isEqualTo("lamp on ball: 30 %");
    }

    @Test
    void escape_leavesGainAsItIs() {
        robot.interact(() -> {
            matrix().requestFocus();
            matrix().setCurrent(row("ball"), column("lamp"));
        });
        robot.push(KeyCode.DIGIT3, KeyCode.ESCAPE);
        assertThat(gains("lamp")).isEqualTo(ShapeGains.NONE);
    }

    @Test
    void matrix_opensAtSelectedLight() {
        robot.interact(() -> matrix().getScene().getWindow().hide());
        robot.interact(() -> {
            model().editor().edit(scene -> EditOutcome.of(() -> scene
                    .withLights(IntStream.range(0, 60).mapToObj(i -> Light.of("light " + i, LightType.POINT)).toList())));
            model().editor().selection().selectLight("light 41");
            model().commands().run(Command.LIGHT_LINKS);
        });
        waitFor("the selected light is current", () -> robot.lookup("#link-matrix").tryQuery().isPresent() && !matrix().isEmpty()
                && matrix().currentLight().name().equals("light 41"));
        assertThat(matrix().currentCell()).as("a visible cell").isNotNull();
    }

    /** 30 lights and 200 objects: only visible cells have nodes, and the last one is reachable. */
    @Test
    void largeMatrix_hasNodesOfVisibleCellsOnly() {
        robot.interact(() -> model().editor().edit(scene -> EditOutcome.of(() -> scene
                .withNodes(IntStream.range(0, 200).<SceneNode>mapToObj(
                        i -> new Shape(Solid.SPHERE, "object " + i, Material.DEFAULT.name(), Placement.IDENTITY)).toList())
                .withLights(IntStream.range(0, 30).mapToObj(i -> Light.of("light " + i, LightType.POINT)).toList()))));
        waitFor("all rows are in the table", () -> matrix().table().rows().size() == 200);
        robot.interact(() -> matrix().layout());
        assertThat(robot.lookup(".link-cell").queryAll()).hasSizeBetween(20, 1500);
        robot.moveTo(cell("light 29", "object 199")).press(MouseButton.PRIMARY).release(MouseButton.PRIMARY);
        assertThat(light("light 29").illuminates()).isEqualTo(ShapeLinks.except("object 199"));
        assertThat(List.of(text("link-note"))).containsExactly("30 lights, 200 objects");
    }
}
