package lightning.editor.window.mixer;

import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.document.Steps;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.NumberField;

/**
 * Makes all that shines brighter or darker. The scene keeps it in the lights' own intensities, so that the fader stands at 0 again
 * when it is let go.
 */
final class MasterStrip extends VBox {
    private static final double RANGE = 5;

    private final Board board;
    private final Thumbnail thumbnail = new Thumbnail(Texts.of("master"));
    private final Fader fader;
    private final NumberField stops;

    MasterStrip(Board board) {
        this.board = board;
        setId("strip-master");
        getStyleClass().addAll("strip", "master-strip");
        var name = new Label(Texts.of("Master"));
        name.getStyleClass().add("strip-head");
        fader = new Fader(Texts.of("master fader"), RANGE, false, new Hand());
        fader.setId("fader-master");
        stops = new NumberField(Texts.of("master stops"), Gauge.of("stops", new Steps(0.1, -100, 100), board::master));
        stops.setId("stops-master");
        stops.setTooltip(new Tooltip(Texts.of("Stops to add to all lights and the environment")));
        stops.show(0);
        VBox.setVgrow(fader, Priority.ALWAYS);
        var note = new Label(Texts.of("stops, all lights"));
        note.getStyleClass().add("part");
        getChildren().addAll(name, thumbnail, fader, stops, note);
    }

    private final class Hand implements Fader.Hand {
        @Override
        public void begin() {
            board.begin();
        }

        @Override
        public void move(double to, Object gesture) {
            if (board.master(to, gesture).isEmpty() && gesture != null) {
                fader.show(to);
                stops.show(to);
            }
        }

        @Override
        public void end() {
            board.end();
            fader.show(0);
            stops.show(0);
        }
    }

    void show(SharePictures pictures) {
        thumbnail.show(Optional.of(pictures.whole()));
    }
}
