package lightning.editor.window.model;

import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.value.ObservableObjectValue;
import lightning.editor.document.EditorState;
import lightning.editor.document.Selection;
import lightning.editor.document.Workbench;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.SceneNode;

/** The light, shape or group that the artist selected, as the shown scene has it. */
public final class SceneSelection {
    private final ReadOnlyObjectWrapper<Light> light = new ReadOnlyObjectWrapper<>();
    private final Workbench workbench;
    private final ObservableObjectValue<EditorState> editorState;
    private final BooleanProperty materialShown;

    /** @param materialShown whether a material's properties cover those of the selection: set to false by a selection */
    SceneSelection(Workbench workbench, ObservableObjectValue<EditorState> editorState, BooleanProperty materialShown) {
        this.workbench = workbench;
        this.editorState = editorState;
        this.materialShown = materialShown;
    }

    /** The selected light; null if none is selected. */
    public ReadOnlyObjectProperty<Light> lightProperty() {
        return light.getReadOnlyProperty();
    }

    public Light light() {
        return light.get();
    }

    /** The name of the selected light; empty if none is selected. */
    public String lightName() {
        return light.get() == null ? "" : light.get().name();
    }

    /** The selected shape or group; empty while a light is selected. */
    public Optional<SceneNode> node() {
        return editorState.get().selectedNode();
    }

    /** Selects the light of that name; nothing where there is none, or for null. */
    public void selectLight(String name) {
        if (name == null) {
            workbench.select(Selection.NONE);
        } else {
            workbench.selectLight(name);
            materialShown.set(false);
        }
    }

    /** Selects the shape or the group of that name in place of a light; nothing where there is none. */
    public void selectNode(String name) {
        workbench.select(new Selection.OfNode(name));
        materialShown.set(false);
    }

    /** Takes the selected light from the scene that is shown now. */
    void refresh(Scene scene) {
        light.set(workbench.document().selectedLight().flatMap(l -> scene.light(l.name())).orElse(null));
    }
}
