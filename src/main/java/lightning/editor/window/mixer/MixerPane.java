package lightning.editor.window.mixer;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.scene.Node;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Texts;
import lightning.editor.document.Channel;
import lightning.editor.document.Workbench;
import lightning.editor.loop.Frame;
import lightning.editor.window.command.AtOnce;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.Slices;
import lightning.editor.window.widget.WhileSeen;
import lightning.scene.Scene;

/**
 * The light mixer: a strip for each light, each bank and the environment, in the order of the scene, and a master. A click on a strip's
 * head selects it, with Ctrl more, with Shift all between; a drag of the head puts the light to another place.
 */
public final class MixerPane extends VBox {
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final Executor window;
    private final Board board;
    private final ShareFeed feed;
    /** In the order of the scene; those that are still to be made have no strip. */
    private List<Channel> channels = List.of();
    private final Map<Channel, Strip> strips = new HashMap<>();
    private final Slices making = new Slices(this::makeNext);
    private final HBox row = new HBox();
    private final MasterStrip master;
    private final TextField search = new TextField();
    private final ChoiceBox<StripFilter> filter = new ChoiceBox<>();
    private final Label count = new Label();
    private SharePictures pictures;
    private Frame looked;

    /** @param window runs tasks in turn on the window's thread */
    public MixerPane(SceneEditor editor, TracedPicture picture, Workbench workbench, Executor window) {
        this.editor = editor;
        this.picture = picture;
        this.window = window;
        board = new Board(editor);
        feed = new ShareFeed(workbench, picture.viewProperty(), window, this::show);
        master = new MasterStrip(board);
        setId("mixer");
        getStyleClass().add("mixer");
        row.getStyleClass().add("strips");
        row.setId("strips");
        new StripDrag(board, this::shown).on(row);
        var scroll = new ScrollPane(row);
        scroll.setFitToHeight(true);
        scroll.getStyleClass().add("edge-to-edge");
        HBox.setHgrow(scroll, Priority.ALWAYS);
        var desk = new HBox(scroll, master);
        VBox.setVgrow(desk, Priority.ALWAYS);
        getChildren().addAll(tools(), desk);
        addEventHandler(KeyEvent.KEY_PRESSED, this::key);
        board.selectedProperty().subscribe(_ -> choose());
        WhileSeen.follow(this, this::follow);
    }

    /** Follows the scene and the picture. */
    private Subscription follow() {
        // The keyboard is at a fader, and not in the search; what scrolls is in the window only when that has its looks.
        window.execute(() -> shown().stream().findFirst().ifPresent(strip -> strip.fader().requestFocus()));
        return Subscription.combine(editor.sceneProperty().subscribe(this::show),
                picture.renderingProperty().subscribe(state -> look(state.frame())),
                picture.viewProperty().subscribe(_ -> feed.look()),
                editor.selection().lightProperty().subscribe(light -> {
                    if (light != null) {
                        board.follow(light);
                    }
                }), AtOnce.whileFocused(this, editor, window), making::end, feed::close);
    }

    private Node tools() {
        search.setId("mixer-search");
        search.setPromptText(Texts.of("Search"));
        search.setAccessibleText(Texts.of("search strips by name or type"));
        search.textProperty().subscribe(_ -> arrange());
        filter.setId("mixer-filter");
        filter.setAccessibleText(Texts.of("which strips are shown"));
        filter.getItems().setAll(StripFilter.values());
        filter.setValue(StripFilter.ALL);
        filter.valueProperty().subscribe(_ -> arrange());
        var mode = new ToggleGroup();
        var relative = toggle("relative", Texts.of("Relative"), Texts.of("Several strips change by the same factor"), mode);
        var absolute = toggle("absolute", Texts.of("Absolute"), Texts.of("Several strips get the same value"), mode);
        relative.setSelected(true);
        mode.selectedToggleProperty().addListener((_, before, now) -> {
            if (now == null) {
                mode.selectToggle(before);
            } else {
                board.relativeProperty().set(now == relative);
            }
        });
        count.setId("mixer-count");
        count.getStyleClass().add("pane-note");
        var message = new Label();
        message.setId("mixer-message");
        message.getStyleClass().add("mixer-message");
        message.textProperty().bind(editor.message().textProperty());
        HBox.setHgrow(message, Priority.ALWAYS);
        message.setMaxWidth(Double.MAX_VALUE);
        var tools = new HBox(search, filter, new HBox(relative, absolute), count, message);
        tools.getStyleClass().add("mixer-tools");
        return tools;
    }

