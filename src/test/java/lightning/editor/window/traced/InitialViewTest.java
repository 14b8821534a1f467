package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.control.Slider;
import lightning.editor.window.EditorFixture;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import org.junit.jupiter.api.Test;

/** A scene opens with its own view, and without an edit. */
class InitialViewTest extends EditorFixture {
    @Override
    protected String sceneText() {
        return super.sceneText().replace("size 64 48", "size 64 48  view aces2  exposure 1.25");
    }

    @Test
    void view_isThatOfTheScene() {
        assertThat(model().editor().scene().picture().view()).isEqualTo(new ViewSettings(ViewCurve.ACES2, 1.25));
        assertThat(model().picture().viewProperty().get()).isEqualTo(new ViewTransform(1.25, DisplayCurve.ACES2));
        assertThat(robot.lookup("#exposure").queryAs(Slider.class).getValue()).isEqualTo(1.25);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).isEmpty();
    }
}
