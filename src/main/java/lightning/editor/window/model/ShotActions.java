package lightning.editor.window.model;

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
    private final EditorModel model;

    private ShotActions(EditorModel model) {
        this.model = model;
    }

    static void addTo(EditorModel model) {
        var actions = new ShotActions(model);
        model.commands().setAction(Command.NEW_SHOT, () -> {
            actions.edit(KeyEdits::begin);
            model.arrangement().timelineShownProperty().set(true);
        });
        model.commands().setAction(Command.DELETE_SHOT, () -> actions.edit(_ -> AnimatedScene.of(model.scene())));
        model.commands().setAction(Command.FIRST_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.shot().first())));
        model.commands().setAction(Command.LAST_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.shot().last())));
        model.commands().setAction(Command.PREVIOUS_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.frame() - 1)));
        model.commands().setAction(Command.NEXT_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.frame() + 1)));
        model.commands().setAction(Command.PREVIOUS_KEY, () -> model.moment().flatMap(m -> m.nearestKey(true)).ifPresent(model::showFrame));
        model.commands().setAction(Command.NEXT_KEY, () -> model.moment().flatMap(m -> m.nearestKey(false)).ifPresent(model::showFrame));
        model.commands().setAction(Command.SET_KEY, () -> model.moment().ifPresent(actions::setKeys));
        model.commands().setAction(Command.DELETE_KEYS, () -> {
            Scene shown = model.scene();
            actions.edit(scene -> KeyEdits.without(scene, shown, model.keyChoice().keys()));
        });
        model.commands().setAction(Command.LINEAR_KEYS, () -> actions.passing(Passage.LINEAR));
        model.commands().setAction(Command.SMOOTH_KEYS, () -> actions.passing(Passage.SMOOTH));
        model.commands().setAction(Command.STEPPED_KEYS, () -> actions.passing(Passage.STEPPED));
    }

    private void edit(UnaryOperator<AnimatedScene> edit) {
        model.editAll(edit, null).ifPresent(model::say);
    }

    private void passing(Passage passage) {
        edit(scene -> KeyEdits.passing(scene, model.keyChoice().keys(), passage));
    }

    /** Of all that is selected and has keys. */
    private void setKeys(Moment now) {
        Scene shown = model.scene();
        edit(scene -> {
            AnimatedScene keyed = scene;
            for (Track track : now.shot().tracks()) {
                if (model.situationProperty().get().isSelected(track.target())) {
                    keyed = KeyEdits.key(keyed, shown, track.target(), track.attribute(), now.frame());
                }
            }
            return keyed;
        });
    }
}
