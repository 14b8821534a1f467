package lightning.editor.window.mixer;

import java.util.Optional;
import java.util.regex.Pattern;
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
import lightning.base.text.Messages;
import lightning.document.MixerChannel;
import lightning.document.MixerEdits;
import lightning.document.StepRange;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.DisplayColors;
import lightning.editor.window.widget.LightTypes;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.FaderValues;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;

/** Strip of the mixer for a light, a light group or the environment: thumbnail, share, fader and switches. */
final class MixerStrip extends VBox {
    /** Range of the fader in both directions, stops. The number field accepts larger values. */
    private static final double FADER_RANGE = 10;
    private static final double MIN_STOPS = -1000;
    private static final PseudoClass SELECTED = PseudoClass.getPseudoClass("chosen");
    private static final PseudoClass DARK = PseudoClass.getPseudoClass("dark");
    private static final PseudoClass DROP_TARGET = PseudoClass.getPseudoClass("drop");
    private static final PseudoClass DRAGGED = PseudoClass.getPseudoClass("dragged");

    /** Character at which a name can continue on another line. */
    private static final Pattern SEPARATOR = Pattern.compile("[\\s-]");

    private final MixerModel model;
    private final MixerChannel channel;
    private final Label name = new Label();
    private final HBox head = new HBox();
    private final FontIcon type = new FontIcon();
    private final Thumbnail thumbnail;
    private final Meter meter = new Meter();
    private final Fader fader;
    private final NumberField stops;
    private final DisabledReason stopsReason;
    private final NumberField intensity;
    private final HBox intensityRow;
    private final HBox stopsRow;
    private final Button color = new Button();
    private final ToggleButton solo = new ToggleButton("S");
    private final ToggleButton mute = new ToggleButton("M");

    MixerStrip(MixerModel model, MixerChannel channel) {
        this.model = model;
        this.channel = channel;
        String id = channel.title(model.editor().scene());
        setId("strip-" + id);
        getStyleClass().add("strip");
        thumbnail = new Thumbnail(id);
        name.setText(id);
        // Similar names often differ only at their ends.
        name.setTextOverrun(OverrunStyle.CENTER_ELLIPSIS);
        // A single word would be broken at any letter.
        name.setWrapText(SEPARATOR.matcher(id).find());
        name.setTooltip(new Tooltip(id));
        if (channel instanceof MixerChannel.OfLightGroup) {
            getStyleClass().add("group-strip");
        }
        head.getStyleClass().add("strip-head");
        head.setId("strip-head-" + id);
        head.getChildren().addAll(type, name);
        fader = new Fader(Messages.tr("{0} fader", id), FADER_RANGE, true, new FaderCallbacks());
        fader.setId("fader-" + id);
        stops = new NumberField(Messages.tr("{0} stops", id),
                NumberSetting.of("stops", new StepRange(0.1, MIN_STOPS, MixerEdits.stops(channel.maxIntensity())),
                        (v, gesture) -> setIntensity(MixerEdits.intensityOfStops(v), gesture)));
        stops.setId("stops-" + id);
        stopsRow = row(Messages.tr("stops"), stops);
        stopsReason = new DisabledReason(stopsRow, stops, Messages.tr("Intensity in stops (0 = intensity 1, +1 = twice as bright)"));
        intensity = new NumberField(Messages.tr("{0} intensity", id),
                NumberSetting.of("intensity", new StepRange(0.1, 0, channel.maxIntensity()), this::setIntensity));
        intensity.setId("intensity-" + id);
        stops.refusalProperty().subscribe(model::reportRefusal);
        intensity.refusalProperty().subscribe(model::reportRefusal);
        intensity.setTooltip(new Tooltip(Messages.tr("Intensity")));
        solo.setId("solo-" + id);
        solo.setAccessibleText(Messages.tr("{0} solo", id));
        solo.setTooltip(new Tooltip(Messages.tr("Solo")));
        solo.getStyleClass().add("solo");
        solo.setOnAction(_ -> toggleSolo());
        mute.setId("mute-" + id);
        mute.setAccessibleText(Messages.tr("{0} mute", id));
        mute.setTooltip(new Tooltip(Messages.tr("Mute")));
        mute.getStyleClass().add("mute");
        mute.setOnAction(_ -> toggleMute());
        color.setId("color-" + id);
        color.setAccessibleText(Messages.tr("{0} color", id));
        color.setTooltip(new Tooltip(Messages.tr("Color")));
        color.getStyleClass().add("color-chip");
        color.setOnAction(_ -> new ColorPopup(model, channel).show(color));
        var switches = new HBox(color, solo, mute);
        switches.getStyleClass().add("switches");
        if (!channel.canBeMoved()) {
            // Environments have no color.
            color.setVisible(false);
        }
        var faderRow = new HBox(meter, fader);
        faderRow.getStyleClass().add("throw");
        HBox.setHgrow(fader, Priority.ALWAYS);
        VBox.setVgrow(faderRow, Priority.ALWAYS);
        intensityRow = row("×", intensity);
        getChildren().addAll(head, thumbnail, faderRow, stopsRow, intensityRow, switches);
    }

