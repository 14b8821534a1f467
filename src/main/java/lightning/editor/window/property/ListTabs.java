package lightning.editor.window.property;

import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import lightning.base.text.Texts;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;

/** What the scene holds: its lights, and its shapes and groups. The list of what is selected comes in front. */
public final class ListTabs extends TabPane {
    public ListTabs(SceneEditor editor, Commands commands) {
        setId("lists");
        setAccessibleText(Texts.of("Lights and shapes"));
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        Tab lights = SidePane.tab(Texts.of("Lights"), "lights-tab", _ -> new LightListPane(editor, commands));
        Tab shapes = SidePane.tab(Texts.of("Shapes"), "shapes-tab", _ -> new OutlinePane(editor, commands));
        getTabs().setAll(lights, shapes);
        LinkDrop.throughTabs(this);
        editor.situationProperty().map(s -> s.node().isPresent())
                .subscribe(ofShape -> getSelectionModel().select(ofShape ? shapes : lights));
    }
}
