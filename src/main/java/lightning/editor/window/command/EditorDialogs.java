package lightning.editor.window.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.control.Alert;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.input.Clipboard;
import javafx.scene.input.ClipboardContent;
import javafx.scene.layout.Region;
import javafx.stage.Modality;
import javafx.stage.Window;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.FileThread;
import lightning.document.RecoveryFolder;
import lightning.document.imports.ImportPreviews;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.widget.PanelWindow;
import lightning.editor.window.widget.WindowPlacement;
import lightning.format.jen.JenException;
import lightning.format.jen.Problem;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignH;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;

/** Dialogs of the editor. */
public final class EditorDialogs {
    static final ButtonType SAVE = new ButtonType(Messages.tr("Save"), ButtonData.YES);
    static final ButtonType DISCARD = new ButtonType(Messages.tr("Don't Save"), ButtonData.NO);
    static final ButtonType GO_FIRST = new ButtonType(Messages.tr("Render First"), ButtonData.NO);
    static final ButtonType SAVE_AS_IT_IS = new ButtonType(Messages.tr("Save Anyway"), ButtonData.YES);
    static final ButtonType RECOVER = new ButtonType(Messages.tr("Recover"), ButtonData.YES);
    static final ButtonType FORGET = new ButtonType(Messages.tr("Discard"), ButtonData.NO);
    static final ButtonType OVERWRITE = new ButtonType(Messages.tr("Overwrite"), ButtonData.OTHER);
    static final ButtonType REPLACE = new ButtonType(Messages.tr("Replace"), ButtonData.OTHER);
    static final ButtonType SAVE_AS = new ButtonType(Messages.tr("Save As…"), ButtonData.OTHER);
    static final ButtonType RELOAD = new ButtonType(Messages.tr("Reload File"), ButtonData.NO);
    static final ButtonType APPLY = new ButtonType(Messages.tr("Apply"), ButtonData.OK_DONE);
    static final ButtonType LOCATE = new ButtonType(Messages.tr("Locate…"), ButtonData.YES);
    static final ButtonType SKIP = new ButtonType(Messages.tr("Skip"), ButtonData.CANCEL_CLOSE);
    static final ButtonType COPY = new ButtonType(Messages.tr("Copy"), ButtonData.OTHER);
    private static final ButtonType LATER = new ButtonType(Messages.tr("Not Now"), ButtonData.CANCEL_CLOSE);
    private static final double WIDTH = 560;
    /** Maximum total width of a dialog's padding and its window's frame, pixels. */
    private static final double FRAME_WIDTH = 40;
    private static final double LIST_HEIGHT = 320;
    private static final double ROW_HEIGHT = 36;

    private static final int ICON = 28;

    private final Window owner;

    public EditorDialogs(Window owner) {
        this.owner = owner;
    }

    /** Shows an error dialog without blocking. */
    public void showFailure(String header, Throwable cause) {
        failureAlert(header, cause).show();
    }

    /** Shows an error dialog that offers to save to another file. Returns whether the user chose to. */
    boolean askSaveAs(String header, Throwable cause) {
        Alert alert = failureAlert(header, cause);
        alert.getButtonTypes().addFirst(SAVE_AS);
        return alert.showAndWait().filter(SAVE_AS::equals).isPresent();
    }

    /** Shows an error dialog and waits until it is closed. */
    public void showFailureAndWait(String header, Throwable cause) {
        failureAlert(header, cause).showAndWait();
    }

    private Alert failureAlert(String header, Throwable cause) {
        return cause instanceof JenException wrong ? problemAlert(header, wrong.problems())
                : alert(Alert.AlertType.ERROR, header, ErrorMessage.of(cause), ButtonType.CLOSE);
    }

    private Alert problemAlert(String header, List<Problem> problems) {
        Alert alert = alert(Alert.AlertType.ERROR, header, "", ButtonType.CLOSE);
        var list = new ListView<Problem>();
        list.setId("problems");
        list.setAccessibleText(Messages.tr("Problems in the file"));
        list.getItems().setAll(problems);
        list.setCellFactory(_ -> new ProblemCell());
        list.setPrefSize(WIDTH, Math.min(LIST_HEIGHT, ROW_HEIGHT * (problems.size() + 1)));
        alert.getDialogPane().setContent(list);
        return alert;
    }

    Optional<ButtonType> askUnsaved(String name) {
        return alert(Alert.AlertType.CONFIRMATION, Messages.tr("Save changes to {0}?", name),
                Messages.tr("Unsaved changes are lost if you do not save them."), SAVE, DISCARD, ButtonType.CANCEL).showAndWait();
    }

    /** @param message  clause that says why the picture is out of date */
    Optional<ButtonType> askPending(String message) {
        return alert(Alert.AlertType.CONFIRMATION, Messages.tr("Save the image anyway?"),
                Character.toUpperCase(message.charAt(0)) + message.substring(1) + ".", SAVE_AS_IT_IS, GO_FIRST, ButtonType.CANCEL)
                .showAndWait();
    }

