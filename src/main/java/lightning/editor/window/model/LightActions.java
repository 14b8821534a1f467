package lightning.editor.window.model;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.function.BiFunction;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.document.LightGroupEdits;
import lightning.document.manipulation.DuplicateOffset;
import lightning.editor.Command;
import lightning.editor.Workbench;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;

/** Actions of the commands for the selected light and its light group. */
final class LightActions {
    private final SceneEditor editor;
    private final SceneSelection selection;

    private LightActions(SceneEditor editor) {
        this.editor = editor;
        selection = editor.selection();
    }

    static void register(SceneEditor editor, Workbench bench, CommandRegistry commands) {
        var actions = new LightActions(editor);
        StatusMessage message = editor.message();
        commands.setAction(Command.UNDO_LIGHT, () -> bench.undoLight().ifPresent(message::show));
        commands.setAction(Command.REDO_LIGHT, () -> bench.redoLight().ifPresent(message::show));
        commands.setAction(Command.ADD_LIGHT, () -> actions.add(LightType.POINT));
        commands.setAction(Command.DUPLICATE_LIGHT, actions::duplicate);
        commands.setAction(Command.DELETE_LIGHT, () -> actions.edit(LightEdits::delete));
        commands.setAction(Command.SWITCH_ON,
                () -> actions.edit((s, n) -> LightEdits.setOn(s, n, !requireNonNull(actions.selection.light()).on())));
        commands.setAction(Command.SOLO,
                () -> actions.edit((s, n) -> LightEdits.setSolo(s, n, !requireNonNull(actions.selection.light()).solo())));
        commands.setAction(Command.NEW_LIGHT_GROUP, () -> actions.edit(LightGroupEdits::create));
        commands.setAction(Command.DELETE_LIGHT_GROUP,
                () -> actions.edit((s, n) -> LightGroupEdits.delete(s, LightEdits.light(s, n).lightGroup())));
        commands.setAction(Command.COPY_SETTINGS, bench::copySettings);
        commands.setAction(Command.PASTE_SETTINGS, () -> bench.pasteSettings().ifPresent(message::show));
    }

    private void edit(BiFunction<Scene, String, EditOutcome> edit) {
        String light = selection.lightName();
        editor.editOrReport(scene -> edit.apply(scene, light));
    }

    /** Adds a light at the end of the scene and selects it. */
    private void add(LightType type) {
        if (editor.editOrReport(scene -> LightEdits.add(scene, type)).isEmpty()) {
            selection.selectLight(editor.scene().lights().getLast().name());
        }
    }

    /** Duplicates the selected light and selects the copy, which follows the original in the scene. */
    private void duplicate() {
        Light original = requireNonNull(selection.light());
        if (editor.editOrReport(scene -> LightEdits.duplicate(scene, original.name())).isEmpty()) {
            List<Light> lights = editor.scene().lights();
            String copy = lights.get(lights.indexOf(original) + 1).name();
            selection.selectLight(copy);
            reportDuplicateOffset(editor, copy, original.name());
        }
    }

    /** Shows the offset of a copy in the status line. */
    static void reportDuplicateOffset(SceneEditor editor, String copy, String original) {
        editor.message()
                .show(Messages.tr("Duplicated {2} as {0}, offset by {1} along x", copy,
                        DecimalNumber.format(DuplicateOffset.length(editor.scene())), original));
    }
}
