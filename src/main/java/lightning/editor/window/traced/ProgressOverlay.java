package lightning.editor.window.traced;

import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.util.Duration;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.Situation;
import lightning.editor.loop.RenderState;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FileWork;
import lightning.editor.window.model.Remaining;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.Lasting;

/** How far the picture or its verification is, with Cancel; not there for work too short to read it. */
final class ProgressOverlay extends HBox {
    private static final Duration PATIENCE = Duration.millis(250);
    private final Commands commands;
    private final TracedPicture picture;
    private final FileWork files;
    private final Label what = new Label();
    private final Remaining remaining = new Remaining();
    private final ProgressBar bar = new ProgressBar(0);
    private final Lasting work = new Lasting(Lasting.Later.WINDOW, PATIENCE, text -> {
        what.setText(text);
        setVisible(!text.isEmpty());
    });

    ProgressOverlay(Commands commands, TracedPicture picture, FileWork files) {
        this.commands = commands;
        this.picture = picture;
        this.files = files;
        setId("progress");
        getStyleClass().add("progress-overlay");
        setAlignment(Pos.CENTER);
        setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
        bar.setId("progress-bar");
        bar.setAccessibleText(Texts.of("Progress of the picture"));
        var cancel = CommandButton.icon(commands, Command.CANCEL);
        cancel.button().setId("cancel-progress");
        getChildren().addAll(what, bar, cancel);
        commands.situation().subscribe(_ -> update());
        picture.renderingProperty().subscribe(_ -> update());
    }

    private void update() {
        RenderState state = picture.renderingProperty().get();
        Situation now = commands.situation().get();
        boolean rendering = now.inWork().isPresent();
        String what =
                now.reading() ? files.title() + " " + files.file().getFileName() : rendering ? Texts.of("Tracing")
                        : now.verifying() ? Texts.of("Verifying") : "";
        double share = now.reading() ? ProgressBar.INDETERMINATE_PROGRESS : rendering ? state.progress()
                : (double) state.checked() / state.toCheck();
        work.tell(remaining.tell(what, share, System.nanoTime()));
        bar.setProgress(share);
    }
}
