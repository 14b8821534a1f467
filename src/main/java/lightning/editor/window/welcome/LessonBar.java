package lightning.editor.window.welcome;

import static java.util.Objects.requireNonNull;

import java.util.List;
import javafx.application.Platform;
import javafx.event.EventHandler;
import javafx.geometry.Pos;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;

/** Bar above the pictures that shows the current step of a lesson. */
public final class LessonBar extends HBox implements AutoCloseable {
    private static final double GAP = 8;

    private final EditorModel model;
    private final Label title = new Label();
    private final Label text = new Label();
    private final Button next = new Button(Messages.tr("Skip Step"));
    private final Button end = new Button(Messages.tr("End Lesson"));
    private final EventHandler<MouseEvent> mouseListener = this::trackMouse;
    private @Nullable Lesson lesson;
    /** Null while no lesson runs. */
    private @Nullable LessonProgress progress;

    public LessonBar(EditorModel model) {
        this.model = model;
        setId("lesson-bar");
        getStyleClass().add("lesson-bar");
        setAlignment(Pos.CENTER_LEFT);
        setSpacing(GAP);
        title.setId("lesson-title");
        title.setGraphic(new FontIcon(MaterialDesignS.SCHOOL_OUTLINE));
        title.getStyleClass().add("lesson-title");
        title.setMinWidth(USE_PREF_SIZE);
        text.setId("lesson-text");
        text.setWrapText(true);
        text.setMinWidth(0);
        text.setMinHeight(USE_PREF_SIZE);
        text.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(text, Priority.ALWAYS);
        next.setId("lesson-next");
        next.setMinWidth(USE_PREF_SIZE);
        next.setOnAction(_ -> {
            if (requireNonNull(progress).isComplete()) {
                start(following());
            } else {
                progress.skip();
            }
        });
        end.setId("lesson-end");
        end.setMinWidth(USE_PREF_SIZE);
        end.setOnAction(_ -> stop());
        getChildren().addAll(title, text, next, end);
        sceneProperty().subscribe(this::observe);
        setVisible(false);
        setManaged(false);
    }

    private void observe(@Nullable Scene before, @Nullable Scene now) {
        for (var type : List.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED)) {
            if (before != null) {
                before.removeEventFilter(type, mouseListener);
            }
            if (now != null) {
                now.addEventFilter(type, mouseListener);
            }
        }
    }

    private void trackMouse(MouseEvent event) {
        LessonProgress current = progress;
        if (current != null && event.getEventType() == MouseEvent.MOUSE_PRESSED) {
            current.setMousePressed(true);
        } else if (current != null) {
            // After the edit that the release itself makes.
            Platform.runLater(() -> current.setMousePressed(false));
        }
    }

    /** Starts a lesson at its first step. */
    void start(Lesson chosen) {
        stop();
        lesson = chosen;
        progress = new LessonProgress(model, chosen);
        progress.stepProperty().subscribe(_ -> update());
        setVisible(true);
        setManaged(true);
    }

    /** Ends the current lesson, if any. */
    void stop() {
        if (progress != null) {
            progress.close();
            progress = null;
        }
        setVisible(false);
        setManaged(false);
    }

    private Lesson following() {
        return Lesson.ALL.get((Lesson.ALL.indexOf(lesson) + 1) % Lesson.ALL.size());
    }

    private void update() {
        if (progress == null) {
            return;
        }
        int count = requireNonNull(lesson).steps().size();
        boolean complete = progress.isComplete();
        int index = progress.stepProperty().get();
        title.setText(complete ? Messages.tr(lesson.title())
                : Messages.tr("{0} ({1} of {2})", Messages.tr(lesson.title()), index + 1, count));
        text.setText(complete ? Messages.tr("Done.") : sentence(lesson.steps().get(index)));
        boolean isLast = lesson.equals(Lesson.ALL.getLast());
        next.setText(complete ? Messages.tr("Next Lesson") : Messages.tr("Skip Step"));
        next.setVisible(!complete || !isLast);
        next.setManaged(next.isVisible());
        end.setText(complete ? Messages.tr("Close") : Messages.tr("End Lesson"));
    }

    private String sentence(Lesson.Step step) {
        return Messages.tr(step.text(), step.commands().stream().map(this::keyOrTitle).toArray());
    }

    private String keyOrTitle(Command command) {
        String key = model.commands().keyBindings().text(command);
        return key.isEmpty() ? command.plainTitle() : key;
    }

    @Override
    public void close() {
        stop();
    }
}
