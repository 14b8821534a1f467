package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class SamplingMenuTest extends EditorFixture {

    private MenuButton sizes() {
        return robot.lookup("#traced-sizes").query();
    }

    private MenuItem item(String id) {
        Menu menu = (Menu) sizes().getItems().stream().filter(i -> "antialias".equals(i.getId())).findFirst().orElseThrow();
        return menu.getItems().stream().filter(i -> id.equals(i.getId())).findFirst().orElseThrow();
    }

    private void choose(String id) {
        robot.interact(item(id)::fire);
    }

    private SamplingSettings sampling() {
        return model().editor().scene().picture().sampling();
    }

    @Test
    void edges_afterGo_matchReference() {
        Scene before = model().editor().scene();
        choose("antialias-edges");
        assertThat(sampling()).isEqualTo(new SamplingSettings(AntialiasMode.EDGES, 4));
        assertCanvasShows(new ReferenceTracer(before).trace());
        click("go");
        waitForPicture();
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        assertThat(model().picture().frame().film().hasSameBits(new ReferenceTracer(before).trace())).isFalse();
        assertThat(telemetry()).startsWith("samples");
    }

    @Test
    void fewerSamples_matchReference() {
        choose("antialias-every");
        choose("antialias-2");
        click("go");
        waitForPicture();
        assertThat(model().picture().frame().scene().picture().sampling()).isEqualTo(new SamplingSettings(AntialiasMode.EVERY, 2));
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
    }

    /** The German noun was in lower case. */
    @Test
    void choice_isATextOfItsOwnInEachLanguage() {
        Messages.setLanguage(Language.GERMAN);
        try {
            assertThat(SamplingMenu.text(model().editor().scene().withPicture(
                    model().editor().scene().picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 4)))))
                    .isEqualTo(", Kanten 4 × 4");
        } finally {
            Messages.setLanguage(Language.ENGLISH);
        }
    }

    @Test
    void choice_isShownAndUndone() {
        assertThat(sizes().getText()).isEqualTo("64 × 48");
        choose("antialias-edges");
        assertThat(sizes().getText()).isEqualTo("64 × 48, edges 4 × 4");
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("anti-aliasing off 4 × 4 → edges 4 × 4");
        click("undo");
        assertThat(sampling()).isEqualTo(SamplingSettings.DEFAULT);
        assertThat(isEnabled(Command.GO)).isFalse();
    }

    @Test
    void sampleCount_isEnabledWithAntialiasing() {
        assertThat(item("antialias-8").isDisable()).isTrue();
        choose("antialias-edges");
        assertThat(item("antialias-8").isDisable()).isFalse();
    }
}
