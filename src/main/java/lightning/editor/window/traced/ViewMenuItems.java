package lightning.editor.window.traced;

import java.util.ArrayList;
import java.util.List;
import javafx.beans.property.ObjectProperty;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;

/** Menu items of the view transform and the visible effects, which are not part of the scene. */
public final class ViewMenuItems {
    private ViewMenuItems() {}

    /**
     * Creates the items.
     *
     * @param items creates the single items
     */
    public static List<MenuItem> of(ObjectProperty<ViewTransform> view, CommandMenuItems items) {
        List<MenuItem> menuItems = new ArrayList<>();
        for (DisplayCurve curve : DisplayCurve.values()) {
            menuItems.add(curve(view, items, curve));
        }
        menuItems.addAll(List.of(new SeparatorMenuItem(), items.item(Command.COLOR_TABLE), items.item(Command.MARK_CLIPPING),
                new SeparatorMenuItem(),
                items.item(Command.SHADOWS), items.item(Command.REFLECTIONS), items.item(Command.LIT_TEXTURES)));
        return menuItems;
    }

    private static MenuItem curve(ObjectProperty<ViewTransform> view, CommandMenuItems items, DisplayCurve curve) {
        return items.choice(Command.CURVE, curve.word(), Messages.tr(curve.title()), view.map(v -> v.curve() == curve),
                () -> view.set(view.get().withCurve(curve)));
    }
}
