package lightning.app;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.stage.Window;
import lightning.edit.Recovery;
import lightning.jen.JenException;
import lightning.jen.Problem;

/** What the editor tells and asks in windows of their own. */
final class Notices {
    static final ButtonType SAVE = new ButtonType("Save", ButtonData.YES);
    static final ButtonType DISCARD = new ButtonType("Don't Save", ButtonData.NO);
    static final ButtonType GO_FIRST = new ButtonType("Go First", ButtonData.NO);
    static final ButtonType SAVE_AS_IT_IS = new ButtonType("Save As It Is", ButtonData.YES);
    static final ButtonType RECOVER = new ButtonType("Recover", ButtonData.YES);
    static final ButtonType FORGET = new ButtonType("Discard", ButtonData.NO);
    private static final double WIDTH = 560;

    private final Window owner;

    Notices(Window owner) {
        this.owner = owner;
    }

    /** Says that something failed; the window beside lives on. */
    void failed(String what, Throwable why) {
        if (why instanceof JenException wrong) {
            problems(what, wrong.problems());
        } else {
            alert(Alert.AlertType.ERROR, what, Sentence.of(why), ButtonType.CLOSE).show();
        }
    }

    private void problems(String what, List<Problem> problems) {
        Alert alert = alert(Alert.AlertType.ERROR, what, "", ButtonType.CLOSE);
        var list = new ListView<Problem>();
        list.setId("problems");
        list.getItems().setAll(problems);
        list.setCellFactory(_ -> new ProblemCell());
        list.setPrefSize(WIDTH, Math.min(320, 40 + 34 * problems.size()));
        alert.getDialogPane().setContent(list);
        alert.show();
    }

    Optional<ButtonType> unsaved(String name) {
        return alert(Alert.AlertType.CONFIRMATION, "Save the changes of " + name + "?",
                "The scene was edited since it was last saved.", SAVE, DISCARD, ButtonType.CANCEL).showAndWait();
    }

    /** @param remark why the picture is not what the artist may expect: a clause */
    Optional<ButtonType> pending(String remark) {
        return alert(Alert.AlertType.CONFIRMATION, "Save the picture without the last edits?",
                Character.toUpperCase(remark.charAt(0)) + remark.substring(1) + ".", SAVE_AS_IT_IS, GO_FIRST, ButtonType.CANCEL)
                .showAndWait();
    }

    Optional<ButtonType> recover(Recovery.Found found) {
        return alert(Alert.AlertType.CONFIRMATION, "Recover unsaved edits of " + found.file().getFileName() + "?",
                "Lightning ended before they were saved to " + found.file() + ".", RECOVER, FORGET).showAndWait();
    }

    void text(String title, String text) {
        alert(Alert.AlertType.INFORMATION, title, text, ButtonType.CLOSE).show();
    }

    private Alert alert(Alert.AlertType type, String header, String text, ButtonType... buttons) {
        var alert = new Alert(type, "", buttons);
        alert.initOwner(owner);
        alert.setTitle("Lightning");
        alert.setHeaderText(header);
        var content = new Label(text);
        content.setWrapText(true);
        content.setMaxWidth(WIDTH);
        alert.getDialogPane().setContent(content);
        alert.getDialogPane().setMinHeight(javafx.scene.layout.Region.USE_PREF_SIZE);
        return alert;
    }

    /** Line and column, then what is wrong. */
    private static final class ProblemCell extends javafx.scene.control.ListCell<Problem> {
        @Override
        protected void updateItem(Problem problem, boolean empty) {
            super.updateItem(problem, empty);
            setWrapText(true);
            setPrefWidth(0);
            setText(empty || problem == null ? "" : "Line " + problem.line() + ", column " + problem.column() + ":  " + problem.message());
        }
    }
}
