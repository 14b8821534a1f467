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
import lightning.base.text.Messages;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.KeyBindings;
import lightning.editor.window.widget.ColorTheme;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;

/** Command palette: finds commands by letters of their titles. Enter runs the selected entry; a disabled one shows its reason. */
public final class CommandPalette extends Stage {
    private static final double WIDTH = 560;
    private static final double HEIGHT = 420;
    private static final double FROM_TOP = 80;
    private static final double GAP = 8;

    private final KeyBindings keys;
    private final List<PaletteEntry> entries;
    private final TextField query = new TextField();
    private final ListView<PaletteEntry> matches = new ListView<>();
    private final Label description = new Label();

    private CommandPalette(Window owner, MenuBar bar, CommandRegistry commands) {
        super(StageStyle.UNDECORATED);
        keys = commands.keyBindings();
        entries = PaletteEntry.all(bar, commands);
        initOwner(owner);
        setTitle(Messages.tr("Find Command"));
        query.setId("palette-query");
        query.setAccessibleText(Messages.tr("Search commands"));
        query.setPromptText(Messages.tr("Search commands"));
        query.textProperty().subscribe(this::search);
        query.addEventFilter(KeyEvent.KEY_PRESSED, this::press);
        matches.setId("palette-found");
        matches.setAccessibleText(Messages.tr("commands"));
        matches.setFocusTraversable(false);
        matches.getStyleClass().add("edge-to-edge");
        matches.setPlaceholder(new Label(Messages.tr("No matching commands")));
        matches.setCellFactory(_ -> new Row());
        matches.getSelectionModel().selectedItemProperty().subscribe(this::showDescription);
        VBox.setVgrow(matches, Priority.ALWAYS);
        description.setId("palette-about");
        description.getStyleClass().add("about-lines");
        description.setWrapText(true);
        description.setMinHeight(Region.USE_PREF_SIZE);
        description.setMaxWidth(Double.MAX_VALUE);
        var content = new VBox(query, matches, description);
        content.setId("palette");
        content.getStyleClass().add("palette");
        Scene scene = ColorTheme.scene(content, WIDTH, HEIGHT);
        setScene(scene);
        setX(owner.getX() + (owner.getWidth() - WIDTH) / 2);
        setY(owner.getY() + Math.min(FROM_TOP, Math.max(0, owner.getHeight() - HEIGHT)));
        focusedProperty().addListener((_, was, is) -> {
            if (was && !is) {
                close();
            }
        });
    }

    /** Opens the palette over a window. It closes after running a command, on Escape, or when it loses focus. */
    public static void open(Window owner, MenuBar bar, CommandRegistry commands) {
        new CommandPalette(owner, bar, commands).show();
    }

    private void search(String letters) {
        matches.getItems().setAll(PaletteEntry.matching(entries, letters));
        if (letters.isBlank()) {
            // Enter before any letter must not run a command that the user has not read yet.
            matches.getSelectionModel().clearSelection();
        } else {
            matches.getSelectionModel().selectFirst();
        }
        matches.scrollTo(0);
    }

    private void showDescription(@Nullable PaletteEntry entry) {
        description.setText(
                entry == null ? ""
                        : entry.command().help() + "."
                                + entry.disabledReason().map(r -> Messages.tr("\nUnavailable: {0}.", r)).orElse("\n"));
    }

    private void press(KeyEvent e) {
        if (e.getCode() == KeyCode.ESCAPE) {
            close();
        } else if (e.getCode() == KeyCode.ENTER) {
            runEntry(matches.getSelectionModel().getSelectedItem());
        } else if (e.getCode() == KeyCode.DOWN) {
            moveSelection(1);
        } else if (e.getCode() == KeyCode.UP) {
            moveSelection(-1);
        } else {
            return;
        }
        e.consume();
    }

    private void moveSelection(int step) {
        int to = Math.clamp(matches.getSelectionModel().getSelectedIndex() + (long) step, 0, Math.max(0, matches.getItems().size() - 1));
        matches.getSelectionModel().clearAndSelect(to);
        matches.scrollTo(Math.max(0, to - 3));
    }

    private void runEntry(@Nullable PaletteEntry entry) {
        if (entry != null && entry.disabledReason().isEmpty()) {
            close();
            entry.action().run();
        }
    }

    private final class Row extends ListCell<PaletteEntry> {
        private final FontIcon icon = new FontIcon();
        private final Label title = new Label();
        private final Label menuPath = new Label();
        private final Label key = new Label();
        /** The center shrinks first. */
        private final BorderPane row = new BorderPane(menuPath);

        Row() {
            menuPath.getStyleClass().add("pane-note");
            BorderPane.setAlignment(menuPath, Pos.CENTER_LEFT);
            BorderPane.setMargin(menuPath, new Insets(0, GAP, 0, GAP));
            key.getStyleClass().add("palette-key");
            BorderPane.setAlignment(key, Pos.CENTER);
            var first = new HBox(GAP, icon, title);
            first.setAlignment(Pos.CENTER_LEFT);
            row.setLeft(first);
            row.setRight(key);
            setPrefWidth(0);
            setOnMouseClicked(_ -> runEntry(getItem()));
        }

        @Override
        protected void updateItem(PaletteEntry entry, boolean empty) {
            super.updateItem(entry, empty);
            setGraphic(empty ? null : row);
            if (!empty) {
                icon.setIconLiteral(entry.command().icon());
                title.setText(entry.title());
                menuPath.setText(entry.menuPath());
                key.setText(keys.text(entry.command()));
                key.setVisible(!key.getText().isEmpty());
                key.setManaged(key.isVisible());
                // Note color rather than lower opacity, which would be unreadable.
                title.getStyleClass().setAll("label", entry.disabledReason().isEmpty() ? "palette-title" : "pane-note");
                setAccessibleText(entry.title() + entry.disabledReason().map(r -> Messages.tr(", unavailable: {0}", r)).orElse(""));
            }
        }
    }
}
