package lightning.editor.window.widget;

import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;

/** Arrow of an {@link ArrowWidget}: drag vertically, or click the upper or lower half to step. */
final class ArrowPad extends VBox {
    ArrowPad(NumberSetting setting, NumberField field) {
        super(arrow("up"), arrow("down"));
        getStyleClass().add("arrow-pad");
        setAccessibleRole(AccessibleRole.SPINNER);
        setAccessibleText(field.getAccessibleText());
        setCursor(Cursor.V_RESIZE);
        Tooltip.install(this, new Tooltip(Messages.tr("Drag to change, click to step (Shift: fine, Ctrl: coarse)")));
        NumberScrubber.install(this, setting, field, NumberScrubber.Direction.UP, event -> field
                .step((event.getY() < getHeight() / 2 ? 1 : -1) * NumberScrubber.factor(event.isShiftDown(), event.isShortcutDown())));
    }

    private static Region arrow(String name) {
        Region arrow = new Region();
        arrow.getStyleClass().addAll("arrow", name);
        arrow.setMouseTransparent(true);
        return arrow;
    }
}
