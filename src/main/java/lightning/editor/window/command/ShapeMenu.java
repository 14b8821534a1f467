package lightning.editor.window.command;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuItem;
import lightning.base.text.Messages;
import lightning.document.MaterialEdits;
import lightning.document.NodeEdits;
import lightning.editor.Command;
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
        menu.getItems().setAll(items(shape));
        if (!menu.getItems().isEmpty()) {
            menu.show(owner, x, y);
        }
    }

    /** Returns the items of a shape; empty if the scene has no such shape. */
    public List<MenuItem> items(String shape) {
        List<MenuItem> list = new ArrayList<>();
        MaterialEdits.ofShape(editor.scene(), shape).ifPresent(material -> {
            CommandMenuItems items = CommandMenuItems.forMenu(commands);
            list.add(items.value(Command.EDIT_MATERIAL, Messages.tr("Edit Material {0} of {1}", material.name(), shape),
                    () -> materials.chooseForShape(shape)));
            list.add(items.value(Command.SELECT_SHAPE, Messages.tr("Select {0}", shape), () -> editor.selection().selectNode(shape)));
            editor.scene().stage().enclosingGroups(shape).forEach(group -> list.add(
                    items.value(Command.SELECT_SHAPE, Messages.tr("Select Group {0}", group.name()),
                            () -> editor.selection().selectNode(group.name()))));
            list.add(items.value(Command.MAKE_LIGHT, Messages.tr("Make {0} a Light", shape), () -> makeLight(shape)));
            list.add(items.value(Command.HIDE_SHAPE, Messages.tr("Hide {0}", shape), () -> hide(shape)));
        });
        return list;
    }

    private void makeLight(String shape) {
        editor.selection().selectNode(shape);
        commands.run(Command.MAKE_LIGHT);
    }

    private void hide(String shape) {
        if (editor.editOrReport(scene -> NodeEdits.setVisible(scene, shape, false)).isEmpty()) {
            editor.message().show(Messages.tr("{0} is hidden. Undo or its eye in Objects shows it", shape));
        }
    }

    public void hide() {
        menu.hide();
    }
}
