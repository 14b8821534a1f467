package lightning.editor.window.command;

import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.MaterialEdits;
import lightning.editor.window.model.EditorModel;

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
            CommandItems items = CommandItems.of(model);
            menu.getItems().setAll(items.value(Command.EDIT_MATERIAL, Texts.of("Edit Material {0} of {1}", material.name(), shape),
                    () -> model.materials().chooseOf(shape)));
            menu.getItems().add(items.value(Command.SELECT_SHAPE, Texts.of("Select {0}", shape), () -> model.selectNode(shape)));
            model.scene().stage().around(shape).forEach(group -> menu.getItems().add(
                    items.value(Command.SELECT_SHAPE, Texts.of("Select Group {0}", group.name()), () -> model.selectNode(group.name()))));
            menu.show(owner, x, y);
        });
    }

    public void hide() {
        menu.hide();
    }
}
