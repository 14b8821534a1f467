package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.util.Duration;
import lightning.base.text.Messages;
import lightning.document.loop.RenderState;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.FileActivity;
import lightning.editor.window.model.RemainingTime;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.DelayedMessage;

/** Progress of rendering or verification, with a Cancel button. Stays hidden for short tasks. */
final class ProgressOverlay extends HBox {
    private static final Duration SHOW_DELAY = Duration.millis(250);
    private final CommandRegistry commands;
    private final TracedPicture picture;
    private final FileActivity files;
    private final Label title = new Label();
    private final RemainingTime remaining = new RemainingTime();
    private final ProgressBar bar = new ProgressBar(0);
    private final DelayedMessage message = new DelayedMessage(DelayedMessage.Scheduler.FX_THREAD, SHOW_DELAY, text -> {
        title.setText(text);
        setVisible(!text.isEmpty());
    });

    ProgressOverlay(CommandRegistry commands, TracedPicture picture, FileActivity files) {
        this.commands = commands;
        this.picture = picture;
        this.files = files;
        setId("progress");
        getStyleClass().add("progress-overlay");
        setAlignment(Pos.CENTER);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        bar.setId("progress-bar");
        bar.setAccessibleText(Messages.tr("Render progress"));
        var cancel = CommandButton.iconButton(commands, Command.CANCEL);
        cancel.button().setId("cancel-progress");
        getChildren().addAll(title, bar, cancel);
        commands.editorState().subscribe(_ -> update());
        picture.renderStateProperty().subscribe(_ -> update());
        files.titleProperty().subscribe(_ -> update());
    }

    private static String title(RenderState state) {
        return switch (state.activity().stage()) {
            case CENTERS -> Messages.tr("Tracing");
            case INDIRECT, SAMPLES -> StatusText.stage(state.activity().stage());
        };
    }

    private void update() {
        RenderState state = picture.renderStateProperty().get();
        EditorState editorState = commands.editorState().get();
        boolean rendering = editorState.sceneInProgress().isPresent();
        String work =
                editorState.reading() ? files.titleProperty().get() + " " + requireNonNull(files.file()).getFileName()
                        : rendering ? title(state)
                        : editorState.verifying() ? Messages.tr("Verifying") : "";
        double share = editorState.reading() ? ProgressBar.INDETERMINATE_PROGRESS : rendering ? state.progress()
                : (double) state.verifiedTiles() / state.tilesToVerify();
        // A narrow pane shortens the bar. Only file names may be too long for any pane.
        title.setMinWidth(editorState.reading() ? Region.USE_COMPUTED_SIZE : Region.USE_PREF_SIZE);
        message.set(remaining.describe(work, share, System.nanoTime()));
        bar.setProgress(share);
    }
}
