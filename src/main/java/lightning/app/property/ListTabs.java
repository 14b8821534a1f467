package lightning.app.property;

import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import lightning.app.model.EditorModel;

/** What the scene holds: its lights, and its shapes and groups. The list of what is selected comes in front. */
public final class ListTabs extends TabPane {
    public ListTabs(EditorModel model) {
        setId("lists");
        setAccessibleText("Lights and shapes");
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        Tab lights = SidePane.tab("Lights", "lights-tab", () -> new LightListPane(model));
        Tab shapes = SidePane.tab("Shapes", "shapes-tab", () -> new OutlinePane(model));
        getTabs().setAll(lights, shapes);
        model.situationProperty().map(s -> s.node().isPresent())
                .subscribe(ofShape -> getSelectionModel().select(ofShape ? shapes : lights));
    }
}
