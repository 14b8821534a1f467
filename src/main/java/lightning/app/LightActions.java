package lightning.app;

import java.util.function.BiFunction;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.LightEdits;
import lightning.edit.OpenDocument;
import lightning.edit.PreviewCamera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/** The commands that ask nothing before they are done. */
final class LightActions {
    private final EditorModel model;

    private LightActions(EditorModel model) {
        this.model = model;
    }

    static void addTo(EditorModel model) {
        LightActions actions = new LightActions(model);
        model.setAction(Command.GO, model::go);
        model.setAction(Command.UPDATE_REFLECTIONS, model::updateReflections);
        model.setAction(Command.VERIFY, model::verify);
        model.setAction(Command.CANCEL, model::cancel);
        model.setAction(Command.UNDO, () -> actions.step(() -> actions.document().history().undo()));
        model.setAction(Command.REDO, () -> actions.step(() -> actions.document().history().redo()));
        model.setAction(Command.UNDO_LIGHT, () -> actions.moveLight(true));
        model.setAction(Command.REDO_LIGHT, () -> actions.moveLight(false));
        model.setAction(Command.ADD_LIGHT, () -> actions.add(LightType.POINT));
        model.setAction(Command.DUPLICATE_LIGHT, actions::duplicate);
        model.setAction(Command.DELETE_LIGHT, () -> actions.edit(LightEdits::delete));
        model.setAction(Command.SWITCH_ON, () -> actions.edit((s, n) -> LightEdits.on(s, n, !model.selectedLight().on())));
        model.setAction(Command.SOLO, () -> actions.edit((s, n) -> LightEdits.solo(s, n, !model.selectedLight().solo())));
        model.setAction(Command.COPY_SETTINGS, () -> model.copy(model.selectedLight()));
        model.setAction(Command.PASTE_SETTINGS, () -> actions.edit((s, n) -> LightEdits.paste(s, n, model.copied())));
        model.setAction(Command.LOOK_THROUGH_LIGHT, () ->
                model.previewCameraProperty().set(PreviewCamera.through(model.selectedLight(), model.scene())));
    }

    private OpenDocument document() {
        return model.document();
    }

    private void step(Runnable step) {
        step.run();
        model.documentChanged();
    }

    private void edit(BiFunction<Scene, String, Change> edit) {
        Light light = model.selectedLight();
        model.edit(scene -> edit.apply(scene, light.name())).ifPresent(model::say);
    }

    private void moveLight(boolean back) {
        var history = document().history();
        long id = history.id(model.selectedLight().name());
        Change change = back ? history.undoLight(id) : history.redoLight(id);
        model.documentChanged();
        change.refusal().ifPresent(model::say);
    }

    /** The new light is the last of the scene, and selected. */
    void add(LightType type) {
        model.edit(scene -> LightEdits.add(scene, type)).ifPresentOrElse(model::say,
                () -> model.selectLight(model.lights().getLast().name()));
    }

    /** The copy stands behind its original, and is selected. */
    private void duplicate() {
        int place = model.lights().indexOf(model.selectedLight());
        edit(LightEdits::duplicate);
        model.selectLight(model.lights().get(Math.min(place + 1, model.lights().size() - 1)).name());
    }
}
