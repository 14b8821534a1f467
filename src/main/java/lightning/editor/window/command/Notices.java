package lightning.editor.window.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.Node;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.layout.Region;
import javafx.stage.Window;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.editor.document.FileThread;
import lightning.editor.document.Recovery;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.OnScreen;
import lightning.format.exchange.LightUnits;
import lightning.format.jen.JenException;
import lightning.format.jen.Problem;
import lightning.render.image.Film;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignH;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;

/** What the editor tells and asks in windows of their own. */
public final class Notices {
    static final ButtonType SAVE = new ButtonType(Texts.of("Save"), ButtonData.YES);
    static final ButtonType DISCARD = new ButtonType(Texts.of("Don't Save"), ButtonData.NO);
    static final ButtonType GO_FIRST = new ButtonType(Texts.of("Go First"), ButtonData.NO);
    static final ButtonType SAVE_AS_IT_IS = new ButtonType(Texts.of("Save As It Is"), ButtonData.YES);
    public static final ButtonType RECOVER = new ButtonType(Texts.of("Recover"), ButtonData.YES);
    public static final ButtonType FORGET = new ButtonType(Texts.of("Discard"), ButtonData.NO);
    static final ButtonType OVERWRITE = new ButtonType(Texts.of("Overwrite"), ButtonData.YES);
    static final ButtonType REPLACE = new ButtonType(Texts.of("Replace"), ButtonData.YES);
    static final ButtonType SAVE_AS = new ButtonType(Texts.of("Save As…"), ButtonData.OTHER);
    static final ButtonType RELOAD = new ButtonType(Texts.of("Take the File's"), ButtonData.NO);
    private static final ButtonType LATER = new ButtonType(Texts.of("Ask Later"), ButtonData.CANCEL_CLOSE);
    private static final double WIDTH = 560;
    /** What a dialog's content has beside it, of the dialog and of its window, at most. */
    private static final double FRAME = 40;
    private static final double LIST_HEIGHT = 320;
    private static final double ROW_HEIGHT = 36;

    private static final int ICON = 28;

    private final Window owner;

    public Notices(Window owner) {
        this.owner = owner;
    }

    /** Says that something failed; the window beside lives on. */
    public void failed(String what, Throwable why) {
        failure(what, why).show();
    }

    /** The same, and goes on when it was read. */
    public void failedAndRead(String what, Throwable why) {
        failure(what, why).showAndWait();
    }

    private Alert failure(String what, Throwable why) {
        return why instanceof JenException wrong ? problems(what, wrong.problems())
                : alert(Alert.AlertType.ERROR, what, Sentence.of(why), ButtonType.CLOSE);
    }

    private Alert problems(String what, List<Problem> problems) {
        Alert alert = alert(Alert.AlertType.ERROR, what, "", ButtonType.CLOSE);
        var list = new ListView<Problem>();
        list.setId("problems");
        list.setAccessibleText(Texts.of("What is wrong with the file"));
        list.getItems().setAll(problems);
        list.setCellFactory(_ -> new ProblemCell());
        list.setPrefSize(WIDTH, Math.min(LIST_HEIGHT, ROW_HEIGHT * (problems.size() + 1)));
        alert.getDialogPane().setContent(list);
        return alert;
    }

    Optional<ButtonType> unsaved(String name) {
        return alert(Alert.AlertType.CONFIRMATION, Texts.of("Save the changes of {0}?", name),
                Texts.of("The scene was edited since it was last saved."), SAVE, DISCARD, ButtonType.CANCEL).showAndWait();
    }

    /** @param remark why the picture is not what the artist may expect: a clause */
    Optional<ButtonType> pending(String remark) {
        return alert(Alert.AlertType.CONFIRMATION, Texts.of("Save the picture as it is?"),
                Character.toUpperCase(remark.charAt(0)) + remark.substring(1) + ".", SAVE_AS_IT_IS, GO_FIRST, ButtonType.CANCEL)
                .showAndWait();
    }

    public Optional<ButtonType> recover(Recovery.Found found) {
        return alert(Alert.AlertType.CONFIRMATION, Texts.of("Recover unsaved edits of {0}?", Quote.path(found.file().getFileName())),
                Texts.of("Lightning ended before they were saved to {0}.", Quote.path(found.file())), RECOVER, FORGET, LATER)
                .showAndWait();
    }

