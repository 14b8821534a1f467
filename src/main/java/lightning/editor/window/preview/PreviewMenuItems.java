package lightning.editor.window.preview;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CameraNavigation;
import lightning.editor.window.model.GizmoSize;
import lightning.editor.window.model.PreviewSettings;

/** Menu items of the preview's display options. */
public final class PreviewMenuItems {
    private PreviewMenuItems() {}

    /**
     * Creates the items.
     *
     * @param items creates the single items
     */
    public static List<MenuItem> of(PreviewSettings settings, CommandMenuItems items) {
        return List.of(items.item(Command.HIDE_GIZMOS), sizes(settings, items), navigation(settings, items),
                items.item(Command.PREVIEW_SHADOWS),
                items.item(Command.GLOWING_TEXTURES));
    }

    private static Menu navigation(PreviewSettings settings, CommandMenuItems items) {
        Menu menu = items.menu(Command.NAVIGATION);
        menu.getItems().setAll(navigationChoices(settings, items));
        return menu;
    }

    /** Creates an item for each way to move the view by mouse. */
    static List<MenuItem> navigationChoices(PreviewSettings settings, CommandMenuItems items) {
        var chosen = settings.navigationProperty();
        return Stream.of(CameraNavigation.values()).map(navigation -> items.choice(Command.NAVIGATION, "navigation-" + navigation.name(),
                navigation.toString(), chosen.map(n -> n == navigation), () -> chosen.set(navigation))).toList();
    }

    private static Menu sizes(PreviewSettings settings, CommandMenuItems items) {
        Menu menu = items.menu(Command.GIZMO_SIZE);
        var chosen = settings.gizmoSizeProperty();
        for (GizmoSize size : GizmoSize.values()) {
            menu.getItems().add(items.choice(Command.GIZMO_SIZE, "gizmos-" + size.name(), size.toString(), chosen.map(s -> s == size),
                    () -> chosen.set(size)));
        }
        return menu;
    }
}
