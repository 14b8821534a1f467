package lightning.editor.window.mixer;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.beans.binding.Bindings;
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
import lightning.base.text.Messages;
import lightning.document.MixerChannel;
import lightning.document.loop.Frame;
import lightning.editor.Workbench;
import lightning.editor.window.command.ForcedLiveUpdate;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.TimeSlicedTask;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.relight.LightShares;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Light mixer: a strip for each light, each light group and the environment, in the order of the scene, and a master. A click on a strip's
 * header selects it; Ctrl adds to the selection, Shift selects a range. Dragging the header reorders the lights.
 */
public final class MixerPane extends VBox {
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final Executor windowExecutor;
    private final MixerModel model;
    private final ChannelImageFeed feed;
    /** Channels in the order of the scene. Their strips may not be created yet. */
    private List<MixerChannel> channels = List.of();
    private final Map<MixerChannel, MixerStrip> strips = new HashMap<>();
    private final TimeSlicedTask stripBuilder = new TimeSlicedTask(this::buildNextStrip);
    private final HBox row = new HBox();
    private final MasterStrip master;
    private final TextField search = new TextField();
    private final ChoiceBox<StripFilter> filter = new ChoiceBox<>();
    private final Label count = new Label();
    /** Says what the thumbnails lack; empty if nothing. */
    private StripDetail detail = StripDetail.FULL;
    private @Nullable ChannelImages images;
    private @Nullable Frame lastFrame;

    /**
     * Creates the pane without strips.
     *
     * @param windowExecutor runs tasks in order on the window's thread
     */
    public MixerPane(SceneEditor editor, TracedPicture picture, Workbench workbench, Executor windowExecutor) {
        this.editor = editor;
        this.picture = picture;
        this.windowExecutor = windowExecutor;
        model = new MixerModel(editor);
        feed = new ChannelImageFeed(workbench, picture.viewProperty(), windowExecutor, this::show);
        master = new MasterStrip(model);
        setId("mixer");
        getStyleClass().add("mixer");
        row.getStyleClass().add("strips");
        row.setId("strips");
        new StripDrag(model, this::shownStrips).attach(row);
        var scroll = new ScrollPane(row);
        scroll.setFitToHeight(true);
        scroll.getStyleClass().add("edge-to-edge");
        HBox.setHgrow(scroll, Priority.ALWAYS);
        var body = new HBox(scroll, master);
        VBox.setVgrow(body, Priority.ALWAYS);
        getChildren().addAll(toolBar(), body);
        addEventHandler(KeyEvent.KEY_PRESSED, this::handleKey);
        model.selectedProperty().subscribe(_ -> updateSelection());
        heightProperty().map(height -> StripDetail.of(height.doubleValue())).subscribe(this::setDetail);
        VisibilityListener.attach(this, this::subscribe);
    }

    /** Returns whether the focus is in the mixer, which then was opened by the user. */
    private boolean hasFocus(@Nullable Node owner) {
        return owner == null || owner == this || owner.getParent() != null && hasFocus(owner.getParent());
    }

    private void setDetail(StripDetail newDetail) {
        detail = newDetail;
        master.setDetail(detail);
        strips.values().forEach(strip -> strip.setDetail(detail));
    }

    /** Starts to observe the scene and the picture. */
    private Subscription subscribe() {
        // Focuses a fader rather than the search field. Deferred, because the scroll pane adds its content only when it is styled.
        windowExecutor.execute(() -> {
            if (getScene() != null && hasFocus(getScene().getFocusOwner())) {
                shownStrips().stream().findFirst().ifPresent(strip -> strip.fader().requestFocus());
            }
        });
        return Subscription.combine(editor.sceneProperty().subscribe(this::show),
                picture.renderStateProperty().subscribe(state -> updateFrame(state.frame())),
                picture.viewProperty().subscribe(_ -> feed.refresh()),
                editor.selection().lightProperty().subscribe(light -> {
                    if (light != null) {
                        model.followSelection(light);
                    }
                }), ForcedLiveUpdate.renderWhileFocused(this, editor, windowExecutor), stripBuilder::cancel, feed::close);
    }

