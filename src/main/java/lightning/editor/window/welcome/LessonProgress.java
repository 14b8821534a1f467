package lightning.editor.window.welcome;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.ReadOnlyIntegerProperty;
import javafx.beans.property.ReadOnlyIntegerWrapper;
import javafx.util.Subscription;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;

/**
 * Progress of a lesson: goes to the next step when the user has done the current one. A drag counts when it ends, so that it completes at
 * most one step.
 */
final class LessonProgress implements AutoCloseable {
    private final EditorModel model;
    private final Lesson lesson;
    private final ReadOnlyIntegerWrapper step = new ReadOnlyIntegerWrapper();
    private final Subscription subscription;
    private final Consumer<Command> onRun = this::commandRun;
    private LessonMoment start;
    private Optional<Command> command = Optional.empty();
    private boolean mousePressed;

    LessonProgress(EditorModel model, Lesson lesson) {
        this.model = model;
        this.lesson = lesson;
        begin(0);
        model.commands().addRunListener(onRun);
        subscription = Subscription.combine(model.editor().editorStateProperty().subscribe(_ -> check()),
                model.editor().savedLooksProperty().subscribe(_ -> check()));
    }

    /** Index of the current step; the number of steps when the lesson is done. */
    ReadOnlyIntegerProperty stepProperty() {
        return step.getReadOnlyProperty();
    }

    boolean isComplete() {
        return step.get() == lesson.steps().size();
    }

    /** Goes to the next step without doing the current one. */
    void skip() {
        if (!isComplete()) {
            begin(step.get() + 1);
        }
    }

    /** Reports that a mouse button of the editor's window was pressed or released. */
    void setMousePressed(boolean pressed) {
        mousePressed = pressed;
        check();
    }

    private void begin(int index) {
        command = Optional.empty();
        start = LessonMoment.of(model, command);
        step.set(index);
        check();
    }

    private void commandRun(Command run) {
        command = Optional.of(run);
        check();
    }

    private void check() {
        if (!mousePressed && !isComplete() && lesson.steps().get(step.get()).isDone().test(start, LessonMoment.of(model, command))) {
            begin(step.get() + 1);
        }
    }

    @Override
    public void close() {
        model.commands().removeRunListener(onRun);
        subscription.unsubscribe();
    }
}
