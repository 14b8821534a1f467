package lightning.app.command;

import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import lightning.app.model.EditorModel;
import lightning.edit.MaterialEdits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;

/** What a right click on a shape offers, in the preview and in the traced picture. */
public final class ShapeMenu {
    private final EditorModel model;
    private final ContextMenu menu = new ContextMenu();

    public ShapeMenu(EditorModel model) {
        this.model = model;
    }

    /** @param x of the screen; likewise {@code y} */
    public void show(Node owner, String shape, double x, double y) {
        hide();
        MaterialEdits.ofShape(model.scene(), shape).ifPresent(material -> {
            var item = new MenuItem("Edit Material " + material.name() + " of " + shape, new FontIcon(MaterialDesignP.PALETTE_OUTLINE));
            item.setId("edit-material");
            item.setMnemonicParsing(false);
            item.setOnAction(_ -> model.materials().chooseOf(shape));
            menu.getItems().setAll(item);
            menu.show(owner, x, y);
        });
    }

    public void hide() {
        menu.hide();
    }
}
