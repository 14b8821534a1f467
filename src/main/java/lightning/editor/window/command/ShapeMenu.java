package lightning.editor.window.command;

import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.MaterialEdits;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.MaterialChoice;
import lightning.editor.window.model.SceneEditor;

/** What a right click on a shape offers, in the preview and in the traced picture. */
public final class ShapeMenu {
    private final SceneEditor editor;
    private final MaterialChoice materials;
    private final Commands commands;
    private final ContextMenu menu = new ContextMenu();

    public ShapeMenu(SceneEditor editor, MaterialChoice materials, Commands commands) {
        this.editor = editor;
        this.materials = materials;
        this.commands = commands;
    }

    /** @param x of the screen; likewise {@code y} */
    public void show(Node owner, String shape, double x, double y) {
        hide();
        MaterialEdits.ofShape(editor.scene(), shape).ifPresent(material -> {
            CommandItems items = CommandItems.of(commands);
            menu.getItems().setAll(items.value(Command.EDIT_MATERIAL, Texts.of("Edit Material {0} of {1}", material.name(), shape),
                    () -> materials.chooseOf(shape)));
            menu.getItems()
                    .add(items.value(Command.SELECT_SHAPE, Texts.of("Select {0}", shape), () -> editor.selection().selectNode(shape)));
            editor.scene().stage().around(shape).forEach(group -> menu.getItems().add(
                    items.value(Command.SELECT_SHAPE, Texts.of("Select Group {0}", group.name()),
                            () -> editor.selection().selectNode(group.name()))));
            menu.show(owner, x, y);
        });
    }

    public void hide() {
        menu.hide();
    }
}
