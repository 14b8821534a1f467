package lightning.editor.window.traced;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.ViewActions;
import lightning.render.image.DisplayCurve;

/** Menu items of the scene's view transform, and of the window's analysis views and visible effects. */
public final class ViewMenuItems {
    private ViewMenuItems() {}

    /**
     * Creates the items.
     *
     * @param items creates the single items
     */
    public static List<MenuItem> of(ViewActions actions, CommandMenuItems items) {
        List<MenuItem> menuItems = new ArrayList<>();
        for (DisplayCurve curve : DisplayCurve.values()) {
            menuItems.add(curve(actions, items, curve));
        }
        menuItems.addAll(List.of(new SeparatorMenuItem(), items.item(Command.COLOR_TABLE),
                items.item(Command.OCIO_VIEW), items.item(Command.MARK_CLIPPING),
                new SeparatorMenuItem(),
                items.item(Command.SHADOWS), items.item(Command.REFLECTIONS), items.item(Command.LIT_TEXTURES)));
        return menuItems;
    }

    private static MenuItem curve(ViewActions actions, CommandMenuItems items, DisplayCurve curve) {
        return items.choice(Command.CURVE, curve.word(), Messages.tr(curve.title()), actions.viewProperty().map(v -> v.curve() == curve),
                () -> actions.setCurve(curve));
    }
}
