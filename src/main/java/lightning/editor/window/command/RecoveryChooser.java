package lightning.editor.window.command;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.DiskStatus;
import lightning.document.RecoveryFolder;
import org.jspecify.annotations.Nullable;

/** List of the unsaved scenes of crashed processes, newest first, to choose one. */
final class RecoveryChooser extends ListView<RecoveryFolder.RecoverableScene> {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss", Locale.ROOT);
    private static final double WIDTH = 560;
    private static final double ROW_HEIGHT = 52;
    private static final int MAX_ROWS = 6;

    RecoveryChooser(List<RecoveryFolder.RecoverableScene> scenes) {
        setId("recoverable");
        setAccessibleText(Messages.tr("Unsaved scenes"));
        getItems().setAll(scenes);
        setCellFactory(_ -> new SceneCell());
        setPrefSize(WIDTH, ROW_HEIGHT * Math.min(MAX_ROWS, scenes.size()) + 2);
        setMinHeight(USE_PREF_SIZE);
        getSelectionModel().selectFirst();
    }

    /** Returns the selected scene; empty if the list is empty. */
    Optional<RecoveryFolder.RecoverableScene> chosen() {
        return Optional.ofNullable(getSelectionModel().getSelectedItem());
    }

    /** Removes a scene and selects the next one. */
    void remove(RecoveryFolder.RecoverableScene scene) {
        getItems().remove(scene);
        if (getSelectionModel().isEmpty()) {
            getSelectionModel().selectFirst();
        }
    }

    static String description(RecoveryFolder.RecoverableScene scene) {
        return Messages.tr("{0}, edited {1}", scene.isNew() ? Messages.tr("New scene") : Quote.path(scene.file()),
                TIME.format(scene.time().atZone(ZoneId.systemDefault()))) + "\n" + change(scene);
    }

    private static String change(RecoveryFolder.RecoverableScene scene) {
        DiskStatus disk = scene.disk();
        if (scene.isNew()) {
            return Messages.tr("It was never saved.");
        }
        if (disk.isChanged()) {
            return Messages.tr("The file was changed since this version was opened, at {0}.",
                    TIME.format(disk.current().modified().toInstant().atZone(ZoneId.systemDefault())));
        }
        return disk.isMissing() ? Messages.tr("The file does not exist.") : Messages.tr("The file did not change since.");
    }

    private static final class SceneCell extends ListCell<RecoveryFolder.RecoverableScene> {
        @Override
        protected void updateItem(RecoveryFolder.@Nullable RecoverableScene scene, boolean empty) {
            super.updateItem(scene, empty);
            setWrapText(true);
            setPrefWidth(0);
            setText(empty || scene == null ? "" : description(scene));
        }
    }
}