    /** Hides what a low mixer has no room for. */
    void setDetail(StripDetail detail) {
        thumbnail.setDetail(detail);
        setShown(intensityRow, detail.includes(StripDetail.NO_THUMBNAIL));
        setShown(stopsRow, detail.includes(StripDetail.NO_INTENSITY));
    }

    private static void setShown(HBox part, boolean shown) {
        part.setVisible(shown);
        part.setManaged(shown);
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

    /** Applies the fader's values. */
    private final class FaderCallbacks implements Fader.Callbacks {
        @Override
        public void startDrag() {
            model.beginDrag(channel);
        }

        @Override
        public void move(double newStops, @Nullable Object gesture) {
            setIntensity(Math.min(MixerEdits.intensityOfStops(newStops), channel.maxIntensity()), gesture);
        }

        @Override
        public void endDrag() {
            model.endDrag();
        }
    }

    private Optional<String> setIntensity(double v, @Nullable Object gesture) {
        return model.setIntensity(channel, v, gesture);
    }

    private void toggleSolo() {
        boolean on = solo.isSelected();
        model.editSelected(channel, (scene, c) -> c.with(scene, v -> v.withSolo(on)), null);
        show(model.editor().scene());
    }

    private void toggleMute() {
        boolean on = !mute.isSelected();
        model.editSelected(channel, (scene, c) -> c.with(on && c.equals(MixerChannel.ENVIRONMENT) && scene.world().own().gain() == 0
                ? scene.withWorld(scene.world().withOwn(own -> own.withGain(model.environmentGain()))) : scene, v -> v.withOn(on)), null);
        show(model.editor().scene());
    }

    Fader fader() {
        return fader;
    }

    MixerChannel channel() {
        return channel;
    }

    /** Returns the header, which handles selection and dragging. */
    HBox head() {
        return head;
    }

    /** Shows the channel's state in a scene. */
    void show(Scene scene) {
        Ikon icon = switch (channel) {
            case MixerChannel.OfContribution(SceneElement.OfLight(String light)) ->
                    LightTypes.icon(scene.light(light).orElseThrow().type());
            case MixerChannel.OfLightGroup _ -> MaterialDesignT.TUNE_VERTICAL;
            case MixerChannel.OfContribution _ -> MaterialDesignI.IMAGE_FILTER_HDR;
        };
        if (type.getIconCode() != icon) {
            type.setIconCode(icon);
        }
        FaderValues values = channel.values(scene);
        double v = values.intensity();
        if (channel.equals(MixerChannel.ENVIRONMENT) && scene.world().own().gain() > 0) {
            model.setEnvironmentGain(scene.world().own().gain());
        }
        double stopsValue = MixerEdits.stops(v);
        fader.show(stopsValue);
        intensity.show(v);
        stopsReason.set(v == 0 ? Optional.of(Messages.tr("the intensity is 0")) : Optional.empty());
        if (v == 0) {
            stops.showNothing();
        } else {
            stops.show(Math.rint(stopsValue * 1000) / 1000);
        }
        solo.setSelected(values.solo());
        mute.setSelected(!values.on());
        channel.shownColor(scene).ifPresent(c -> color.setStyle("-fx-background-color: " + DisplayColors.css(c) + ";"));
        pseudoClassStateChanged(DARK, !channel.isShining(scene));
        String title = channel.title(scene);
        name.setText(title);
        setAccessibleText(title + (values.on() ? "" : Messages.tr(", muted")) + (values.solo() ? Messages.tr(", solo") : ""));
    }

    void show(Optional<ChannelImages.ChannelImage> channelImage) {
        thumbnail.show(channelImage);
        meter.show(channelImage.map(ChannelImages.ChannelImage::fraction).orElse(0.0));
    }

    void setSelected(boolean on) {
        pseudoClassStateChanged(SELECTED, on);
    }

    /** Marks the strip as the one before which a dragged strip would be dropped. */
    void setDropTarget(boolean on) {
        pseudoClassStateChanged(DROP_TARGET, on);
    }

    void setDragged(boolean on) {
        pseudoClassStateChanged(DRAGGED, on);
    }
}
