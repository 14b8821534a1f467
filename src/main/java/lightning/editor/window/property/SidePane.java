package lightning.editor.window.property;

import java.util.function.Function;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import lightning.base.text.Messages;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;

/** Tabs with the properties of the selected light, a material, or the selected shape. */
public final class SidePane extends TabPane {

    private boolean isShapeSelected;
    private boolean isUpdating;

    public SidePane(EditorModel model) {
        setId("side");
        setAccessibleText(Messages.tr("Properties"));
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        SceneEditor editor = model.editor();
        CommandRegistry commands = model.commands();
        var menu = new PropertyMenu(editor, commands, model.layout());
        Tab light = tab(Messages.tr("Light"), "light-tab",
                tab -> new PropertyPane(model, menu, tab.selectedProperty()));
        Tab material = tab(Messages.tr("Material"), "material-tab",
                _ -> new MaterialPane(model, menu));
        Tab shape = tab(Messages.tr("Object"), "shape-tab", tab -> new NodePane(model, menu, tab.selectedProperty()));
        getTabs().setAll(light, material, shape);
        var materialInFront = editor.materialShownProperty();
        materialInFront.subscribe(on -> show(on ? material : isShapeSelected ? shape : light));
        editor.editorStateProperty().map(s -> s.selectedNode().isPresent()).subscribe(now -> {
            isShapeSelected = now;
            if (!materialInFront.get()) {
                show(isShapeSelected ? shape : light);
            }
        });
        getSelectionModel().selectedItemProperty().subscribe(now -> {
            isUpdating = true;
            materialInFront.set(now == material);
            isUpdating = false;
        });
    }

    /** Shows a tab, unless the user just selected one. */
    private void show(Tab tab) {
        if (!isUpdating) {
            getSelectionModel().select(tab);
        }
    }

    /** Returns steps that each create a tab's content in advance. */
    public Stream<Runnable> preloadSteps() {
        return getTabs().stream().map(tab -> () -> ((Runnable) tab.getUserData()).run());
    }

    /** @param content  creates the content on first display; each tab is a third of the window's nodes */
    static Tab tab(String title, String id, Function<Tab, Node> content) {
        var tab = new Tab(title);
        tab.setId(id);
        Runnable createContent = () -> {
            if (tab.getContent() == null) {
                tab.setContent(content.apply(tab));
            }
        };
        tab.setUserData(createContent);
        tab.selectedProperty().subscribe(inFront -> {
            if (inFront) {
                createContent.run();
            }
        });
        return tab;
    }
}
