package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.Node;
import javafx.scene.control.Label;
import lightning.edit.Command;
import lightning.edit.Dial;
import lightning.effects.Effect;
import lightning.shading.ReferenceTracer;
import org.junit.jupiter.api.Test;

class EffectsPaneTest extends EditorDesk {

    private boolean isListed(String id) {
        return robot.lookup("#" + id).tryQuery().isPresent();
    }

    @Test
    void effects_areToldWithWhoCallsForThem() {
        click("effects-panel");
        assertThat(text("effects-summary")).startsWith("desk.jen calls for ");
        assertThat(isListed("effect-reflection")).isTrue();
        assertThat(robot.lookup("up to 2 bounces: mirror").tryQuery()).isPresent();
        assertThat(isListed("effect-textures")).isFalse();
        assertThat(text("effects-absent")).contains("textures").contains("cylinders").doesNotContain("spheres");
    }

    @Test
    void measured_everyEffectTellsWhatItTakesAndTheAbsentOnesWhatTheySave() {
        robot.interact(() -> model().edit(scene -> Dial.INTENSITY.set(scene, "lamp", 0.25)));
        click("effects-panel");
        assertThat(robot.lookup("#cancel-effects").<Node>query().isDisabled()).isTrue();
        click("measure-effects");
        waitFor("it is measured", () -> text("effects-summary").contains("update (lamp: weight)"));
        assertThat(robot.lookup(n -> n instanceof Label l && l.getText().matches(".* of the first pass, .* ms of the update, .* [kM]B"))
                .queryAll()).hasSizeGreaterThanOrEqualTo(8);
        assertThat(text("effects-absent")).contains("textures would take ");
    }

    @Test
    void editThatEndsAnEffect_takesItFromTheList() {
        click("effects-panel");
        assertThat(isListed("effect-spot-cone")).isTrue();
        robot.interact(() -> model().edit(scene -> lightning.edit.LightEdits.delete(scene, "stage")));
        assertThat(isListed("effect-spot-cone")).isFalse();
    }

    @Test
    void hiddenEffect_isGoneFromTheViewAloneUntilAllIsShown() {
        click("effects-panel");
        assertThat(robot.lookup("#show-all-effects").<Node>query().isDisabled()).isTrue();
        click("effect-specular");
        waitFor("it is hidden", () -> isShown("look"));
        assertThat(text("look")).isEqualTo("View: No specular highlights");
        assertCanvasShows(new ReferenceTracer(model().look().effectsProperty().get().of(model().scene())).trace());
        assertThat(model().look().effectsProperty().get().shows(Effect.SPECULAR)).isFalse();
        assertFilmIs(new ReferenceTracer(model().scene()).trace());
        assertThat(isEnabled(Command.GO)).isFalse();
        click("show-all-effects");
        waitFor("all is shown", () -> !isShown("look"));
        assertCanvasShows(new ReferenceTracer(model().scene()).trace());
    }
}
