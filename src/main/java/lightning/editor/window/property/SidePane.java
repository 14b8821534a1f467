package lightning.editor.window.property;

import java.util.function.Function;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import lightning.base.text.Texts;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;

/** The properties of what the artist works on: the selected light, a material, or the selected shape. */
public final class SidePane extends TabPane {

    private boolean ofShape;
    private boolean choosing;

    public SidePane(EditorModel model) {
        setId("side");
        setAccessibleText(Texts.of("Properties"));
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        SceneEditor editor = model.editor();
        Commands commands = model.commands();
        var menu = new PropertyMenu(editor, commands, model.arrangement());
        Tab light = tab(Texts.of("Light"), "light-tab",
                tab -> new PropertyPane(editor, commands, model.bringer(), menu, tab.selectedProperty()));
        Tab material = tab(Texts.of("Material"), "material-tab",
                _ -> new MaterialPane(editor, model.materials(), commands, model.bringer(), menu));
        Tab shape = tab(Texts.of("Shape"), "shape-tab", tab -> new NodePane(editor, commands, menu, tab.selectedProperty()));
        getTabs().setAll(light, material, shape);
        var inFront = editor.materialInFrontProperty();
        inFront.subscribe(on -> show(on ? material : ofShape ? shape : light));
        editor.situationProperty().map(s -> s.node().isPresent()).subscribe(now -> {
            ofShape = now;
            if (!inFront.get()) {
                show(ofShape ? shape : light);
            }
        });
        getSelectionModel().selectedItemProperty().subscribe(now -> {
            choosing = true;
            inFront.set(now == material);
            choosing = false;
        });
    }

    /** What the artist has put in front stays there. */
    private void show(Tab tab) {
        if (!choosing) {
            getSelectionModel().select(tab);
        }
    }

    /** What can be made before a tab is in front, a step for each. */
    public Stream<Runnable> ahead() {
        return getTabs().stream().map(tab -> () -> ((Runnable) tab.getUserData()).run());
    }

    /** @param content made when the tab is first in front: each is a third of all that is in the window */
    static Tab tab(String title, String id, Function<Tab, Node> content) {
        var tab = new Tab(title);
        tab.setId(id);
        Runnable make = () -> {
            if (tab.getContent() == null) {
                tab.setContent(content.apply(tab));
            }
        };
        tab.setUserData(make);
        tab.selectedProperty().subscribe(inFront -> {
            if (inFront) {
                make.run();
            }
        });
        return tab;
    }
}
