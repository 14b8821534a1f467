package lightning.app.preview;

import java.util.List;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.ToggleGroup;
import javafx.scene.input.KeyCombination;
import lightning.app.model.GizmoSize;
import lightning.app.model.PreviewLook;

/** The choices of how the preview looks. */
public final class PreviewItems {
    private PreviewItems() {}

    public static List<MenuItem> of(PreviewLook look) {
        return List.of(gizmos(look), sizes(look), glowing(look));
    }

    private static MenuItem gizmos(PreviewLook look) {
        var gizmos = new CheckMenuItem("Gizmos of the Lights");
        gizmos.setId("menu-gizmos");
        gizmos.setAccelerator(KeyCombination.valueOf("Shortcut+G"));
        gizmos.selectedProperty().bindBidirectional(look.gizmosProperty());
        return gizmos;
    }

    private static MenuItem sizes(PreviewLook look) {
        var menu = new Menu("Size of the Gizmos");
        var group = new ToggleGroup();
        for (GizmoSize size : GizmoSize.values()) {
            var item = new RadioMenuItem(size.toString());
            item.setToggleGroup(group);
            item.setOnAction(_ -> look.sizeProperty().set(size));
            look.sizeProperty().subscribe(s -> item.setSelected(s == size));
            menu.getItems().add(item);
        }
        return menu;
    }

    private static MenuItem glowing(PreviewLook look) {
        var glowing = new CheckMenuItem("Glowing Textures in the Preview, as in 1998");
        glowing.setId("glowing-textures");
        look.litProperty().subscribe(lit -> glowing.setSelected(!lit));
        glowing.setOnAction(_ -> look.litProperty().set(!glowing.isSelected()));
        return glowing;
    }
}
