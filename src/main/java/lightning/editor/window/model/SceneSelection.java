package lightning.editor.window.model;

import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.value.ObservableObjectValue;
import lightning.document.Selection;
import lightning.editor.EditorState;
import lightning.editor.Workbench;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.node.SceneNode;
import org.jspecify.annotations.Nullable;

/** Selected light, shape or group in the displayed scene. */
public final class SceneSelection {
    private final ReadOnlyObjectWrapper<Light> light = new ReadOnlyObjectWrapper<>();
    private final Workbench workbench;
    private final ObservableObjectValue<EditorState> editorState;
    private final BooleanProperty materialShown;

    /** @param materialShown  true if a material's properties replace those of the selection; a selection sets it to false */
    SceneSelection(Workbench workbench, ObservableObjectValue<EditorState> editorState, BooleanProperty materialShown) {
        this.workbench = workbench;
        this.editorState = editorState;
        this.materialShown = materialShown;
    }

    /** Selected light, or null. */
    public ReadOnlyObjectProperty<Light> lightProperty() {
        return light.getReadOnlyProperty();
    }

    public @Nullable Light light() {
        return light.get();
    }

    /** Returns the name of the selected light, or an empty string. */
    public String lightName() {
        return light.get() == null ? "" : light.get().name();
    }

    /** Returns the selected shape or group; empty while a light is selected. */
    public Optional<SceneNode> node() {
        return editorState.get().selectedNode();
    }

    /** Selects a light by name; null or an unknown name clears the selection. */
    public void selectLight(@Nullable String name) {
        if (name == null) {
            workbench.select(Selection.NONE);
        } else {
            workbench.selectLight(name);
            materialShown.set(false);
        }
    }

    /** Selects a shape or group by name; an unknown name clears the selection. */
    public void selectNode(String name) {
        workbench.select(new Selection.OfNode(name));
        materialShown.set(false);
    }

    /** Looks up the selected light in the displayed scene. */
    void refresh(Scene scene) {
        light.set(workbench.document().selectedLight().flatMap(l -> scene.light(l.name())).orElse(null));
    }
}
