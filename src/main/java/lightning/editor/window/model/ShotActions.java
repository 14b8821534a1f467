package lightning.editor.window.model;

import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.editor.document.Command;
import lightning.editor.document.KeyEdits;
import lightning.editor.document.Moment;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Track;

/** What the commands do to the shot and to the keys that are chosen. */
final class ShotActions {
    private final SceneEditor editor;
    private final KeyChoice keyChoice;

    private ShotActions(SceneEditor editor, KeyChoice keyChoice) {
        this.editor = editor;
        this.keyChoice = keyChoice;
    }

    static void addTo(SceneEditor editor, KeyChoice keyChoice, Arrangement arrangement, Commands commands) {
        var actions = new ShotActions(editor, keyChoice);
        commands.setAction(Command.NEW_SHOT, () -> {
            actions.edit(KeyEdits::begin);
            arrangement.timelineShownProperty().set(true);
        });
        commands.setAction(Command.DELETE_SHOT, () -> actions.edit(_ -> AnimatedScene.of(editor.scene())));
        commands.setAction(Command.FIRST_FRAME, () -> actions.now().ifPresent(m -> editor.showFrame(m.shot().first())));
        commands.setAction(Command.LAST_FRAME, () -> actions.now().ifPresent(m -> editor.showFrame(m.shot().last())));
        commands.setAction(Command.PREVIOUS_FRAME, () -> actions.now().ifPresent(m -> editor.showFrame(m.frame() - 1)));
        commands.setAction(Command.NEXT_FRAME, () -> actions.now().ifPresent(m -> editor.showFrame(m.frame() + 1)));
        commands.setAction(Command.PREVIOUS_KEY, () -> actions.now().flatMap(m -> m.nearestKey(true)).ifPresent(editor::showFrame));
        commands.setAction(Command.NEXT_KEY, () -> actions.now().flatMap(m -> m.nearestKey(false)).ifPresent(editor::showFrame));
        commands.setAction(Command.SET_KEY, () -> actions.now().ifPresent(actions::setKeys));
        commands.setAction(Command.DELETE_KEYS, () -> {
            Scene shown = editor.scene();
            actions.edit(scene -> KeyEdits.without(scene, shown, keyChoice.keys()));
        });
        commands.setAction(Command.LINEAR_KEYS, () -> actions.passing(Passage.LINEAR));
        commands.setAction(Command.SMOOTH_KEYS, () -> actions.passing(Passage.SMOOTH));
        commands.setAction(Command.STEPPED_KEYS, () -> actions.passing(Passage.STEPPED));
    }

    private void edit(UnaryOperator<AnimatedScene> edit) {
        editor.editAllOrReport(edit, null);
    }

    /** The frame that is shown; empty where the scene has no shot. */
    private Optional<Moment> now() {
        return editor.document().moment();
    }

    private void passing(Passage passage) {
        edit(scene -> KeyEdits.passing(scene, keyChoice.keys(), passage));
    }

    /** Of all that is selected and has keys. */
    private void setKeys(Moment now) {
        Scene shown = editor.scene();
        edit(scene -> {
            AnimatedScene keyed = scene;
            for (Track track : now.shot().tracks()) {
                if (editor.situationProperty().get().isSelected(track.target())) {
                    keyed = KeyEdits.key(keyed, shown, track.target(), track.attribute(), now.frame());
                }
            }
            return keyed;
        });
    }
}
