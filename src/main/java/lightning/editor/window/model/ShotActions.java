package lightning.editor.window.model;

import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.document.KeyEdits;
import lightning.document.ShotFrame;
import lightning.editor.Command;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Track;

/** Actions of the commands for the shot and its selected keyframes. */
record ShotActions(SceneEditor editor, KeySelection keySelection) {
    static void register(SceneEditor editor, KeySelection keySelection, WindowLayout layout, CommandRegistry commands) {
        var actions = new ShotActions(editor, keySelection);
        commands.setAction(Command.NEW_SHOT, () -> {
            actions.edit(KeyEdits::addShot);
            layout.timelineShownProperty().set(true);
        });
        commands.setAction(Command.DELETE_SHOT, () -> actions.edit(_ -> AnimatedScene.of(editor.scene())));
        commands.setAction(Command.FIRST_FRAME, () -> actions.shotFrame().ifPresent(m -> editor.showFrame(m.shot().first())));
        commands.setAction(Command.LAST_FRAME, () -> actions.shotFrame().ifPresent(m -> editor.showFrame(m.shot().last())));
        commands.setAction(Command.PREVIOUS_FRAME, () -> actions.shotFrame().ifPresent(m -> editor.showFrame(m.frame() - 1)));
        commands.setAction(Command.NEXT_FRAME, () -> actions.shotFrame().ifPresent(m -> editor.showFrame(m.frame() + 1)));
        commands.setAction(Command.PREVIOUS_KEY,
                () -> actions.shotFrame().flatMap(m -> m.nearestKeyFrame(true)).ifPresent(editor::showFrame));
        commands.setAction(Command.NEXT_KEY, () -> actions.shotFrame().flatMap(m -> m.nearestKeyFrame(false)).ifPresent(editor::showFrame));
        commands.setAction(Command.SET_KEY, () -> actions.shotFrame().ifPresent(actions::setKeys));
        commands.setAction(Command.DELETE_KEYS, () -> {
            Scene shownScene = editor.scene();
            actions.edit(scene -> KeyEdits.deleteKeys(scene, shownScene, keySelection.keys()));
        });
        commands.setAction(Command.LINEAR_KEYS, () -> actions.setInterpolation(Interpolation.LINEAR));
        commands.setAction(Command.SMOOTH_KEYS, () -> actions.setInterpolation(Interpolation.SMOOTH));
        commands.setAction(Command.STEPPED_KEYS, () -> actions.setInterpolation(Interpolation.STEPPED));
    }

    private void edit(UnaryOperator<AnimatedScene> edit) {
        editor.editShotOrReport(edit, null);
    }

    /** Returns the displayed frame, or empty if the scene has no shot. */
    private Optional<ShotFrame> shotFrame() {
        return editor.document().shotFrame();
    }

    private void setInterpolation(Interpolation interpolation) {
        edit(scene -> KeyEdits.setInterpolation(scene, keySelection.keys(), interpolation));
    }

    /** Sets a keyframe on every animated attribute of the selection. */
    private void setKeys(ShotFrame frame) {
        Scene shownScene = editor.scene();
        edit(scene -> {
            AnimatedScene keyed = scene;
            for (Track track : frame.shot().tracks()) {
                if (editor.editorStateProperty().get().isSelected(track.target())) {
                    keyed = KeyEdits.setKey(keyed, shownScene, track.target(), track.attribute(), frame.frame());
                }
            }
            return keyed;
        });
    }
}
