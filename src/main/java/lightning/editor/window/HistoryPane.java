package lightning.editor.window;

import java.util.List;
import java.util.stream.IntStream;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.EditHistory;
import lightning.editor.EditorState;
import lightning.editor.Workbench;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.VisibilityListener;
import org.jspecify.annotations.Nullable;

/**
 * List of all edits, newest first. Clicking an entry restores the state after that edit; undone edits are dimmed. Shows the edits of the
 * document, or of the selected light only, which leave all other lights unchanged.
 */
final class HistoryPane extends VBox {
    private static final PseudoClass UNDONE = PseudoClass.getPseudoClass("undone");

    private final SceneEditor editor;
    private final Workbench workbench;
    private final ListView<Row> list = new ListView<>();
    private final ToggleButton documentToggle = new ToggleButton(Messages.tr("Document"));
    private final ToggleButton lightToggle = new ToggleButton(Messages.tr("Selected light"));
    private final Label lightName = new Label();

    /**
     * Entry of the list.
     *
     * @param position number of applied edits at this entry
     */
    private record Row(int position, String text, boolean isUndone) {}

    HistoryPane(SceneEditor editor, Workbench workbench) {
        this.editor = editor;
        this.workbench = workbench;
        setId("history");
        getStyleClass().add("history");
        var toggles = new ToggleGroup();
        documentToggle.setToggleGroup(toggles);
        documentToggle.setId("history-document");
        lightToggle.setToggleGroup(toggles);
        lightToggle.setId("history-light");
        toggles.selectToggle(documentToggle);
        toggles.selectedToggleProperty().addListener((_, before, now) -> {
            if (now == null) {
                toggles.selectToggle(before);
            } else {
                show(editor.editorStateProperty().get());
            }
        });
        lightName.setId("history-about");
        lightName.getStyleClass().add("pane-note");
        var header = new HBox(8, documentToggle, lightToggle, lightName);
        header.getStyleClass().add("history-head");
        list.setId("history-list");
        list.setAccessibleText(Messages.tr("edits"));
        list.getStyleClass().add("edge-to-edge");
        list.setCellFactory(_ -> new Cell());
        list.addEventHandler(KeyEvent.KEY_PRESSED, e -> {
            if (e.getCode() == KeyCode.ENTER || e.getCode() == KeyCode.SPACE) {
                goTo(list.getSelectionModel().getSelectedItem());
                e.consume();
            }
        });
        setVgrow(list, Priority.ALWAYS);
        getChildren().addAll(header, list);
        VisibilityListener.attach(this, () -> editor.editorStateProperty().subscribe(this::show));
    }

    private void show(EditorState state) {
        EditHistory history = editor.document().history();
        long id = state.selectedLight().map(l -> history.id(l.name())).orElse(-1L);
        List<String> steps = lightToggle.isSelected() ? history.lightSteps(id) : history.steps();
        int position = lightToggle.isSelected() ? history.lightPosition(id) : history.position();
        String name = state.selectedLight().map(l -> l.name()).orElse(Messages.tr("no light is selected"));
        lightName.setText(lightToggle.isSelected() ? name : "");
        List<Row> rows = IntStream.rangeClosed(0, steps.size())
                .mapToObj(i -> new Row(i,
                        i == 0 ? Messages.tr("Opened") : steps.get(i - 1), i > position))
                .toList();
        if (!list.getItems().equals(rows)) {
            list.getItems().setAll(rows);
        }
        list.getSelectionModel().clearAndSelect(position);
        list.scrollTo(Math.max(0, position - 3));
    }

    private void goTo(@Nullable Row row) {
        if (row == null) {
            return;
        }
        if (row.position() == list.getItems().stream().filter(r -> !r.isUndone()).count() - 1) {
            return;
        } else if (lightToggle.isSelected()) {
            workbench.goToLightStep(row.position()).ifPresent(editor.message()::show);
        } else {
            workbench.goTo(row.position());
        }
        show(editor.editorStateProperty().get());
    }

    private final class Cell extends ListCell<Row> {
        Cell() {
            setPrefWidth(0);
            setOnMouseClicked(_ -> {
                if (!isEmpty()) {
                    goTo(getItem());
                }
            });
        }

        @Override
        protected void updateItem(Row row, boolean empty) {
            super.updateItem(row, empty);
            setText(empty ? "" : row.text());
            pseudoClassStateChanged(UNDONE, !empty && row.isUndone());
        }
    }
}
