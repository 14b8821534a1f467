package lightning.editor.window;

import java.util.concurrent.Executor;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import lightning.base.text.Messages;
import lightning.document.DiskStatus;
import lightning.document.DiskWatch;
import lightning.document.OpenDocument;
import lightning.document.OpenSceneRegistry;
import lightning.editor.Command;
import lightning.editor.Workbench;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.widget.DisabledReason;
import org.jspecify.annotations.Nullable;

/**
 * Notice above the pictures that the open scene's file was changed, moved or deleted, or is open in another editor. Offers actions. A
 * separate thread watches the file.
 */
final class ExternalChangeBar extends HBox implements AutoCloseable {
    private static final double GAP = 8;

    private final Workbench workbench;
    private final CommandRegistry commands;
    private final DiskWatch watch;
    private final Label text = new Label();
    private final Button reload = button(Messages.tr("Reload"), "disk-reload");
    private final DisabledReason reloadReason = new DisabledReason(this, reload);
    private final Button keepMine = button(Messages.tr("Keep Mine"), "disk-keep");
    private final Button compare = button(Messages.tr("Compare…"), "disk-compare");
    private final Button hide = button(Messages.tr("Hide"), "disk-read");
    /** Status that the user has dismissed. */
    private @Nullable DiskStatus dismissed;

    /**
     * Creates the bar and starts to watch the file.
     *
     * @param windowExecutor runs tasks in order on the window's thread
     * @param showComparison shows the open scene next to the file and offers to choose one
     */
    ExternalChangeBar(Workbench workbench, CommandRegistry commands, Executor windowExecutor, Runnable showComparison) {
        this.workbench = workbench;
        this.commands = commands;
        watch = new DiskWatch(new OpenSceneRegistry(EditorPaths.dataFolder().resolve("open")), DiskWatch.DEFAULT_PERIOD,
                news -> windowExecutor.execute(() -> workbench.setDiskStatus(news)));
        setId("disk-bar");
        getStyleClass().add("disk-bar");
        setAlignment(Pos.CENTER_LEFT);
        setSpacing(GAP);
        text.setId("disk-news");
        text.setMinWidth(0);
        text.setMaxWidth(Double.MAX_VALUE);
        text.setWrapText(true);
        HBox.setHgrow(text, Priority.ALWAYS);
        reload.setOnAction(_ -> commands.run(Command.RELOAD));
        keepMine.setOnAction(_ -> {
            dismiss();
            workbench.ignoreDiskChange();
        });
        compare.setOnAction(_ -> showComparison.run());
        hide.setOnAction(_ -> dismiss());
        getChildren().addAll(text, reload, keepMine, compare, hide);
        // The editor state also changes on every check of the file, even if the result is the same.
        commands.editorState().addListener(_ -> update());
        update();
    }

    private static Button button(String name, String id) {
        var button = new Button(name);
        button.setId(id);
        button.setMinWidth(USE_PREF_SIZE);
        return button;
    }

    /** Checks the file immediately, for example when the window gets the focus back. */
    void checkFile() {
        watch.checkNow();
    }

    private void dismiss() {
        dismissed = workbench.document().diskStatus();
        update();
    }

    private void update() {
        commands.editorState().get();
        OpenDocument document = workbench.document();
        if (document.isUntitled()) {
            watch.pause();
        } else {
            watch.watch(document.file(), document.knownState());
        }
        DiskStatus status = document.diskStatus();
        boolean isShown = (status.isChanged() || status.isDeleted() || status.isOpenElsewhere()) && !status.equals(dismissed);
        setVisible(isShown);
        setManaged(isShown);
        text.setText(message(document.name(), status));
        setShown(reload, status.isChanged());
        setShown(keepMine, status.isChanged());
        setShown(compare, status.isChanged());
        setShown(hide, !status.isChanged());
        reloadReason.set(commands.disabledReason(Command.RELOAD));
    }

    private static void setShown(Button button, boolean isShown) {
        button.setVisible(isShown);
        button.setManaged(isShown);
    }

    private static String message(String name, DiskStatus status) {
        if (status.isChanged()) {
            return Messages.tr("{0} was changed by another program.", name);
        }
        if (status.isDeleted()) {
            return Messages.tr("{0} was moved or deleted. Save Scene creates it again.", name);
        }
        return status.isOpenElsewhere()
                ? Messages.tr("{0} is also open in another window. A prompt appears before changes are overwritten.", name)
                : "";
    }

    @Override
    public void close() {
        watch.close();
    }
}
