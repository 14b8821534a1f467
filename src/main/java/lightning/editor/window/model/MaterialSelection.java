package lightning.editor.window.model;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.editor.document.MaterialEdits;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;

/** Which material is being edited, and whether it is in front of the selected light's properties. */
public final class MaterialSelection {
    private final ReadOnlyObjectWrapper<Material> material = new ReadOnlyObjectWrapper<>();
    private final SceneEditor editor;
    private String selectedName = "";
    private Scene lastScene;

    MaterialSelection(SceneEditor editor) {
        this.editor = editor;
        editor.sceneProperty().subscribe(_ -> {
            if (lastScene == null || !haveSameMaterials(lastScene, editor.scene())) {
                refresh();
            }
        });
    }

    /** The material as it is now; null where no shape and no line of the scene has one. */
    public ReadOnlyObjectProperty<Material> materialProperty() {
        return material.getReadOnlyProperty();
    }

    public Material material() {
        return material.get();
    }

    /** Edits the material of that name; one that does not exist is the scene's first. */
    public void choose(String name) {
        selectedName = name;
        refresh();
    }

    /** Edits the material of a shape and shows it. */
    public void chooseForShape(String shape) {
        MaterialEdits.ofShape(editor.scene(), shape).ifPresentOrElse(m -> {
            choose(m.name());
            editor.materialShownProperty().set(true);
        }, () -> editor.message().show(Messages.tr("The scene no longer has shape {0}", Quote.of(shape))));
    }

    private void refresh() {
        Scene scene = editor.scene();
        lastScene = scene;
        List<String> names = names(scene);
        String name = names.contains(selectedName) || names.isEmpty() ? selectedName : names.getFirst();
        material.set(names.isEmpty() ? null : scene.materialsByName().get(name));
    }

    /** Whether the same shapes have the same materials for sure: lights' edits share both lists. */
    public static boolean haveSameMaterials(Scene a, Scene b) {
        return a.nodes() == b.nodes() && a.materials() == b.materials();
    }

    /** The scene's materials in its order, and the one of shapes that name none. */
    public static List<String> names(Scene scene) {
        Set<String> names = new LinkedHashSet<>(scene.materials().stream().map(Material::name).toList());
        names.addAll(scene.stage().usedMaterials());
        return List.copyOf(names);
    }

    /** The names of the shapes that have a material, in the order of the scene. */
    public static List<String> shapesWith(Scene scene, String material) {
        return scene.stage().shapes().stream().filter(s -> s.material().equals(material)).map(Shape::name).toList();
    }
}
