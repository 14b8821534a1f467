package lightning.editor.window.property;

import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import lightning.base.text.Messages;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;

/** Tabs with the lists of lights and shapes. Shows the list of the selected item. */
public final class ListTabs extends TabPane {
    public ListTabs(SceneEditor editor, CommandRegistry commands) {
        setId("lists");
        setAccessibleText(Messages.tr("Lights and objects"));
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        Tab lights = SidePane.tab(Messages.tr("Lights"), "lights-tab", _ -> new LightListPane(editor, commands));
        Tab shapes = SidePane.tab(Messages.tr("Objects"), "shapes-tab", _ -> new OutlinePane(editor, commands));
        getTabs().setAll(lights, shapes);
        LinkDrop.switchTabsOnDrag(this);
        editor.editorStateProperty().map(s -> s.selectedNode().isPresent())
                .subscribe(isShape -> getSelectionModel().select(isShape ? shapes : lights));
    }
}
