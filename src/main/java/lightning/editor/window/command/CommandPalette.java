package lightning.editor.window.command;

import java.util.List;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.MenuBar;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.stage.StageStyle;
import javafx.stage.Window;
import lightning.base.text.Texts;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.Keys;
import lightning.editor.window.widget.Looks;
import org.kordamp.ikonli.javafx.FontIcon;

/** All commands by a few letters of their names: Enter does the first that fits, and one that has nothing to do says why. */
public final class CommandPalette extends Stage {
    private static final double WIDTH = 560;
    private static final double HEIGHT = 420;
    private static final double FROM_TOP = 80;
    private static final double GAP = 8;

    private final Keys keys;
    private final List<Offer> all;
    private final TextField query = new TextField();
    private final ListView<Offer> found = new ListView<>();
    private final Label about = new Label();

    private CommandPalette(Window owner, MenuBar bar, Commands commands) {
        super(StageStyle.UNDECORATED);
        keys = commands.keys();
        all = Offer.all(bar, commands);
        initOwner(owner);
        setTitle(Texts.of("Find Command"));
        query.setId("palette-query");
        query.setAccessibleText(Texts.of("Letters of a command's name"));
        query.setPromptText(Texts.of("Letters of a command's name"));
        query.textProperty().subscribe(this::search);
        query.addEventFilter(KeyEvent.KEY_PRESSED, this::press);
        found.setId("palette-found");
        found.setAccessibleText(Texts.of("commands"));
        found.setFocusTraversable(false);
        found.getStyleClass().add("edge-to-edge");
        found.setPlaceholder(new Label(Texts.of("No command has these letters")));
        found.setCellFactory(_ -> new Row());
        found.getSelectionModel().selectedItemProperty().subscribe(this::tell);
        VBox.setVgrow(found, Priority.ALWAYS);
        about.setId("palette-about");
        about.getStyleClass().add("about-lines");
        about.setWrapText(true);
        about.setMinHeight(Region.USE_PREF_SIZE);
        about.setMaxWidth(Double.MAX_VALUE);
        var content = new VBox(query, found, about);
        content.setId("palette");
        content.getStyleClass().add("palette");
        Scene scene = Looks.scene(content, WIDTH, HEIGHT);
        setScene(scene);
        setX(owner.getX() + (owner.getWidth() - WIDTH) / 2);
        setY(owner.getY() + Math.min(FROM_TOP, Math.max(0, owner.getHeight() - HEIGHT)));
        focusedProperty().addListener((_, was, is) -> {
            if (was && !is) {
                close();
            }
        });
    }

    /** Opens over a window; it closes when something was done, or by Escape, or when it is left. */
    public static void open(Window owner, MenuBar bar, Commands commands) {
        new CommandPalette(owner, bar, commands).show();
    }

    private void search(String letters) {
        found.getItems().setAll(Offer.fitting(all, letters));
        found.getSelectionModel().selectFirst();
        found.scrollTo(0);
    }

    private void tell(Offer offer) {
        about.setText(
                offer == null ? "" : offer.command().help() + "." + offer.reason().map(r -> Texts.of("\nNot now: {0}.", r)).orElse("\n"));
    }

    private void press(KeyEvent e) {
        if (e.getCode() == KeyCode.ESCAPE) {
            close();
        } else if (e.getCode() == KeyCode.ENTER) {
            take(found.getSelectionModel().getSelectedItem());
        } else if (e.getCode() == KeyCode.DOWN) {
            go(1);
        } else if (e.getCode() == KeyCode.UP) {
            go(-1);
        } else {
            return;
        }
        e.consume();
    }

    private void go(int way) {
        int to = Math.clamp(found.getSelectionModel().getSelectedIndex() + (long) way, 0, Math.max(0, found.getItems().size() - 1));
        found.getSelectionModel().clearAndSelect(to);
        found.scrollTo(Math.max(0, to - 3));
    }

    private void take(Offer offer) {
        if (offer != null && offer.reason().isEmpty()) {
            close();
            offer.action().run();
        }
    }

    private final class Row extends ListCell<Offer> {
        private final FontIcon icon = new FontIcon();
        private final Label title = new Label();
        private final Label place = new Label();
        private final Label key = new Label();
        /** What stands in its middle gives way. */
        private final BorderPane row = new BorderPane(place);

        Row() {
            place.getStyleClass().add("pane-note");
            BorderPane.setAlignment(place, Pos.CENTER_LEFT);
            BorderPane.setMargin(place, new Insets(0, GAP, 0, GAP));
            key.getStyleClass().add("palette-key");
            BorderPane.setAlignment(key, Pos.CENTER);
            var first = new HBox(GAP, icon, title);
            first.setAlignment(Pos.CENTER_LEFT);
            row.setLeft(first);
            row.setRight(key);
            setPrefWidth(0);
            setOnMouseClicked(_ -> take(getItem()));
        }

        @Override
        protected void updateItem(Offer offer, boolean empty) {
            super.updateItem(offer, empty);
            setGraphic(empty ? null : row);
            if (!empty) {
                icon.setIconLiteral(offer.command().icon());
                title.setText(offer.title());
                place.setText(offer.place());
                key.setText(keys.text(offer.command()));
                key.setVisible(!key.getText().isEmpty());
                key.setManaged(key.isVisible());
                // As the notes are, which can be read; half as opaque it could not.
                title.getStyleClass().setAll("label", offer.reason().isEmpty() ? "palette-title" : "pane-note");
                setAccessibleText(offer.title() + offer.reason().map(r -> Texts.of(", not now: {0}", r)).orElse(""));
            }
        }
    }
}
