package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import lightning.document.DeskScene;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.effects.RenderEffect;
import org.junit.jupiter.api.Test;

@OwnEditor
class EffectsPaneTest extends EditorFixture {

    private boolean isListed(String id) {
        return robot.lookup("#" + id).tryQuery().isPresent();
    }

    @Test
    void effects_listTheirUsers() {
        robot.push(KeyCode.SHIFT, KeyCode.F9);
        assertThat(text("effects-summary")).startsWith("desk.jen uses ");
        assertThat(isListed("effect-reflection")).isTrue();
        assertThat(robot.lookup("up to 2 bounces: mirror").tryQuery()).isPresent();
        assertThat(isListed("effect-textures")).isFalse();
        assertThat(text("effects-absent")).contains("textures").contains("cylinders").doesNotContain("spheres");
    }

    @Test
    void editRemovingEffect_removesItFromList() {
        robot.push(KeyCode.SHIFT, KeyCode.F9);
        assertThat(isListed("effect-spot-cone")).isTrue();
        robot.interact(() -> model().editor().edit(scene -> lightning.document.LightEdits.delete(scene, "stage")));
        assertThat(isListed("effect-spot-cone")).isFalse();
    }

    @Test
    void hiddenEffect_affectsOnlyViewUntilShowAll() {
        robot.push(KeyCode.SHIFT, KeyCode.F9);
        assertThat(robot.lookup("#show-all-effects").<Node>query().isDisabled()).isTrue();
        click("effect-specular");
        waitFor("the effect is hidden", () -> isShown("look"));
        assertThat(text("look")).isEqualTo("View: No specular highlights");
        assertCanvasShows(new ReferenceTracer(model().pictureDisplay().effectsProperty().get().apply(model().editor().scene())).trace());
        assertThat(model().pictureDisplay().effectsProperty().get().shows(RenderEffect.SPECULAR)).isFalse();
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertThat(isEnabled(Command.GO)).isFalse();
        click("show-all-effects");
        waitFor("all effects are shown", () -> !isShown("look"));
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
    }

    private EffectRow row(String id) {
        return (EffectRow) robot.lookup("#" + id).query().getParent();
    }

    private void openAndMeasure() {
        robot.push(KeyCode.SHIFT, KeyCode.F9);
        click("measure-effects");
        waitFor("the measurement is finished", () -> text("effects-outcome").startsWith("Full render"));
    }

    @Test
    void measuredEffects_inUse_showCost() {
        openAndMeasure();
        assertThat(text("effects-outcome")).contains("lamp: full recompute");
        // No separate layers: only the states of tiles in partial shadow, a byte per row.
        assertThat(text("bytes-shadows")).matches("[1-9][0-9]* B");
        assertThat(text("bytes-reflection")).matches("[0-9.]+ [kM]?B").isNotEqualTo("0 B");
        assertThat(text("first-reflection")).endsWith(" ms");
        assertThat(text("update-shadows")).endsWith(" ms");
    }

    @Test
    void measuredEffects_absent_showSavings() {
        openAndMeasure();
        assertThat(row("bytes-textures").getChildren().getFirst()).isNotInstanceOf(javafx.scene.control.CheckBox.class);
        assertThat(text("bytes-textures")).endsWith("kB");
        assertThat(text("bytes-cylinders")).isEqualTo("–");
    }

    @Test
    void lastEdit_isMeasured() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
        openAndMeasure();
        assertThat(text("effects-outcome")).contains("lamp: weight");
        assertThat(isEnabled(Command.GO)).as("document and picture are unchanged").isTrue();
    }

    @Test
    void edit_afterMeasurement_marksCostsOutdated() {
        openAndMeasure();
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
        assertThat(text("effects-outcome")).startsWith("Before the last edits: Full render");
    }

    @Test
    void editRemovingEffect_isNotMeasured() {
        robot.interact(() -> model().editor().edit(scene -> lightning.document.LightEdits.delete(scene, "stage")));
        openAndMeasure();
        assertThat(text("effects-outcome")).contains("lamp: full recompute");
    }

    @Test
    void canceledMeasurement_showsNothing() {
        robot.push(KeyCode.SHIFT, KeyCode.F9);
        // In one runnable: a fast machine would finish measuring before a second click.
        robot.interact(() -> {
            robot.lookup("#measure-effects").queryButton().fire();
            robot.lookup("#cancel-measure-effects").queryButton().fire();
        });
        waitFor("the measurement is canceled", () -> text("effects-outcome").equals("Canceled"));
        assertThat(isShown("bytes-shadows")).isFalse();
    }
}
