package lightning.app.model;

import java.util.function.UnaryOperator;
import lightning.edit.Command;
import lightning.edit.KeyEdits;
import lightning.edit.Moment;
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
        model.setAction(Command.NEW_SHOT, () -> {
            actions.edit(KeyEdits::begin);
            model.arrangement().timelineShownProperty().set(true);
        });
        model.setAction(Command.DELETE_SHOT, () -> actions.edit(_ -> AnimatedScene.of(model.scene())));
        model.setAction(Command.FIRST_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.shot().first())));
        model.setAction(Command.LAST_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.shot().last())));
        model.setAction(Command.PREVIOUS_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.frame() - 1)));
        model.setAction(Command.NEXT_FRAME, () -> model.moment().ifPresent(m -> model.showFrame(m.frame() + 1)));
        model.setAction(Command.PREVIOUS_KEY, () -> model.moment().flatMap(m -> m.nearestKey(true)).ifPresent(model::showFrame));
        model.setAction(Command.NEXT_KEY, () -> model.moment().flatMap(m -> m.nearestKey(false)).ifPresent(model::showFrame));
        model.setAction(Command.SET_KEY, () -> model.moment().ifPresent(actions::setKeys));
        model.setAction(Command.DELETE_KEYS, () -> {
            Scene shown = model.scene();
            actions.edit(scene -> KeyEdits.without(scene, shown, model.keyChoice().keys()));
        });
        model.setAction(Command.LINEAR_KEYS, () -> actions.passing(Passage.LINEAR));
        model.setAction(Command.SMOOTH_KEYS, () -> actions.passing(Passage.SMOOTH));
        model.setAction(Command.STEPPED_KEYS, () -> actions.passing(Passage.STEPPED));
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
