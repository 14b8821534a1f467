package lightning.editor.window.property;

import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.control.Tooltip;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Dome;
import lightning.scene.light.Light;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;

/** Tabs with the lists of lights and shapes, and the properties of the world. Shows the list of the selected item. */
public final class ListTabs extends TabPane {
    private final Tab world;

    public ListTabs(EditorModel model) {
        SceneEditor editor = model.editor();
        setId("lists");
        setAccessibleText(Messages.tr("Lights, objects and world"));
        getStyleClass().addAll("dense", "side");
        setTabClosingPolicy(TabClosingPolicy.UNAVAILABLE);
        Tab lights = SidePane.tab(Messages.tr("Lights"), "lights-tab", _ -> new LightListPane(editor, model.commands()));
        Tab shapes = SidePane.tab(Messages.tr("Objects"), "shapes-tab", _ -> new OutlinePane(editor, model.materials(), model.commands()));
        world = SidePane.tab(Messages.tr("World"), "world-tab", tab -> new WorldPane(model, tab.selectedProperty()));
        getTabs().setAll(lights, shapes, world);
        var solo = new FontIcon(MaterialDesignA.ALPHA_S_CIRCLE);
        solo.getStyleClass().add("world-solo");
        var soloTip = new Tooltip(Messages.tr("An environment is solo and mutes all lights that are not"));
        editor.sceneProperty().map(scene -> scene.world().environments().stream().anyMatch(Dome::solo)).subscribe(isSolo -> {
            world.setGraphic(isSolo ? solo : null);
            world.setTooltip(isSolo ? soloTip : null);
        });
        LinkDrop.switchTabsOnDrag(this);
        editor.editorStateProperty().map(s -> s.selectedNode().isPresent())
                .subscribe(isShape -> getSelectionModel().select(isShape ? shapes : lights));
        // Another selected light shows its properties again.
        editor.editorStateProperty().map(s -> s.selectedLight().map(Light::name).orElse("")).addListener((_, _, name) -> {
            if (!name.isEmpty() && world.isSelected()) {
                getSelectionModel().select(lights);
            }
        });
        model.commands().setAction(Command.EDIT_WORLD, () -> {
            model.layout().panelsHiddenProperty().set(false);
            getSelectionModel().select(world);
        });
    }

    /** True while the world's properties are shown, which then have the place of those of the selection. */
    public ReadOnlyBooleanProperty worldShownProperty() {
        return world.selectedProperty();
    }

    /** Returns steps that each create a tab's content in advance. */
    public Stream<Runnable> preloadSteps() {
        return getTabs().stream().map(tab -> () -> ((Runnable) tab.getUserData()).run());
    }
}
