package lightning.editor.window.mixer;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.StepRange;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.NumberSetting;
import org.jspecify.annotations.Nullable;

/** Master fader for all lights and the environment. Changes the lights' own intensities, so the fader returns to 0 when it is released. */
final class MasterStrip extends VBox {
    private static final double RANGE = 5;

    private final MixerModel model;
    private final Thumbnail thumbnail = new Thumbnail(Messages.tr("master"));
    private final Fader fader;
    private final NumberField stops;
    private final Label note = new Label(Messages.tr("stops"));

    MasterStrip(MixerModel model) {
        this.model = model;
        setId("strip-master");
        getStyleClass().addAll("strip", "master-strip");
        var name = new Label(Messages.tr("Master"));
        name.getStyleClass().add("strip-head");
        fader = new Fader(Messages.tr("master fader"), RANGE, false, new FaderCallbacks());
        fader.setId("fader-master");
        stops = new NumberField(Messages.tr("master stops"), NumberSetting.of("stops", new StepRange(0.1, -100, 100), model::setMaster));
        stops.setId("stops-master");
        stops.setTooltip(new Tooltip(Messages.tr("Exposure offset for all lights and the environment, in stops")));
        stops.show(0);
        VBox.setVgrow(fader, Priority.ALWAYS);
        note.getStyleClass().add("part");
        getChildren().addAll(name, thumbnail, fader, stops, note);
    }

    private final class FaderCallbacks implements Fader.Callbacks {
        @Override
        public void startDrag() {
            model.beginDrag();
        }

        @Override
        public void move(double newStops, @Nullable Object gesture) {
            if (model.setMaster(newStops, gesture).isEmpty() && gesture != null) {
                fader.show(newStops);
                stops.show(newStops);
            }
        }

        @Override
        public void endDrag() {
            model.endDrag();
            fader.show(0);
            stops.show(0);
        }
    }

    /** Hides what a low mixer has no room for. */
    void setDetail(StripDetail detail) {
        thumbnail.setDetail(detail);
        boolean hasStops = detail.includes(StripDetail.NO_INTENSITY);
        for (Region part : List.of(stops, note)) {
            part.setVisible(hasStops);
            part.setManaged(hasStops);
        }
    }

    void show(ChannelImages images) {
        thumbnail.show(Optional.of(images.master()));
    }
}