    /**
     * Offers all unsaved scenes of crashed processes in a list.
     *
     * @param onDiscard receives each scene that the user discards; the dialog stays open for the others
     * @return scene to recover; empty if none was chosen
     */
    Optional<RecoveryFolder.RecoverableScene> askRecover(List<RecoveryFolder.RecoverableScene> scenes,
            Consumer<RecoveryFolder.RecoverableScene> onDiscard) {
        Alert alert = alert(Alert.AlertType.CONFIRMATION, Messages.tr("Lightning closed unexpectedly. Recover unsaved changes?"), "",
                RECOVER, FORGET, LATER);
        var chooser = new RecoveryChooser(scenes);
        alert.getDialogPane().setContent(chooser);
        alert.setResizable(true);
        alert.getDialogPane().lookupButton(FORGET).addEventFilter(ActionEvent.ACTION, event -> {
            chooser.chosen().ifPresent(scene -> {
                onDiscard.accept(scene);
                chooser.remove(scene);
            });
            if (!chooser.getItems().isEmpty()) {
                event.consume();
            }
        });
        return alert.showAndWait().filter(RECOVER::equals).flatMap(_ -> chooser.chosen());
    }

    /** @param comparison  view of the differences between the open scene and the file */
    Optional<ButtonType> askChangedFile(String name, Node comparison) {
        Alert alert = alert(Alert.AlertType.CONFIRMATION, Messages.tr("{0} was changed by another program", name),
                "", OVERWRITE, SAVE_AS, RELOAD, ButtonType.CANCEL);
        alert.getDialogPane().setContent(comparison);
        // The theme limits the width of alerts.
        alert.getDialogPane().setStyle("-fx-max-width: 10000px");
        alert.setResizable(true);
        return alert.showAndWait();
    }

    /**
     * Asks for the lighting of an imported scene, and for the unit of the file's light intensities.
     *
     * @param onShown  receives the cards, whose pictures may come later
     * @return choice; empty if canceled
     */
    Optional<ImportPreviews.Choice> askImport(Path file, ImportPreviews previews, Consumer<ImportChooser> onShown) {
        Alert alert =
                alert(Alert.AlertType.CONFIRMATION, Messages.tr("How do you want to light {0}?", Quote.path(file.getFileName())), "",
                        ButtonType.CANCEL);
        var cards = new ImportChooser(previews.choices(), previews.picture(),
                WindowPlacement.screenBounds(owner).getWidth() - FRAME_WIDTH, alert::close);
        alert.getDialogPane().setContent(cards);
        onShown.accept(cards);
        alert.showAndWait();
        return cards.chosen();
    }

    /** Asks for a view of OpenColorIO; returns false if canceled. */
    boolean askOcioView(OcioChooser chooser) {
        Alert alert = alert(Alert.AlertType.CONFIRMATION, Messages.tr("Show the image with a view of OpenColorIO"), "", APPLY,
                ButtonType.CANCEL);
        alert.getDialogPane().setContent(chooser);
        alert.getDialogPane().lookupButton(APPLY).disableProperty().bind(chooser.isIncomplete());
        return alert.showAndWait().filter(APPLY::equals).isPresent();
    }

    /** Lists what an import left out or changed. */
    void showImportNotes(Path file, Map<String, Integer> notes) {
        showNotes(Messages.tr("Not everything in {0} was imported as it is", Quote.path(file.getFileName())),
                notes.entrySet().stream().sorted(Map.Entry.comparingByKey())
                        .map(note -> note.getValue() == 1 ? note.getKey() : note.getKey() + " (" + note.getValue() + ")").toList());
    }

    /**
     * Lists the files that a scene names and does not show as they are.
     *
     * @param locate prompts for the missing ones; empty if none is missing
     */
    void showNotes(Path file, List<Problem> notes, Optional<Runnable> locate) {
        Alert alert = notes(Messages.tr("{0} is open, but not all of its files can be used", Quote.path(file.getFileName())),
                notes.stream().map(note -> Messages.tr("line {0}: {1}", note.line(), note.message())).toList());
        locate.ifPresent(action -> {
            alert.getButtonTypes().remove(ButtonType.CLOSE);
            alert.getButtonTypes().addAll(LOCATE, SKIP);
            alert.resultProperty().addListener((_, _, answer) -> {
                if (answer == LOCATE) {
                    Platform.runLater(action);
                }
            });
        });
        alert.show();
    }

    /** Lists notes without blocking the window. The list can be copied. */
    void showNotes(String title, List<String> notes) {
        notes(title, notes).show();
    }

