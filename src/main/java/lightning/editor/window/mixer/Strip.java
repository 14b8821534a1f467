package lightning.editor.window.mixer;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.OverrunStyle;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.document.Channel;
import lightning.editor.document.ChannelEdits;
import lightning.editor.document.Steps;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.LightTypes;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.Paints;
import lightning.scene.Scene;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;

/** One strip of the board: a light, a bank or the environment, with its picture, its part, its fader and its switches. */
final class Strip extends VBox {
    /** Stops up and down that a fader goes; numbers go farther. */
    private static final double RANGE = 10;
    private static final double LEAST_STOPS = -1000;
    private static final PseudoClass CHOSEN = PseudoClass.getPseudoClass("chosen");
    private static final PseudoClass DARK = PseudoClass.getPseudoClass("dark");
    private static final PseudoClass DROP = PseudoClass.getPseudoClass("drop");
    private static final PseudoClass DRAGGED = PseudoClass.getPseudoClass("dragged");

    private final Board board;
    private final Channel channel;
    private final Label name = new Label();
    private final HBox head = new HBox();
    private final FontIcon type = new FontIcon();
    private final Thumbnail thumbnail;
    private final Meter meter = new Meter();
    private final Fader fader;
    private final NumberField stops;
    private final Obstacle noStops;
    private final NumberField intensity;
    private final Button color = new Button();
    private final ToggleButton solo = new ToggleButton("S");
    private final ToggleButton mute = new ToggleButton("M");

    Strip(Board board, Channel channel) {
        this.board = board;
        this.channel = channel;
        String id = channel.title();
        setId("strip-" + id);
        getStyleClass().add("strip");
        thumbnail = new Thumbnail(id);
        name.setText(id);
        // Names of one kind differ at their ends.
        name.setTextOverrun(OverrunStyle.CENTER_ELLIPSIS);
        name.setWrapText(true);
        name.setTooltip(new Tooltip(id));
        if (channel instanceof Channel.OfBank) {
            getStyleClass().add("bank-strip");
        }
        head.getStyleClass().add("strip-head");
        head.setId("strip-head-" + id);
        head.getChildren().addAll(type, name);
        fader = new Fader(Texts.of("{0} fader", id), RANGE, true, new Hand());
        fader.setId("fader-" + id);
        stops = new NumberField(Texts.of("{0} stops", id),
                Gauge.of("stops", new Steps(0.1, LEAST_STOPS, ChannelEdits.stops(channel.most())),
                        (v, gesture) -> set(ChannelEdits.ofStops(v), gesture)));
        stops.setId("stops-" + id);
        var around = row(Texts.of("stops"), stops);
        noStops = new Obstacle(around, stops, Texts.of("Stops: 0 is intensity 1, one more is twice the light"));
        intensity = new NumberField(Texts.of("{0} intensity", id), Gauge.of("intensity", new Steps(0.1, 0, channel.most()), this::set));
        intensity.setId("intensity-" + id);
        stops.refusalProperty().subscribe(board::tell);
        intensity.refusalProperty().subscribe(board::tell);
        intensity.setTooltip(new Tooltip(Texts.of("Intensity")));
        solo.setId("solo-" + id);
        solo.setAccessibleText(Texts.of("{0} solo", id));
        solo.setTooltip(new Tooltip(Texts.of("Solo: only lights that are solo shine")));
        solo.getStyleClass().add("solo");
        solo.setOnAction(_ -> switchSolo());
        mute.setId("mute-" + id);
        mute.setAccessibleText(Texts.of("{0} mute", id));
        mute.setTooltip(new Tooltip(Texts.of("Mute: switch it off")));
        mute.getStyleClass().add("mute");
        mute.setOnAction(_ -> switchOn());
        color.setId("color-" + id);
        color.setAccessibleText(Texts.of("{0} colour", id));
        color.setTooltip(new Tooltip(Texts.of("Colour")));
        color.getStyleClass().add("color-chip");
        color.setOnAction(_ -> new ColorPopup(board, channel).show(color));
        var switches = new HBox(color, solo, mute);
        switches.getStyleClass().add("switches");
        if (channel instanceof Channel.OfEnvironment) {
            switches.getChildren().forEach(part -> part.setVisible(false));
        }
        var throwing = new HBox(meter, fader);
        throwing.getStyleClass().add("throw");
        HBox.setHgrow(fader, Priority.ALWAYS);
        VBox.setVgrow(throwing, Priority.ALWAYS);
        getChildren().addAll(head, thumbnail, throwing, around, row("×", intensity), switches);
    }

