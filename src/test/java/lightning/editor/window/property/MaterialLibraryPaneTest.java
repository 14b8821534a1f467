package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Button;
import javafx.scene.control.TitledPane;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.input.MouseButton;
import lightning.base.math.Vec3;
import lightning.document.MaterialLibrary;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.ScreenBounds;
import lightning.editor.window.preview.PreviewCanvas;
import lightning.scene.node.Shape;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Library of materials in the material tab. */
class MaterialLibraryPaneTest extends EditorFixture {
    private static final Vec3 BALL = new Vec3(0, 1, 0);

    private String materialOf(String shape) {
        return ((Shape) model().editor().scene().stage().node(shape).orElseThrow()).material();
    }

    private void openLibrary() {
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        waitFor("the library is there", () -> robot.lookup("#library-section").tryQuery().isPresent());
        robot.interact(() -> robot.lookup("#library-section").<TitledPane>query().setExpanded(true));
        waitFor("its materials are there", () -> robot.lookup("#library-gold").tryQuery().isPresent());
    }

    private Button tile(String material) {
        return robot.lookup("#library-" + material.replace(' ', '-')).queryButton();
    }

    private Point2D center(Node node) {
        Bounds bounds = ScreenBounds.of(node);
        return new Point2D(bounds.getCenterX(), bounds.getCenterY());
    }

    @Test
    void clickedMaterial_isThatOfTheSelectedObject_untilUndo() {
        String before = materialOf("ball");
        robot.interact(() -> model().editor().selection().selectNode("ball"));
        openLibrary();
        robot.clickOn(tile("polished chrome"));
        assertThat(materialOf("ball")).isEqualTo("polished chrome");
        assertThat(model().materials().material().name()).isEqualTo("polished chrome");
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(materialOf("ball")).isEqualTo(before);
        assertThat(model().editor().scene().materialsByName()).doesNotContainKey("polished chrome");
    }

    @Test
    void materialDroppedOnPreview_isThatOfTheObjectThere() {
        PreviewCanvas preview = preview();
        Viewport.Pixel ball = preview.viewport().project(model().previewSettings().cameraProperty().get(), BALL);
        robot.interact(() -> preview.dropMaterial(MaterialLibrary.find("gold").orElseThrow(), ball));
        waitFor("the ball has the material", () -> materialOf("ball").equals("gold"));
        assertThat(materialOf("floor")).isEqualTo("mirror");
    }

    @Test
    void clickWithoutSelectedObject_replacesTheShownMaterial() {
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        robot.interact(() -> model().materials().choose("mirror"));
        openLibrary();
        robot.clickOn(tile("gold"));
        assertThat(materialOf("floor")).isEqualTo("gold");
        assertThat(materialOf("ball")).isEqualTo("matt");
        assertThat(model().materials().material().name()).isEqualTo("gold");
    }

    /** Real drags, which the headless toolkit does not have. */
    @ParameterizedTest
    @ValueSource(strings = {"#preview-canvas", "#traced-picture"})
    @DisabledIfSystemProperty(named = "glass.platform", matches = "Unseen")
    void draggedMaterial_isThatOfTheObjectWhereItEnds(String picture) {
        openLibrary();
        Point2D from = center(tile("gold"));
        Point2D to = picture.equals("#preview-canvas") ? toScreen(BALL) : center(robot.lookup(picture).query());
        robot.moveTo(from).press(MouseButton.PRIMARY).moveTo(from.add(10, 10)).moveTo(to).moveTo(to.add(1, 1)).release(MouseButton.PRIMARY);
        waitFor("the ball has the material", () -> materialOf("ball").equals("gold"));
    }

    @Test
    void pictures_areRenderedInTheBackground() {
        openLibrary();
        waitFor("the first picture is shown", () -> picture("polished chrome") != null);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).isEmpty();
    }

    private @Nullable Image picture(String material) {
        return ((ImageView) ((Parent) tile(material).getGraphic()).getChildrenUnmodifiable().getFirst()).getImage();
    }
}
