package lightning.editor.window.preview;

import java.util.List;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandItems;
import lightning.editor.window.model.GizmoSize;
import lightning.editor.window.model.PreviewLook;

/** The choices of how the preview looks. */
public final class PreviewItems {
    private PreviewItems() {}

    /** @param items make the menu's items */
    public static List<MenuItem> of(PreviewLook look, CommandItems items) {
        return List.of(items.item(Command.HIDE_GIZMOS), sizes(look, items), items.item(Command.GLOWING_TEXTURES));
    }

    private static Menu sizes(PreviewLook look, CommandItems items) {
        Menu menu = items.menu(Command.GIZMO_SIZE);
        var chosen = look.sizeProperty();
        for (GizmoSize size : GizmoSize.values()) {
            menu.getItems().add(items.choice(Command.GIZMO_SIZE, "gizmos-" + size.name(), size.toString(), chosen.map(s -> s == size),
                    () -> chosen.set(size)));
        }
        return menu;
    }
}