    private Node toolBar() {
        search.setId("mixer-search");
        search.setPromptText(Messages.tr("Search"));
        search.setAccessibleText(Messages.tr("search lights by name or type"));
        search.textProperty().subscribe(_ -> updateStrips());
        filter.setId("mixer-filter");
        filter.setAccessibleText(Messages.tr("filter strips"));
        filter.getItems().setAll(StripFilter.values());
        filter.setValue(StripFilter.ALL);
        filter.valueProperty().subscribe(_ -> updateStrips());
        var mode = new ToggleGroup();
        var relative = toggle("relative", Messages.tr("Relative"), Messages.tr("Scale all selected strips by the same factor"), mode);
        var absolute = toggle("absolute", Messages.tr("Absolute"), Messages.tr("Set all selected strips to the same value"), mode);
        relative.setSelected(true);
        mode.selectedToggleProperty().addListener((_, before, now) -> {
            if (now == null) {
                mode.selectToggle(before);
            } else {
                model.relativeProperty().set(now == relative);
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
        var fullMessage = new Tooltip();
        fullMessage.textProperty().bind(message.textProperty());
        message.tooltipProperty().bind(Bindings.when(message.textProperty().isEmpty()).then((Tooltip) null).otherwise(fullMessage));
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

    private void handleKey(KeyEvent e) {
        if (e.isShortcutDown() && e.getCode() == KeyCode.A && !(e.getTarget() instanceof TextField)) {
            model.setSelected(shownStrips().stream().map(MixerStrip::channel).toList());
            e.consume();
        }
    }

    private void updateFrame(@Nullable Frame frame) {
        if (frame != null && frame != lastFrame) {
            lastFrame = frame;
            feed.refresh();
        }
    }

    private void show(Scene scene) {
        List<MixerChannel> sceneChannels = MixerChannel.channelsOf(scene);
        if (!channels.equals(sceneChannels)) {
            channels = sceneChannels;
            strips.keySet().retainAll(sceneChannels);
            model.setSelected(model.selectedProperty().get().stream().filter(sceneChannels::contains).toList());
        }
        showPictures();
        strips.values().forEach(strip -> strip.show(scene));
        updateStrips();
        stripBuilder.start();
    }

    /**
     * Creates the strip of the first channel without one. Creating all strips together would block the window for scenes with many lights.
     */
    private boolean buildNextStrip() {
        Optional<MixerChannel> next = channels.stream().filter(channel -> !strips.containsKey(channel)).findFirst();
        next.ifPresent(channel -> {
            var strip = new MixerStrip(model, channel);
            strips.put(channel, strip);
            strip.setDetail(detail);
            strip.show(editor.scene());
            strip.setSelected(model.isSelected(channel));
            showPictures(List.of(strip));
            updateStrips();
            TimeSlicedTask.applyStyle(strip);
        });
        return next.isPresent();
    }

    private void show(ChannelImages newImages) {
        images = newImages;
        showPictures();
        master.show(newImages);
    }

    /** Returns the shares in the current scene; empty while they are unknown. */
    Optional<LightShares> shares() {
        return feed.scaledShares(editor.scene());
    }

    private void showPictures() {
        showPictures(strips.values());
    }

    private void showPictures(Collection<MixerStrip> some) {
        if (images != null) {
            ChannelImages shown = shares().map(images::withShares).orElse(images);
            some.forEach(strip -> strip.show(shown.of(strip.channel(), editor.scene())));
        }
    }

    private void updateSelection() {
        strips.forEach((channel, strip) -> strip.setSelected(model.isSelected(channel)));
    }

    /** Returns the visible strips from left to right. */
    private List<MixerStrip> shownStrips() {
        return row.getChildren().stream().map(MixerStrip.class::cast).toList();
    }

    private void updateStrips() {
        Scene scene = editor.scene();
        StripFilter chosen = Optional.ofNullable(filter.getValue()).orElse(StripFilter.ALL);
        List<MixerChannel> found = channels.stream().filter(c -> c.isIn(scene))
                .filter(c -> chosen.includes(c, scene) && StripFilter.matches(search.getText(), c, scene)).toList();
        List<MixerStrip> visible = found.stream().map(strips::get).filter(Objects::nonNull).toList();
        if (!shownStrips().equals(visible)) {
            setStrips(visible);
        }
        count.setText(found.size() == channels.size() ? "" : Messages.tr("{0} of {1} strips", found.size(), channels.size()));
    }

    /** Changes only the strips that differ: a strip that is removed and added again would be styled again. */
    private void setStrips(List<MixerStrip> visible) {
        List<Node> children = row.getChildren();
        children.retainAll(visible);
        if (children.equals(visible.stream().filter(children::contains).toList())) {
            for (int i = 0; i < visible.size(); i++) {
                if (i == children.size() || children.get(i) != visible.get(i)) {
                    children.add(i, visible.get(i));
                }
            }
        } else {
            row.getChildren().setAll(visible);
        }
    }
}
