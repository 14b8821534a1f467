package lightning.editor.window.welcome;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javafx.beans.property.BooleanProperty;
import javafx.collections.ListChangeListener;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.OverrunStyle;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.shape.Rectangle;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.editor.Command;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.model.CommandRegistry;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;

/** Page next to the traced picture: ways to begin, lessons, recent files, and the scenes that come with the program. */
public final class WelcomePane extends BorderPane {
    private static final double GAP = 8;
    private static final double THUMBNAIL_WIDTH = ShippedScene.THUMBNAIL_WIDTH / 2.0;
    private static final double THUMBNAIL_HEIGHT = ShippedScene.THUMBNAIL_HEIGHT / 2.0;
    private static final double THUMBNAIL_ARC = 6;
    private static final int MAX_RECENT = 5;

    private final FileActions files;
    private final Runnable close;
    private final Button open =
            action("welcome-open", Messages.tr("Open Your Model…"), MaterialDesignF.FOLDER_OPEN_OUTLINE.getDescription());
    private final VBox recent = new VBox();
    private final Label recentTitle = heading(Messages.tr("Recent Files"));

    /**
     * @param showAtStart if the page opens at the next start
     * @param close closes the page
     */
    public WelcomePane(FileActions files, CommandRegistry commands, LessonBar lessons, BooleanProperty showAtStart, Runnable close) {
        this.files = files;
        this.close = close;
        setId("welcome");
        getStyleClass().add("welcome");
        open.getStyleClass().add("accent");
        open.setTooltip(new Tooltip(Messages.tr("Open a scene, or import a glTF, USD, OBJ, PLY, NFF, FBX or other file")));
        open.setOnAction(_ -> commands.run(Command.LOAD_FILE));
        Button studio = action("welcome-new", Messages.tr("New Studio"), Command.NEW_SCENE.icon());
        studio.setTooltip(new Tooltip(Command.NEW_SCENE.help()));
        studio.setOnAction(_ -> commands.run(Command.NEW_SCENE));
        var lessonRows = new VBox();
        for (Lesson lesson : Lesson.ALL) {
            lessonRows.getChildren().add(lessonRow(lesson, chosen -> {
                close.run();
                lessons.start(chosen);
            }));
        }
        var scenes = new FlowPane(GAP, GAP);
        ShippedScene.ALL.forEach(scene -> scenes.getChildren().add(sceneCard(scene)));
        recent.setId("welcome-recent");
        files.recentFiles().addListener((ListChangeListener<Path>) _ -> showRecent());
        showRecent();
        var begin = new FlowPane(GAP, GAP, open, studio);
        var content = new VBox(GAP, begin, heading(Messages.tr("Lessons")), lessonRows, recentTitle, recent,
                heading(Messages.tr("Scenes")), scenes);
        content.getStyleClass().add("welcome-content");
        var scroll = new ScrollPane(content);
        scroll.setFitToWidth(true);
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        scroll.setFocusTraversable(false);
        scroll.getStyleClass().add("edge-to-edge");
        setTop(header());
        setCenter(scroll);
        setBottom(footer(showAtStart));
        addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close.run();
                event.consume();
            }
        });
        sceneProperty().flatMap(s -> s.focusOwnerProperty()).subscribe(_ -> scrollToFocus(scroll));
    }

    /** Focuses the first button. */
    public void focus() {
        applyCss();
        open.requestFocus();
    }

    private HBox header() {
        var title = new Label(Messages.tr("Welcome to Lightning"));
        title.getStyleClass().add("welcome-title");
        title.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(title, Priority.ALWAYS);
        var closeButton = new Button("", new FontIcon(MaterialDesignC.CLOSE));
        closeButton.setId("welcome-close");
        closeButton.getStyleClass().addAll("flat", "button-icon");
        closeButton.setAccessibleText(Messages.tr("Close"));
        closeButton.setTooltip(new Tooltip(Messages.tr("Close this page (Esc); File > Welcome opens it again")));
        closeButton.setOnAction(_ -> close.run());
        var header = new HBox(title, closeButton);
        header.setAlignment(Pos.CENTER_LEFT);
        header.getStyleClass().add("welcome-header");
        return header;
    }

    private static HBox footer(BooleanProperty showAtStart) {
        var box = new CheckBox(Messages.tr("Show at start"));
        box.setId("welcome-show");
        box.selectedProperty().bindBidirectional(showAtStart);
        var footer = new HBox(box);
        footer.getStyleClass().add("welcome-footer");
        return footer;
    }

    private static Label heading(String text) {
        var label = new Label(text);
        label.getStyleClass().add("welcome-heading");
        return label;
    }

    private static Button action(String id, String text, String icon) {
        var button = new Button(text, new FontIcon(icon));
        button.setId(id);
        return button;
    }

    private static Button lessonRow(Lesson lesson, Consumer<Lesson> start) {
        String summary = Messages.tr(lesson.summary());
        Button row = row(Messages.tr(lesson.title()), summary, Messages.tr(lesson.title()) + ": " + summary);
        row.setId("lesson-" + Lesson.ALL.indexOf(lesson));
        row.setOnAction(_ -> start.accept(lesson));
        return row;
    }

    private Button sceneCard(ShippedScene scene) {
        var picture = new ImageView(scene.thumbnail());
        picture.setFitWidth(THUMBNAIL_WIDTH);
        picture.setFitHeight(THUMBNAIL_HEIGHT);
        var corners = new Rectangle(THUMBNAIL_WIDTH, THUMBNAIL_HEIGHT);
        corners.setArcWidth(THUMBNAIL_ARC);
        corners.setArcHeight(THUMBNAIL_ARC);
        picture.setClip(corners);
        var title = new Label(Messages.tr(scene.title()));
        title.setMaxWidth(THUMBNAIL_WIDTH);
        Button card = card("scene-" + scene.name(), new VBox(GAP / 2, picture, title), title.getText());
        card.setOnAction(_ -> files.openCopy(scene.file()));
        return card;
    }

    private static Button card(String id, Node content, String name) {
        var card = new Button("", content);
        card.setId(id);
        card.getStyleClass().add("welcome-card");
        card.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
        card.setAccessibleText(name);
        return card;
    }

    private void showRecent() {
        List<Path> shown = files.recentFiles().stream().limit(MAX_RECENT).toList();
        recent.getChildren().setAll(shown.stream().map(this::recentRow).toList());
        for (Region part : List.of(recentTitle, recent)) {
            part.setVisible(!shown.isEmpty());
            part.setManaged(!shown.isEmpty());
        }
    }

    private Button recentRow(Path file) {
        Button row = row(Quote.path(file.getFileName()), Quote.path(ParentFolder.of(file)), Quote.path(file));
        row.setTooltip(new Tooltip(Quote.path(file)));
        row.setOnAction(_ -> files.load(file));
        return row;
    }

    /** Creates a row with a name and a note, which is shortened if it does not fit. */
    private static Button row(String name, String note, String accessibleText) {
        var title = new Label(name);
        title.setMinWidth(USE_PREF_SIZE);
        var details = new Label(note);
        details.getStyleClass().add("pane-note");
        details.setTextOverrun(OverrunStyle.CENTER_ELLIPSIS);
        details.setMinWidth(0);
        var row = new Button("", new HBox(GAP, title, details));
        row.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
        row.setAccessibleText(accessibleText);
        row.getStyleClass().addAll("flat", "welcome-row");
        row.setAlignment(Pos.CENTER_LEFT);
        row.setMaxWidth(Double.MAX_VALUE);
        row.setMinWidth(0);
        return row;
    }

    /** Scrolls the focused button into view. */
    private void scrollToFocus(ScrollPane scroll) {
        Node focused = getScene() == null ? null : getScene().getFocusOwner();
        Node content = scroll.getContent();
        if (focused == null || !isInside(focused, content)) {
            return;
        }
        double hidden = content.getLayoutBounds().getHeight() - scroll.getViewportBounds().getHeight();
        if (hidden > 0) {
            var bounds = content.sceneToLocal(focused.localToScene(focused.getLayoutBounds()));
            double top = scroll.getVvalue() * hidden;
            double wanted =
                    Math.clamp(top, Math.min(bounds.getMinY() - GAP, bounds.getMaxY() + GAP - scroll.getViewportBounds().getHeight()),
                            Math.max(bounds.getMinY() - GAP, bounds.getMaxY() + GAP - scroll.getViewportBounds().getHeight()));
            scroll.setVvalue(Math.clamp(wanted / hidden, 0, 1));
        }
    }

    private static boolean isInside(Node node, Node ancestor) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (n == ancestor) {
                return true;
            }
        }
        return false;
    }
}
