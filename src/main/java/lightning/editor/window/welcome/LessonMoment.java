package lightning.editor.window.welcome;

import java.util.Optional;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.model.EditorModel;
import lightning.scene.Scene;

/**
 * State of the editor that decides if a step of a lesson is done.
 *
 * @param command command that was run last since the step began
 * @param savedLooks number of looks saved in this session
 */
record LessonMoment(Scene scene, EditorState state, Optional<Command> command, int savedLooks) {
    static LessonMoment of(EditorModel model, Optional<Command> command) {
        return new LessonMoment(model.editor().scene(), model.editor().editorStateProperty().get(), command,
                model.editor().savedLooksProperty().get());
    }

    boolean hasRun(Command expected) {
        return command.filter(c -> c == expected).isPresent();
    }

    /** Returns whether the lights or their light groups differ from those of another moment. */
    boolean hasOtherLights(LessonMoment start) {
        return !scene.rig().equals(start.scene.rig());
    }
}
