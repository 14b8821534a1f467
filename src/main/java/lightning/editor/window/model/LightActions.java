package lightning.editor.window.model;

import java.util.function.BiFunction;
import lightning.base.text.Decimal;
import lightning.base.text.Texts;
import lightning.editor.document.BankEdits;
import lightning.editor.document.Beside;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.Workbench;
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
        model.commands().setAction(Command.GO, model::go);
        Workbench bench = model.workbench();
        model.commands().setAction(Command.UPDATE_REFLECTIONS, bench::updateReflections);
        model.commands().setAction(Command.VERIFY, bench::verify);
        model.commands().setAction(Command.CANCEL, model::cancel);
        model.commands().setAction(Command.UNDO, bench::undo);
        model.commands().setAction(Command.REDO, bench::redo);
        model.commands().setAction(Command.UNDO_LIGHT, () -> bench.undoLight().ifPresent(model::say));
        model.commands().setAction(Command.REDO_LIGHT, () -> bench.redoLight().ifPresent(model::say));
        model.commands().setAction(Command.ADD_LIGHT, () -> actions.add(LightType.POINT));
        model.commands().setAction(Command.DUPLICATE_LIGHT, actions::duplicate);
        model.commands().setAction(Command.DELETE_LIGHT, () -> actions.edit(LightEdits::delete));
        model.commands().setAction(Command.SWITCH_ON, () -> actions.edit((s, n) -> LightEdits.on(s, n, !model.selectedLight().on())));
        model.commands().setAction(Command.SOLO, () -> actions.edit((s, n) -> LightEdits.solo(s, n, !model.selectedLight().solo())));
        model.commands().setAction(Command.NEW_BANK, () -> actions.edit(BankEdits::add));
        model.commands().setAction(Command.DELETE_BANK, () -> actions.edit((s, n) -> BankEdits.delete(s, LightEdits.light(s, n).bank())));
        model.commands().setAction(Command.COPY_SETTINGS, bench::copySettings);
        model.commands().setAction(Command.PASTE_SETTINGS, () -> bench.pasteSettings().ifPresent(model::say));
    }

    private void edit(BiFunction<Scene, String, Change> edit) {
        Light light = model.selectedLight();
        model.edit(scene -> edit.apply(scene, light.name())).ifPresent(model::say);
    }

    /** The new light is the last of the scene, and selected. */
    void add(LightType type) {
        model.edit(scene -> LightEdits.add(scene, type)).ifPresentOrElse(model::say,
                () -> model.selectLight(model.lights().getLast().name()));
    }

    /** The copy stands behind its original, and is selected. */
    private void duplicate() {
        Light original = model.selectedLight();
        model.edit(scene -> LightEdits.duplicate(scene, original.name())).ifPresentOrElse(model::say, () -> {
            String copy = model.lights().get(model.lights().indexOf(original) + 1).name();
            model.selectLight(copy);
            tellBeside(model, copy, original.name());
        });
    }

    /** Tells where a copy stands. */
    static void tellBeside(EditorModel model, String copy, String original) {
        model.say(Texts.of("{0} stands {1} beside {2}, along x", copy, Decimal.text(Beside.length(model.scene())), original));
    }
}
