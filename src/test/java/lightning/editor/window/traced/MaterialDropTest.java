package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.geometry.Bounds;
import lightning.document.MaterialLibrary;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.widget.PictureView;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import org.junit.jupiter.api.Test;

/** Materials of the library that are dropped on the traced picture. */
class MaterialDropTest extends EditorFixture {
    private final Material gold = MaterialLibrary.find("gold").orElseThrow();

    private String materialOf(String shape) {
        return ((Shape) model().editor().scene().stage().node(shape).orElseThrow()).material();
    }

    /** @param x place in the picture, 0 … 1 from the left; see also {@code y} */
    private void drop(double x, double y) {
        robot.interact(() -> {
            TracedPane pane = robot.lookup("#traced").query();
            Bounds bounds = robot.lookup("#traced-picture").<PictureView>query().pictureBoundsProperty().getValue();
            pane.mouse().dropMaterial(model().materials(), gold, bounds.getMinX() + x * bounds.getWidth(),
                    bounds.getMinY() + y * bounds.getHeight());
        });
    }

    @Test
    void droppedMaterial_isThatOfTheObjectThere() {
        drop(0.5, 0.5);
        waitFor("the ball has the material", () -> materialOf("ball").equals("gold"));
        assertThat(materialOf("floor")).isEqualTo("mirror");
    }

    @Test
    void materialDroppedOnTheBackground_changesNothing() {
        var before = model().editor().scene();
        drop(0.02, 0.02);
        waitFor("a message says why", () -> model().editor().message().textProperty().get().equals("No object here"));
        assertThat(model().editor().scene()).isEqualTo(before);
    }
}
