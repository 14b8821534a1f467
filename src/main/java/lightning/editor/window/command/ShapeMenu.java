package lightning.editor.window.command;

import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.MaterialEdits;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;

/** Context menu of a shape, in the preview and in the traced picture. */
public final class ShapeMenu {
    private final SceneEditor editor;
    private final MaterialSelection materials;
    private final CommandRegistry commands;
    private final ContextMenu menu = new ContextMenu();

    public ShapeMenu(SceneEditor editor, MaterialSelection materials, CommandRegistry commands) {
        this.editor = editor;
        this.materials = materials;
        this.commands = commands;
    }

    /** @param x  screen position; see also {@code y} */
    public void show(Node owner, String shape, double x, double y) {
        hide();
        MaterialEdits.ofShape(editor.scene(), shape).ifPresent(material -> {
            CommandMenuItems items = CommandMenuItems.forMenu(commands);
            menu.getItems().setAll(items.value(Command.EDIT_MATERIAL, Messages.tr("Edit Material {0} of {1}", material.name(), shape),
                    () -> materials.chooseForShape(shape)));
            menu.getItems()
                    .add(items.value(Command.SELECT_SHAPE, Messages.tr("Select {0}", shape), () -> editor.selection().selectNode(shape)));
            editor.scene().stage().enclosingGroups(shape).forEach(group -> menu.getItems().add(
                    items.value(Command.SELECT_SHAPE, Messages.tr("Select Group {0}", group.name()),
                            () -> editor.selection().selectNode(group.name()))));
            menu.show(owner, x, y);
        });
    }

    public void hide() {
        menu.hide();
    }
}