    private Alert notes(String title, List<String> notes) {
        Alert alert = alert(Alert.AlertType.INFORMATION, title, "", COPY, ButtonType.CLOSE);
        alert.initModality(Modality.NONE);
        var list = new ListView<String>();
        list.setId("notes");
        list.setAccessibleText(Messages.tr("Notes"));
        list.getItems().addAll(notes);
        list.setPrefSize(WIDTH, Math.min(LIST_HEIGHT, ROW_HEIGHT * (notes.size() + 1)));
        alert.getDialogPane().setContent(list);
        alert.setResizable(true);
        alert.getDialogPane().lookupButton(COPY).addEventFilter(ActionEvent.ACTION, event -> {
            var content = new ClipboardContent();
            content.putString(String.join("\n", list.getItems()));
            Clipboard.getSystemClipboard().setContent(content);
            event.consume();
        });
        return alert;
    }

    Optional<ButtonType> askReadOnly(Path file) {
        return alert(Alert.AlertType.CONFIRMATION, Messages.tr("Replace the read-only file {0}?", Quote.path(file.getFileName())),
                Messages.tr("This file is read-only. The new file will be read-only too."), REPLACE, SAVE_AS,
                ButtonType.CANCEL).showAndWait();
    }

    /**
     * Adds a missing extension to a chosen file name. Confirms before replacing a file of the longer name, since the system's dialog
     * checked only the typed one.
     *
     * @param action  receives the file, unless the user keeps the existing one
     */
    void withExtension(FileThread files, Path chosen, String extension, Consumer<Path> action) {
        if (chosen.getFileName().toString().endsWith(extension)) {
            action.accept(chosen);
            return;
        }
        Path file = chosen.resolveSibling(chosen.getFileName() + extension);
        files.runConcurrently(() -> Files.exists(file), exists -> {
            if (!exists || askReplace(file)) {
                action.accept(file);
            }
        }, cause -> showFailure(Messages.tr("{0} could not be accessed", Quote.path(file)), cause));
    }

    private boolean askReplace(Path file) {
        return alert(Alert.AlertType.CONFIRMATION, Messages.tr("Replace {0}?", Quote.path(file.getFileName())),
                Messages.tr("{0} already exists.", Quote.path(file)), REPLACE, ButtonType.CANCEL).showAndWait().filter(REPLACE::equals)
                .isPresent();
    }

    public void showText(String title, String text) {
        alert(Alert.AlertType.INFORMATION, title, text, ButtonType.CLOSE).show();
    }

    /** Returns the focused panel window, else the editor's window. A dialog is certain to appear above its owner only. */
    private Window askingWindow() {
        return Window.getWindows().stream().filter(PanelWindow.class::isInstance).map(PanelWindow.class::cast)
                .filter(w -> w.isFocused() && w.getOwner() == owner).findFirst().<Window>map(w -> w).orElse(owner);
    }

    private Alert alert(Alert.AlertType type, String header, String text, ButtonType... buttons) {
        var alert = new Alert(type, "", buttons);
        alert.initOwner(askingWindow());
        alert.setTitle("Lightning");
        alert.setHeaderText(header);
        Ikon icon = switch (type) {
            case ERROR -> MaterialDesignA.ALERT_CIRCLE_OUTLINE;
            case CONFIRMATION -> MaterialDesignH.HELP_CIRCLE_OUTLINE;
            case INFORMATION, WARNING, NONE -> MaterialDesignI.INFORMATION_OUTLINE;
        };
        alert.setGraphic(FontIcon.of(icon, ICON));
        alert.getDialogPane().setContent(new WrappedLabel(text));
        alert.getDialogPane().setMinHeight(Region.USE_PREF_SIZE);
        if (Stream.of(buttons).noneMatch(button -> button.getButtonData().isDefaultButton())) {
            // Enter presses the default button, else the first, and must not destroy anything.
            Stream.of(buttons).filter(button -> button.getButtonData() == ButtonData.CANCEL_CLOSE).findFirst()
                    .ifPresent(cancel -> ((Button) alert.getDialogPane().lookupButton(cancel)).setDefaultButton(true));
        }
        alert.setOnShown(_ -> WindowPlacement.fit(alert.getDialogPane().getScene().getWindow()));
        return alert;
    }

    /** Wrapping label of limited width, also when the dialog computes its preferred size. */
    private static final class WrappedLabel extends Label {
        WrappedLabel(String text) {
            super(text);
            setWrapText(true);
        }

        @Override
        protected double computePrefWidth(double height) {
            return Math.min(super.computePrefWidth(height), WIDTH);
        }
    }

    /** Cell that shows the position and message of a problem. */
    private static final class ProblemCell extends ListCell<Problem> {
        @Override
        protected void updateItem(@Nullable Problem problem, boolean empty) {
            super.updateItem(problem, empty);
            setWrapText(true);
            setPrefWidth(0);
            setText(empty || problem == null ? ""
                    : Messages.tr("Line {0}, column {1}:  {2}", problem.line(), problem.column(), problem.message()));
        }
    }
}
