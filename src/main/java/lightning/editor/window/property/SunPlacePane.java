package lightning.editor.window.property;

import java.time.LocalDate;
import java.time.LocalTime;
import java.time.ZoneOffset;
import java.time.format.DateTimeParseException;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.DatePicker;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.TitledPane;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.GridPane;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.document.EditOutcome;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;
import lightning.scene.sky.Sky;
import lightning.scene.sky.SunPosition;

/** Fields that set the sun of the sky by a place on the globe, a date and a time. */
final class SunPlacePane extends TitledPane {
    private static final int SECONDS_PER_HOUR = 3600;
    private static final double GAP = 6;
    private static final int COLUMNS = 6;

    private final SceneEditor editor;
    private final TextField latitude = field("sky-latitude", Messages.tr("Latitude"), "51.48", Messages.tr("Degrees, north positive"));
    private final TextField longitude = field("sky-longitude", Messages.tr("Longitude"), "0", Messages.tr("Degrees, east positive"));
    private final DatePicker date = new DatePicker(LocalDate.now(ZoneOffset.UTC));
    private final TextField time = field("sky-time", Messages.tr("Time"), "12:00", Messages.tr("Hours and minutes, such as 17:30"));
    private final TextField offset =
            field("sky-offset", Messages.tr("UTC +"), "0", Messages.tr("Hours that the clock is ahead of UTC, with summer time"));

    SunPlacePane(SceneEditor editor) {
        this.editor = editor;
        setText(Messages.tr("Sun by Date and Place"));
        setId("sky-place");
        setExpanded(false);
        setAnimated(false);
        date.setId("sky-date");
        date.setAccessibleText(Messages.tr("Date"));
        date.setEditable(true);
        date.setMaxWidth(Double.MAX_VALUE);
        var set = new Button(Messages.tr("Set Sun"));
        set.setId("sky-set-sun");
        set.setTooltip(new Tooltip(Messages.tr("Set elevation and azimuth of the sun; north is −z, east is x")));
        set.setOnAction(_ -> editor.editOrReport(scene -> EditOutcome.of(() -> withSun(scene))));
        var grid = new GridPane(GAP, GAP);
        grid.setAlignment(Pos.CENTER_LEFT);
        grid.addRow(0, label(Messages.tr("Latitude"), latitude), latitude, label(Messages.tr("Longitude"), longitude), longitude);
        grid.addRow(1, label(Messages.tr("Date"), date), date);
        GridPane.setColumnSpan(date, GridPane.REMAINING);
        grid.addRow(2, label(Messages.tr("Time"), time), time, label(Messages.tr("UTC +"), offset), offset);
        grid.addRow(3, set);
        GridPane.setColumnSpan(set, GridPane.REMAINING);
        setContent(grid);
    }

    private static Label label(String text, Node of) {
        var label = new Label(text);
        label.setLabelFor(of);
        label.setMinWidth(USE_PREF_SIZE);
        return label;
    }

    private static TextField field(String id, String name, String text, String help) {
        var field = new TextField(text);
        field.setId(id);
        field.setAccessibleText(name);
        field.setPrefColumnCount(COLUMNS);
        field.setTooltip(new Tooltip(help));
        return field;
    }

    /** Returns a scene with the sun where it is then. */
    private Scene withSun(Scene scene) {
        if (date.getValue() == null) {
            throw new RefusalException(Messages.tr("{0} must be a date", Messages.tr("Date")));
        }
        SunPosition sun = SunPosition.at(number(latitude, Messages.tr("Latitude")), number(longitude, Messages.tr("Longitude")),
                date.getValue().atTime(timeOfDay()).toInstant(zone()));
        if (sun.elevation() < Sky.MIN_ELEVATION) {
            throw new RefusalException(Messages.tr("the sun is {0}° below the horizon then, at most {1}° can be shown",
                    Math.round(-sun.elevation()), Math.round(-Sky.MIN_ELEVATION)));
        }
        Sky sky = scene.world().sky();
        return scene.withWorld(scene.world().withSky(sky.withElevation(rounded(sun.elevation())).withAzimuth(rounded(sun.azimuth()))));
    }

    private static double rounded(double degrees) {
        return Math.rint(100 * degrees) / 100 + 0.0;
    }

    private LocalTime timeOfDay() {
        try {
            String text = time.getText().strip();
            return LocalTime.parse(text.indexOf(':') == 1 ? "0" + text : text);
        } catch (DateTimeParseException e) {
            throw new RefusalException(
                    Messages.tr("{0} must be a time such as 17:30, was {1}", Messages.tr("Time"), time.getText()), e);
        }
    }

    private ZoneOffset zone() {
        double hours = number(offset, "UTC");
        if (!(Math.abs(hours) <= 18)) {
            throw new RefusalException(Messages.tr("UTC must be from {0} to {1} hours, was {2}", -18, 18, offset.getText()));
        }
        return ZoneOffset.ofTotalSeconds((int) Math.rint(hours * SECONDS_PER_HOUR));
    }

    private static double number(TextField field, String name) {
        return DecimalNumber.parse(field.getText().strip().replace(',', '.')).orElseThrow(
                () -> new RefusalException(Messages.tr("{0} must be a number, was {1}", name, field.getText())));
    }
}
