package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.document.LightEdits;
import lightning.document.manipulation.PreviewCamera;
import org.junit.jupiter.api.Test;

class LightCameraToggleTest extends EditorFixture {

    private PreviewCamera camera() {
        return model().previewSettings().cameraProperty().get();
    }

    private PreviewCamera lightCamera() {
        return PreviewCamera.throughLight(model().editor().selection().light(), model().editor().scene());
    }

    private boolean isSelected() {
        Set<ToggleButton> eyes = robot.lookup("#look-through-light").queryAllAs(ToggleButton.class);
        assertThat(eyes).hasSize(2);
        assertThat(eyes.stream().map(ToggleButton::isSelected).distinct()).as("both eyes say the same").hasSize(1);
        return eyes.iterator().next().isSelected();
    }

    @Test
    void eyeButton_staysSelectedAndRestoresView() {
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.X);
        PreviewCamera before = camera();
        click("look-through-light");
        assertThat(isSelected()).isTrue();
        assertThat(camera()).isEqualTo(lightCamera());
        click("look-through-light");
        assertThat(isSelected()).isFalse();
        assertThat(camera()).isEqualTo(before);
    }

    @Test
    void view_followsLightAndSelection() {
        click("look-through-light");
        robot.interact(() -> model().editor().edit(scene -> LightEdits.edit(scene, "lamp", l -> l.withPosition(new Vec3(1, 4, 2)))));
        assertThat(camera()).isEqualTo(lightCamera());
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        assertThat(camera()).isEqualTo(lightCamera());
        assertThat(isSelected()).isTrue();
    }

    @Test
    void otherView_endsLookThrough() {
        click("look-through-light");
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.Z);
        assertThat(isSelected()).isFalse();
        PreviewCamera chosen = camera();
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 5)));
        assertThat(camera()).isEqualTo(chosen);
    }
}