    private static ToggleButton toggle(String id, String text, String help, ToggleGroup group) {
        var button = new ToggleButton(text);
        button.setId("mixer-" + id);
        button.setTooltip(new Tooltip(help));
        button.setToggleGroup(group);
        button.setMinWidth(Region.USE_PREF_SIZE);
        return button;
    }

    private void key(KeyEvent e) {
        if (e.isShortcutDown() && e.getCode() == KeyCode.A && !(e.getTarget() instanceof TextField)) {
            board.set(shown().stream().map(Strip::channel).toList());
            e.consume();
        }
    }

    private void look(Frame frame) {
        if (frame != null && frame != looked) {
            looked = frame;
            feed.look();
        }
    }

    private void show(Scene scene) {
        List<Channel> all = Channel.all(scene);
        if (!channels.equals(all)) {
            channels = all;
            strips.keySet().retainAll(all);
            board.set(board.selectedProperty().get().stream().filter(all::contains).toList());
            showPictures();
        }
        strips.values().forEach(strip -> strip.show(scene));
        arrange();
        making.begin();
    }

    /** Makes the strip of the first channel that has none: with many lights all together would hold up the window. */
    private boolean makeNext() {
        Optional<Channel> next = channels.stream().filter(channel -> !strips.containsKey(channel)).findFirst();
        next.ifPresent(channel -> {
            var strip = new Strip(board, channel);
            strips.put(channel, strip);
            strip.show(editor.scene());
            strip.setChosen(board.isSelected(channel));
            showPicture(strip);
            arrange();
            Slices.style(strip);
        });
        return next.isPresent();
    }

    private void show(SharePictures now) {
        pictures = now;
        showPictures();
        master.show(now);
    }

    private void showPictures() {
        strips.values().forEach(this::showPicture);
    }

    private void showPicture(Strip strip) {
        if (pictures != null) {
            strip.show(pictures.of(strip.channel(), editor.scene()));
        }
    }

    private void choose() {
        strips.forEach((channel, strip) -> strip.setChosen(board.isSelected(channel)));
    }

    /** The strips that are seen, from the left. */
    private List<Strip> shown() {
        return row.getChildren().stream().map(Strip.class::cast).toList();
    }

    private void arrange() {
        Scene scene = editor.scene();
        StripFilter chosen = Optional.ofNullable(filter.getValue()).orElse(StripFilter.ALL);
        List<Channel> found = channels.stream().filter(c -> c.isIn(scene))
                .filter(c -> chosen.shows(c, scene) && StripFilter.finds(search.getText(), c, scene)).toList();
        List<Strip> wanted = found.stream().map(strips::get).filter(Objects::nonNull).toList();
        if (!shown().equals(wanted)) {
            put(wanted);
        }
        count.setText(found.size() == channels.size() ? "" : Texts.of("{0} of {1} strips", found.size(), channels.size()));
    }

    /** A strip that is put in again would take on its looks anew. */
    private void put(List<Strip> wanted) {
        List<Node> there = row.getChildren();
        there.retainAll(wanted);
        if (there.equals(wanted.stream().filter(there::contains).toList())) {
            for (int i = 0; i < wanted.size(); i++) {
                if (i == there.size() || there.get(i) != wanted.get(i)) {
                    there.add(i, wanted.get(i));
                }
            }
        } else {
            row.getChildren().setAll(wanted);
        }
    }
}
