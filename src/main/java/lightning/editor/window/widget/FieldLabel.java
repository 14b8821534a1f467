package lightning.editor.window.widget;

import javafx.scene.Cursor;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;

/** Label of a number field, with the unit. Dragging it sideways changes the number; a click focuses the field. */
final class FieldLabel extends Label {
    FieldLabel(String text, NumberSetting setting, NumberField field) {
        super(withUnit(text, setting.measure()));
        setLabelFor(field);
        setCursor(Cursor.H_RESIZE);
        getStyleClass().add("field-label");
        Tooltip.install(this,
                new Tooltip(Messages.tr("Drag sideways to change (Shift: fine, Ctrl: coarse).\nYou can type math: 0.3*2, +10%, 1/3")));
        NumberScrubber.install(this, setting, field, NumberScrubber.Direction.RIGHT, _ -> {
            field.requestFocus();
            field.selectAll();
        });
    }

    private static String withUnit(String text, NumberUnit unit) {
        return switch (unit) {
            case FACTOR -> text;
            case STOPS -> Messages.tr("{0} (stops)", text);
            case DEGREES, KELVIN -> text + " " + unit.sign();
        };
    }
}
