package lightning.app.property;

import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import lightning.app.model.EditorModel;

/** The properties of what the artist works on: the selected light, or a material. */
public final class SidePane extends TabPane {

    public SidePane(EditorModel model) {
        setId("side");
        setAccessibleText("Properties");
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        Tab light = tab("Light", "light-tab", () -> new PropertyPane(model));
        Tab material = tab("Material", "material-tab", () -> new MaterialPane(model));
        getTabs().setAll(light, material);
        var inFront = model.materials().inFrontProperty();
        inFront.subscribe(on -> getSelectionModel().select(on ? material : light));
        getSelectionModel().selectedItemProperty().subscribe(now -> inFront.set(now == material));
    }

    /** @param content made when the tab is first in front: each is a third of all that is in the window */
    private static Tab tab(String title, String id, Supplier<Node> content) {
        var tab = new Tab(title);
        tab.setId(id);
        tab.selectedProperty().subscribe(inFront -> {
            if (inFront && tab.getContent() == null) {
                tab.setContent(content.get());
            }
        });
        return tab;
    }
}
