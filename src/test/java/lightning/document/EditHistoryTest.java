package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.sample.EditSession;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;
import lightning.scene.light.Light;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class EditHistoryTest {
    private final Scene scene = DeskScene.scene();
    private final EditHistory history = new EditHistory(scene);

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    private void set(AttributeNumber<?, ?> parameter, String light, double value) {
        history.edit(DeskScene.sceneOf(parameter.set(history.scene(), light, value)));
    }

    @Test
    void newHistory_hasNothingToUndo() {
        assertThat(history.undoLabel()).isEmpty();
        assertThat(history.redoLabel()).isEmpty();
        history.undo();
        history.redo();
        assertThat(history.scene()).isSameAs(scene);
    }

    @Test
    void step_isLabeledWithChange() {
        set(DeskScene.parameter("intensity"), "key", 1.2);
        assertThat(history.undoLabel()).contains("key: intensity 1 → 1.2");
        history.undo();
        assertThat(history.redoLabel()).contains("key: intensity 1 → 1.2");
    }

    @Test
    void goTo_undoesOrRedoesSteps() {
        set(DeskScene.parameter("intensity"), "key", 1.2);
        Scene one = history.scene();
        set(AttributeNumber.AMBIENCE, "", 0.5);
        Scene two = history.scene();
        assertThat(history.steps()).containsExactly("key: intensity 1 → 1.2", "ambient light 1 → 0.5");
        history.goTo(0);
        assertThat(history.scene()).isEqualTo(scene);
        history.goTo(1);
        assertThat(history.scene()).isEqualTo(one);
        assertThat(history.position()).isEqualTo(1);
        history.goTo(9);
        assertThat(history.scene()).isEqualTo(two);
        assertThat(history.steps()).containsExactly("key: intensity 1 → 1.2", "ambient light 1 → 0.5");
    }

    @Test
    void goToLightStep_isOneStepAndKeepsOtherLights() {
        set(DeskScene.parameter("intensity"), "key", 1.2);
        set(DeskScene.parameter("intensity"), "key", 1.4);
        set(AttributeNumber.AMBIENCE, "", 0.5);
        long key = history.id("key");
        Scene before = history.scene();
        assertThat(history.goToLightStep(key, 0).refusal()).isEmpty();
        assertThat(DeskScene.light(history.scene(), "key")).isEqualTo(DeskScene.light(scene, "key"));
        assertThat(history.scene().world().ambience()).isEqualTo(0.5);
        assertThat(history.lightSteps(key)).containsExactly("key: intensity 1 → 1.2", "key: intensity 1.2 → 1.4");
        assertThat(history.lightPosition(key)).isZero();
        history.undo();
        assertThat(history.scene()).isEqualTo(before);
        assertThat(history.goToLightStep(key, 3).refusal()).isPresent();
    }

    @Test
    void labels_nameEveryKindOfEdit() {
        assertThat(label(LightEdits.delete(scene, "sun"))).isEqualTo("delete sun");
        assertThat(label(LightEdits.duplicate(scene, "key"))).isEqualTo("add key2");
        assertThat(label(LightEdits.rename(scene, "key", "rim"))).isEqualTo("key: name key → rim");
        assertThat(label(LightEdits.setOn(scene, "sun", false))).isEqualTo("sun: on yes → no");
        assertThat(label(LightEdits.pasteSettings(scene, "fill", DeskScene.light(scene, "sun"))))
                .isEqualTo("fill: type, intensity, attenuation");
        assertThat(label(AttributeNumber.AMBIENCE.set(scene, "", 0.5))).isEqualTo("ambient light 1 → 0.5");
        assertThat(label(AttributeNumber.DEPTH.set(scene, "", 3))).isEqualTo("reflection bounces 2 → 3");
    }

    @Test
    void indirectLight_isUndoneAndRedone() {
        Scene indirect = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        history.edit(indirect);
        history.edit(indirect.withPicture(indirect.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT.withRays(256)))));
        assertThat(history.undoLabel()).contains("indirect rays 64 → 256");
        history.undo();
        assertThat(history.scene()).isEqualTo(indirect);
        assertThat(history.undoLabel()).contains("indirect light off → 2 bounces, 64 rays, every 8 pixels");
        history.undo();
        assertThat(history.scene()).isEqualTo(scene);
        history.redo();
        assertThat(history.scene()).isEqualTo(indirect);
    }

    private String label(EditOutcome change) {
        return SceneDiff.summarize(scene, DeskScene.sceneOf(change));
    }

    @Test
    void equalScene_isNoStep() {
        history.edit(scene.withLights(List.copyOf(scene.lights())));
        assertThat(history.undoLabel()).isEmpty();
    }

    @Test
    void newEdit_clearsRedo() {
        set(DeskScene.parameter("intensity"), "key", 2);
        history.undo();
        set(DeskScene.parameter("intensity"), "key", 3);
        assertThat(history.redoLabel()).isEmpty();
    }

    @Test
    void drag_isOneStep() {
        Object drag = new Object();
        for (double v : new double[] {1.1, 1.5, 2}) {
            history.edit(DeskScene.sceneOf(DeskScene.parameter("intensity").set(history.scene(), "key", v)), drag);
        }
        assertThat(history.undoLabel()).contains("key: intensity 1 → 2");
        history.undo();
        assertThat(history.scene()).isEqualTo(scene);
        assertThat(history.undoLabel()).isEmpty();
    }

    @Test
    void dragBackToStart_leavesNoStep() {
        Object drag = new Object();
        history.edit(DeskScene.sceneOf(DeskScene.parameter("intensity").set(scene, "key", 4)), drag);
        history.edit(scene, drag);
        assertThat(history.undoLabel()).isEmpty();
        assertThat(history.undoLabel(history.id("key"))).isEmpty();
    }

    @Test
    void twoDrags_areTwoSteps() {
        history.edit(DeskScene.sceneOf(DeskScene.parameter("intensity").set(scene, "key", 4)), new Object());
        history.edit(DeskScene.sceneOf(DeskScene.parameter("intensity").set(scene, "key", 5)), new Object());
        history.undo();
        assertThat(DeskScene.light(history.scene(), "key").intensity()).isEqualTo(4);
    }

    @Test
    void dragContinuedAfterUndo_isNewStep() {
        Object drag = new Object();
        set(DeskScene.parameter("intensity"), "fill", 3);
        history.edit(DeskScene.sceneOf(DeskScene.parameter("intensity").set(history.scene(), "key", 4)), drag);
        history.undo();
        history.edit(DeskScene.sceneOf(DeskScene.parameter("intensity").set(history.scene(), "key", 5)), drag);
        history.undo();
        assertThat(DeskScene.light(history.scene(), "fill").intensity()).isEqualTo(3);
    }

    @Test
    void undoLight_keepsLaterEditsOfOthers() {
        set(DeskScene.parameter("intensity"), "key", 2);
        set(DeskScene.parameter("intensity"), "fill", 3);
        assertThat(history.undoLabel(history.id("key"))).contains("key: intensity 1 → 2");
        history.undoLight(history.id("key"));
        assertThat(DeskScene.light(history.scene(), "key").intensity()).isEqualTo(1);
        assertThat(DeskScene.light(history.scene(), "fill").intensity()).isEqualTo(3);
    }

    @Test
    void redoLight_restoresItsEdit() {
        set(DeskScene.parameter("intensity"), "key", 2);
        set(DeskScene.parameter("intensity"), "fill", 3);
        Scene before = history.scene();
        history.undoLight(history.id("key"));
        assertThat(history.redoLabel(history.id("key"))).contains("key: intensity 1 → 2");
        history.redoLight(history.id("key"));
        assertThat(history.scene()).isEqualTo(before);
    }

    @Test
    void undoLight_isADocumentStep() {
        set(DeskScene.parameter("intensity"), "key", 2);
        set(DeskScene.parameter("intensity"), "fill", 3);
        Scene before = history.scene();
        history.undoLight(history.id("key"));
        assertThat(history.undoLabel()).contains("undo key: intensity 1 → 2");
        history.undo();
        assertThat(history.scene()).isEqualTo(before);
        assertThat(history.undoLabel(history.id("key"))).contains("key: intensity 1 → 2");
    }

    @Test
    void lightWithoutEdits_hasNothingToUndo() {
        set(DeskScene.parameter("intensity"), "key", 2);
        assertThat(history.undoLabel(history.id("fill"))).isEmpty();
        assertThat(history.undoLight(history.id("fill")).refusal()).contains("nothing to undo for this light");
        assertThat(history.redoLight(history.id("key")).refusal()).contains("nothing to redo for this light");
    }

    @Test
    void lightHistory_survivesRenames() {
        set(DeskScene.parameter("intensity"), "key", 2);
        history.edit(DeskScene.sceneOf(LightEdits.rename(history.scene(), "key", "rim")));
        history.undoLight(history.id("rim"));
        history.undoLight(history.id("key"));
        assertThat(history.scene()).isEqualTo(scene);
    }

    @Test
    void undoRename_isRefusedIfNameIsTaken() {
        history.edit(DeskScene.sceneOf(LightEdits.rename(scene, "key", "rim")));
        history.edit(DeskScene.sceneOf(LightEdits.rename(history.scene(), "fill", "key")));
        Scene before = history.scene();
        assertThat(history.undoLight(history.id("rim")).refusal()).contains("light 'key': the name is already taken");
        assertThat(history.scene()).isSameAs(before);
    }

    @Test
    void restoredLight_keepsItsHistory() {
        set(DeskScene.parameter("intensity"), "key", 2);
        long id = history.id("key");
        history.edit(DeskScene.sceneOf(LightEdits.delete(history.scene(), "key")));
        assertThat(history.light(id)).isEmpty();
        assertThat(history.undoLabel(id)).isEmpty();
        history.undo();
        assertThat(history.id("key")).isEqualTo(id);
        assertThat(history.undoLabel(id)).contains("key: intensity 1 → 2");
    }

    @Test
    void selection_followsLight() {
        Selection selection = Selection.light(history, "key");
        history.edit(DeskScene.sceneOf(LightEdits.rename(scene, "key", "rim")));
        assertThat(selection.light(history)).map(Light::name).contains("rim");
        history.edit(DeskScene.sceneOf(LightEdits.delete(history.scene(), "rim")));
        history.undo();
        history.undo();
        assertThat(selection.light(history)).map(Light::name).contains("key");
    }

    /** Deletes b, then c, of lights a, b, c: the selection moves to c at b's index, then to the last light. */
    @Test
    void selectionOfDeletedLight_isItsNeighbor() {
        String second = scene.lights().get(1).name();
        String third = scene.lights().get(2).name();
        Selection selection = Selection.light(history, second);
        history.edit(DeskScene.sceneOf(LightEdits.delete(scene, second)));
        assertThat(selection.light(history)).map(Light::name).contains(third);
        history.edit(DeskScene.sceneOf(LightEdits.delete(history.scene(), third)));
        assertThat(selection.light(history)).contains(history.scene().lights().getLast());
        history.undo();
        history.undo();
        assertThat(selection.light(history)).map(Light::name).contains(second);
    }

    @Test
    void selectionAfterUndoneAdd_isNeighbor() {
        String first = scene.lights().getFirst().name();
        history.edit(DeskScene.sceneOf(LightEdits.duplicate(scene, first)));
        Selection selection = Selection.light(history, history.scene().lights().get(1).name());
        history.undo();
        assertThat(selection.light(history)).contains(scene.lights().get(1));
        history.redo();
        assertThat(selection.light(history)).contains(history.scene().lights().get(1));
    }

    @Test
    void noLights_nothingIsSelected() {
        Selection selection = Selection.light(history, scene.lights().getFirst().name());
        for (Light light : scene.lights()) {
            history.edit(DeskScene.sceneOf(LightEdits.delete(history.scene(), light.name())));
        }
        assertThat(selection.light(history)).isEmpty();
    }

    @Test
    void selectionOfShapeOrNothing_isNoLight() {
        assertThat(new Selection.OfNode("ball").light(history)).isEmpty();
        assertThat(Selection.light(history, "missing")).isEqualTo(Selection.NONE);
        assertThat(Selection.NONE.light(history)).isEmpty();
    }

    @Property
    void undoAndRedo_restoreEveryScene(@ForAll("sessions") EditSession session) {
        EditHistory edited = new EditHistory(session.scenes().getFirst());
        List<Scene> steps = new ArrayList<>(List.of(edited.scene()));
        for (Scene wanted : session.scenes()) {
            edited.edit(wanted);
            if (!wanted.equals(steps.getLast())) {
                steps.add(wanted);
            }
        }
        for (int i = steps.size() - 1; i > 0; i--) {
            edited.undo();
            assertThat(edited.scene()).isEqualTo(steps.get(i - 1));
        }
        assertThat(edited.undoLabel()).isEmpty();
        for (int i = 1; i < steps.size(); i++) {
            edited.redo();
            assertThat(edited.scene()).isEqualTo(steps.get(i));
        }
        assertThat(edited.redoLabel()).isEmpty();
    }

    @Property
    void undoingAllStepsOfLight_keepsOthersAndCanBeRedone(@ForAll("sessions") EditSession session) {
        EditHistory edited = new EditHistory(session.scenes().getFirst());
        session.scenes().forEach(edited::edit);
        Scene last = edited.scene();
        for (Light light : last.lights()) {
            long id = edited.id(light.name());
            int steps = 0;
            while (edited.undoLabel(id).isPresent() && edited.undoLight(id).refusal().isEmpty()) {
                steps++;
                Scene now = edited.scene();
                assertThat(now.lights()).hasSameSizeAs(last.lights());
                assertThat(now.lights().stream().filter(l -> !last.lights().contains(l))).hasSizeLessThanOrEqualTo(1);
                assertThat(now.withLights(last.lights())).isEqualTo(last);
            }
            for (int i = 0; i < steps; i++) {
                assertThat(edited.redoLight(id).refusal()).isEmpty();
            }
            assertThat(edited.scene()).isEqualTo(last);
        }
    }
}
