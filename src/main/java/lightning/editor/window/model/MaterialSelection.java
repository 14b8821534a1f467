package lightning.editor.window.model;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.MaterialEdits;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import org.jspecify.annotations.Nullable;

/** Material being edited, and whether its pane is shown in place of the selected light's. */
public final class MaterialSelection {
    private final ReadOnlyObjectWrapper<Material> material = new ReadOnlyObjectWrapper<>();
    private final SceneEditor editor;
    private String selectedName = "";
    private @Nullable Scene lastScene;

    MaterialSelection(SceneEditor editor) {
        this.editor = editor;
        editor.sceneProperty().subscribe(_ -> {
            if (lastScene == null || !haveSameMaterials(lastScene, editor.scene())) {
                refresh();
            }
        });
    }

    /** Current material; null if no shape uses one and the scene declares none. */
    public ReadOnlyObjectProperty<Material> materialProperty() {
        return material.getReadOnlyProperty();
    }

    public @Nullable Material material() {
        return material.get();
    }

    /** Selects the material of a name, or the scene's first if none has it. */
    public void choose(String name) {
        selectedName = name;
        refresh();
    }

    /** Selects the material of a shape and shows its pane. */
    public void chooseForShape(String shape) {
        MaterialEdits.ofShape(editor.scene(), shape).ifPresentOrElse(m -> {
            choose(m.name());
            editor.materialShownProperty().set(true);
        }, () -> editor.message().show(Messages.tr("The scene no longer has object {0}", Quote.of(shape))));
    }

    private void refresh() {
        Scene scene = editor.scene();
        lastScene = scene;
        List<String> names = names(scene);
        String name = names.contains(selectedName) || names.isEmpty() ? selectedName : names.getFirst();
        material.set(names.isEmpty() ? null : scene.materialsByName().get(name));
    }

    /**
     * Returns whether both scenes certainly have equal shapes and materials, by identity of their lists. Edits of lights share both lists.
     */
    public static boolean haveSameMaterials(Scene a, Scene b) {
        return a.nodes() == b.nodes() && a.materials() == b.materials();
    }

    /** Returns the names of the scene's materials in order, including the default material if shapes use it. */
    public static List<String> names(Scene scene) {
        Set<String> names = new LinkedHashSet<>(scene.materials().stream().map(Material::name).toList());
        names.addAll(scene.stage().usedMaterials());
        return List.copyOf(names);
    }

    /** Returns the names of the shapes with a material, in scene order. */
    public static List<String> shapesWith(Scene scene, String material) {
        return scene.stage().shapes().stream().filter(s -> s.material().equals(material)).map(Shape::name).toList();
    }
}
