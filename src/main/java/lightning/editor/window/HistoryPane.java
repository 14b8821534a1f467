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
import lightning.base.text.Texts;
import lightning.editor.document.History;
import lightning.editor.document.Situation;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.WhileSeen;

/**
 * All edits as a list, the first at the top: a click goes to what was after that edit. What is undone is dimmed. The document's, or those
 * of the selected light alone, which leave the edits of all other lights.
 */
final class HistoryPane extends VBox {
    private static final PseudoClass UNDONE = PseudoClass.getPseudoClass("undone");

    private final SceneEditor editor;
    private final Workbench workbench;
    private final ListView<Row> list = new ListView<>();
    private final ToggleButton document = new ToggleButton(Texts.of("Document"));
    private final ToggleButton light = new ToggleButton(Texts.of("Selected light"));
    private final Label about = new Label();

    /** @param done how many steps are done there */
    private record Row(int done, String text, boolean undone) {}

    HistoryPane(SceneEditor editor, Workbench workbench) {
        this.editor = editor;
        this.workbench = workbench;
        setId("history");
        getStyleClass().add("history");
        var of = new ToggleGroup();
        document.setToggleGroup(of);
        document.setId("history-document");
        light.setToggleGroup(of);
        light.setId("history-light");
        of.selectToggle(document);
        of.selectedToggleProperty().addListener((_, before, now) -> {
            if (now == null) {
                of.selectToggle(before);
            } else {
                show(editor.situationProperty().get());
            }
        });
        about.setId("history-about");
        about.getStyleClass().add("pane-note");
        var head = new HBox(8, document, light, about);
        head.getStyleClass().add("history-head");
        list.setId("history-list");
        list.setAccessibleText(Texts.of("edits"));
        list.getStyleClass().add("edge-to-edge");
        list.setCellFactory(_ -> new Cell());
        list.addEventHandler(KeyEvent.KEY_PRESSED, e -> {
            if (e.getCode() == KeyCode.ENTER || e.getCode() == KeyCode.SPACE) {
                go(list.getSelectionModel().getSelectedItem());
                e.consume();
            }
        });
        setVgrow(list, Priority.ALWAYS);
        getChildren().addAll(head, list);
        WhileSeen.follow(this, () -> editor.situationProperty().subscribe(this::show));
    }

    private void show(Situation now) {
        History history = editor.document().history();
        long id = now.selected().map(l -> history.id(l.name())).orElse(-1L);
        List<String> steps = light.isSelected() ? history.lightSteps(id) : history.steps();
        int position = light.isSelected() ? history.lightPosition(id) : history.position();
        String name = now.selected().map(l -> l.name()).orElse(Texts.of("no light is selected"));
        about.setText(light.isSelected() ? name : "");
        List<Row> rows = IntStream.rangeClosed(0, steps.size())
                .mapToObj(i -> new Row(i,
                        i == 0 ? light.isSelected() ? Texts.of("As it first was") : Texts.of("As it was opened") : steps.get(i - 1),
                        i > position))
                .toList();
        if (!list.getItems().equals(rows)) {
            list.getItems().setAll(rows);
        }
        list.getSelectionModel().clearAndSelect(position);
        list.scrollTo(Math.max(0, position - 3));
    }

    private void go(Row row) {
        if (row == null) {
            return;
        }
        if (editor.isAnimating()) {
            editor.message().show(Texts.of("An animation is open; close it first"));
        } else if (row.done() == list.getItems().stream().filter(r -> !r.undone()).count() - 1) {
            return;
        } else if (light.isSelected()) {
            workbench.goToOfLight(row.done()).ifPresent(editor.message()::show);
        } else {
            workbench.goTo(row.done());
        }
        show(editor.situationProperty().get());
    }

    private final class Cell extends ListCell<Row> {
        Cell() {
            setPrefWidth(0);
            setOnMouseClicked(_ -> {
                if (!isEmpty()) {
                    go(getItem());
                }
            });
        }

        @Override
        protected void updateItem(Row row, boolean empty) {
            super.updateItem(row, empty);
            setText(empty ? "" : row.text());
            pseudoClassStateChanged(UNDONE, !empty && row.undone());
        }
    }
}
