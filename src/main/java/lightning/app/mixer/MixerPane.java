package lightning.app.mixer;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
import lightning.app.model.EditorModel;
import lightning.app.widget.WhileSeen;
import lightning.edit.Channel;
import lightning.edit.loop.Frame;
import lightning.scene.Scene;
import lightning.text.Texts;

/**
 * The light mixer: a strip for each light, each bank and the environment, in the order of the scene, and a master. A click on a strip's
 * head selects it, with Ctrl more, with Shift all between; a drag of the head puts the light to another place.
 */
public final class MixerPane extends VBox {
    private final EditorModel model;
    private final Board board;
    private final ShareFeed feed;
    private final Map<Channel, Strip> strips = new LinkedHashMap<>();
    private final HBox row = new HBox();
    private final MasterStrip master;
    private final TextField search = new TextField();
    private final ChoiceBox<StripFilter> filter = new ChoiceBox<>();
    private final Label count = new Label();
    private SharePictures pictures;
    private Frame looked;

    public MixerPane(EditorModel model) {
        this.model = model;
        board = new Board(model);
        feed = new ShareFeed(model, this::show);
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
        model.window().execute(() -> shown().stream().findFirst().ifPresent(strip -> strip.fader().requestFocus()));
        return Subscription.combine(model.sceneProperty().subscribe(this::show),
                model.renderingProperty().subscribe(state -> look(state.frame())),
                model.viewProperty().subscribe(_ -> feed.look()),
                model.selectedLightProperty().subscribe(light -> {
                    if (light != null && board.selectedProperty().get().size() <= 1) {
                        board.set(List.of(new Channel.OfLight(light.name())));
                    }
                }));
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
        message.textProperty().bind(model.messageProperty());
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
        if (!List.copyOf(strips.keySet()).equals(all)) {
            Map<Channel, Strip> before = new LinkedHashMap<>(strips);
            strips.clear();
            for (Channel channel : all) {
                Strip strip = before.get(channel);
                strips.put(channel, strip == null ? new Strip(board, channel) : strip);
            }
            board.set(board.selectedProperty().get().stream().filter(all::contains).toList());
            showPictures();
            choose();
        }
        strips.values().forEach(strip -> strip.show(scene));
        arrange();
    }

    private void show(SharePictures now) {
        pictures = now;
        showPictures();
        master.show(now);
    }

    private void showPictures() {
        if (pictures != null) {
            strips.forEach((channel, strip) -> strip.show(pictures.of(channel, model.scene())));
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
        Scene scene = model.scene();
        StripFilter chosen = Optional.ofNullable(filter.getValue()).orElse(StripFilter.ALL);
        List<Strip> wanted = strips.values().stream().filter(s -> s.channel().isIn(scene))
                .filter(s -> chosen.shows(s.channel(), scene) && StripFilter.finds(search.getText(), s.channel(), scene)).toList();
        if (!shown().equals(wanted)) {
            row.getChildren().setAll(wanted);
        }
        count.setText(wanted.size() == strips.size() ? "" : Texts.of("{0} of {1} strips", wanted.size(), strips.size()));
    }
}