    private static HBox row(String caption, NumberField field) {
        var label = new Label(caption);
        label.getStyleClass().add("caption");
        label.setMinWidth(Region.USE_PREF_SIZE);
        HBox.setHgrow(field, Priority.ALWAYS);
        var row = new HBox(label, field);
        row.getStyleClass().add("number-row");
        return row;
    }

    /** The fader, by the mouse and the keys. */
    private final class Hand implements Fader.Hand {
        @Override
        public void begin() {
            board.begin(channel);
        }

        @Override
        public void move(double to, Object gesture) {
            set(Math.min(ChannelEdits.ofStops(to), channel.most()), gesture);
        }

        @Override
        public void end() {
            board.end();
        }
    }

    private Optional<String> set(double v, Object gesture) {
        return board.intensity(channel, v, gesture);
    }

    private void switchSolo() {
        boolean on = solo.isSelected();
        board.each(channel, (scene, c) -> c.withSolo(scene, on), null);
        show(board.editor().scene());
    }

    private void switchOn() {
        boolean on = !mute.isSelected();
        board.each(channel, (scene, c) -> c.withOn(scene, on), null);
        show(board.editor().scene());
    }

    Fader fader() {
        return fader;
    }

    Channel channel() {
        return channel;
    }

    /** What takes the mouse for selecting and dragging. */
    HBox head() {
        return head;
    }

    /** Shows what the channel is in a scene. */
    void show(Scene scene) {
        Ikon icon = switch (channel) {
            case Channel.OfLight(String light) -> LightTypes.icon(scene.light(light).orElseThrow().type());
            case Channel.OfBank _ -> MaterialDesignT.TUNE_VERTICAL;
            case Channel.OfEnvironment _ -> MaterialDesignI.IMAGE_FILTER_HDR;
        };
        if (type.getIconCode() != icon) {
            type.setIconCode(icon);
        }
        double v = channel.intensity(scene);
        double inStops = ChannelEdits.stops(v);
        fader.show(inStops);
        intensity.show(v);
        noStops.set(v == 0 ? Optional.of(Texts.of("the intensity is 0")) : Optional.empty());
        if (v == 0) {
            stops.showNothing();
        } else {
            stops.show(Math.rint(inStops * 1000) / 1000);
        }
        solo.setSelected(channel.isSolo(scene));
        mute.setSelected(!channel.isOn(scene));
        channel.color(scene).ifPresent(c -> color.setStyle("-fx-background-color: " + Paints.css(c) + ";"));
        pseudoClassStateChanged(DARK, !channel.shines(scene));
        setAccessibleText(
                channel.title() + (channel.isOn(scene) ? "" : Texts.of(", muted")) + (channel.isSolo(scene) ? Texts.of(", solo") : ""));
    }

    void show(Optional<SharePictures.One> one) {
        thumbnail.show(one);
        meter.show(one.map(SharePictures.One::part).orElse(0.0));
    }

    void setChosen(boolean on) {
        pseudoClassStateChanged(CHOSEN, on);
    }

    /** Whether a strip that is dragged would come before this one. */
    void setDrop(boolean on) {
        pseudoClassStateChanged(DROP, on);
    }

    void setDragged(boolean on) {
        pseudoClassStateChanged(DRAGGED, on);
    }
}
