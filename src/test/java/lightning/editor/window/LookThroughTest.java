package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import lightning.base.math.Vec3;
import lightning.editor.document.Desk;
import lightning.editor.document.LightEdits;
import lightning.editor.document.PreviewCamera;
import org.junit.jupiter.api.Test;

class LookThroughTest extends EditorDesk {

    private PreviewCamera camera() {
        return model().previewLook().cameraProperty().get();
    }

    private PreviewCamera ofLight() {
        return PreviewCamera.through(model().editor().selection().light(), model().editor().scene());
    }

    private boolean isDown() {
        Set<ToggleButton> eyes = robot.lookup("#look-through-light").queryAllAs(ToggleButton.class);
        assertThat(eyes).hasSize(2);
        assertThat(eyes.stream().map(ToggleButton::isSelected).distinct()).as("both eyes say the same").hasSize(1);
        return eyes.iterator().next().isSelected();
    }

    @Test
    void eye_staysDownAndBringsTheOldViewBack() {
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.X);
        PreviewCamera before = camera();
        click("look-through-light");
        assertThat(isDown()).isTrue();
        assertThat(camera()).isEqualTo(ofLight());
        click("look-through-light");
        assertThat(isDown()).isFalse();
        assertThat(camera()).isEqualTo(before);
    }

    @Test
    void view_followsTheLightAndTheSelection() {
        click("look-through-light");
        robot.interact(() -> model().editor().edit(scene -> LightEdits.with(scene, "lamp", l -> l.withPosition(new Vec3(1, 4, 2)))));
        assertThat(camera()).isEqualTo(ofLight());
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        assertThat(camera()).isEqualTo(ofLight());
        assertThat(isDown()).isTrue();
    }

    @Test
    void anotherView_endsIt() {
        click("look-through-light");
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.Z);
        assertThat(isDown()).isFalse();
        PreviewCamera chosen = camera();
        robot.interact(() -> model().editor().edit(scene -> Desk.dial("intensity").set(scene, "lamp", 5)));
        assertThat(camera()).isEqualTo(chosen);
    }
}