    /** @param both the open scene beside the file */
    Optional<ButtonType> changed(String name, Node both) {
        Alert alert = alert(Alert.AlertType.CONFIRMATION, Texts.of("{0} was changed by another program", name),
                "", OVERWRITE, SAVE_AS, RELOAD, ButtonType.CANCEL);
        alert.getDialogPane().setContent(both);
        alert.setResizable(true);
        return alert.showAndWait();
    }

    /**
     * Asks what the numbers of a file's lights are.
     *
     * @param pictures what each choice makes of them
     * @return empty where the artist thought better of it
     */
    Optional<LightUnits> lightUnits(Path file, Map<LightUnits, Film> pictures) {
        Alert alert =
                alert(Alert.AlertType.CONFIRMATION, Texts.of("Which of these is {0}?", Quote.path(file.getFileName())), "",
                        ButtonType.CANCEL);
        var cards = new LightUnitCards(pictures, OnScreen.of(owner).getWidth() - FRAME, alert::close);
        alert.getDialogPane().setContent(cards);
        alert.showAndWait();
        return cards.chosen();
    }

    Optional<ButtonType> readOnly(Path file) {
        return alert(Alert.AlertType.CONFIRMATION, Texts.of("Replace {0}, which is read-only?", Quote.path(file.getFileName())),
                Texts.of("Somebody wanted it to stay as it is. If you replace it, it is read-only again."), REPLACE, SAVE_AS,
                ButtonType.CANCEL).showAndWait();
    }

    /**
     * Adds the ending of a kind of files to a chosen name that lacks it. Asks before a file of the longer name is replaced: the system's
     * dialog asked about the name as it was typed only.
     *
     * @param then gets the file, unless the artist wants to keep the one that exists
     */
    void withEnding(FileThread files, Path chosen, String ending, Consumer<Path> then) {
        if (chosen.getFileName().toString().endsWith(ending)) {
            then.accept(chosen);
            return;
        }
        Path file = chosen.resolveSibling(chosen.getFileName() + ending);
        files.beside(() -> Files.exists(file), there -> {
            if (!there || mayReplace(file)) {
                then.accept(file);
            }
        }, why -> failed(Texts.of("{0} could not be looked at", Quote.path(file)), why));
    }

    private boolean mayReplace(Path file) {
        return alert(Alert.AlertType.CONFIRMATION, Texts.of("Replace {0}?", Quote.path(file.getFileName())),
                Texts.of("{0} is there already.", Quote.path(file)), REPLACE, ButtonType.CANCEL).showAndWait().filter(REPLACE::equals)
                .isPresent();
    }

    public void text(String title, String text) {
        alert(Alert.AlertType.INFORMATION, title, text, ButtonType.CLOSE).show();
    }

    private Alert alert(Alert.AlertType type, String header, String text, ButtonType... buttons) {
        var alert = new Alert(type, "", buttons);
        alert.initOwner(owner);
        alert.setTitle("Lightning");
        alert.setHeaderText(header);
        Ikon icon = switch (type) {
            case ERROR -> MaterialDesignA.ALERT_CIRCLE_OUTLINE;
            case CONFIRMATION -> MaterialDesignH.HELP_CIRCLE_OUTLINE;
            case INFORMATION, WARNING, NONE -> MaterialDesignI.INFORMATION_OUTLINE;
        };
        alert.setGraphic(FontIcon.of(icon, ICON));
        alert.getDialogPane().setContent(new Sentences(text));
        alert.getDialogPane().setMinHeight(Region.USE_PREF_SIZE);
        alert.setOnShown(_ -> OnScreen.fit(alert.getDialogPane().getScene().getWindow()));
        return alert;
    }

    /** Lines that are no longer than can be read, also where a dialog asks how wide they are to set itself in the middle of its window. */
    private static final class Sentences extends Label {
        Sentences(String text) {
            super(text);
            setWrapText(true);
        }

        @Override
        protected double computePrefWidth(double height) {
            return Math.min(super.computePrefWidth(height), WIDTH);
        }
    }

    /** Line and column, then what is wrong. */
    private static final class ProblemCell extends ListCell<Problem> {
        @Override
        protected void updateItem(Problem problem, boolean empty) {
            super.updateItem(problem, empty);
            setWrapText(true);
            setPrefWidth(0);
            setText(empty || problem == null ? ""
                    : Texts.of("Line {0}, column {1}:  {2}", problem.line(), problem.column(), problem.message()));
        }
    }
}
