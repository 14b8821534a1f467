package lightning.render.trace;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import org.jspecify.annotations.Nullable;

/**
 * Shapes with the materials of a scene.
 *
 * @param materialNames        names of all materials that a shape has or had, in the order of their indices
 * @param vertexColorMaterials names of materials of meshes with vertex colors
 * @param castsReflections     selects the materials that cast reflected rays: all reflective ones, and possibly others
 */
record ShapeSurfaces(Scene scene, List<Shape> shapes, List<String> materialNames, Set<String> vertexColorMaterials,
        Predicate<Material> castsReflections, MaterialTable materials) {

    static ShapeSurfaces of(Scene scene, Predicate<Material> castsReflections) {
        List<Shape> shapes = scene.stage().rendered().shapes();
        return of(scene, shapes, MaterialTable.materialNames(shapes), null, castsReflections);
    }

    /** @param known table of materials to reuse */
    private static ShapeSurfaces of(Scene scene, List<Shape> shapes, List<String> names, @Nullable MaterialTable known,
            Predicate<Material> castsReflections) {
        Set<String> vertexColors = MaterialTable.vertexColorMaterials(shapes);
        return new ShapeSurfaces(scene, shapes, names, vertexColors, castsReflections,
                new MaterialTable(names, vertexColors, scene, known, castsReflections));
    }

    /** Returns the same shapes with the materials of another scene. */
    ShapeSurfaces withMaterialsOf(Scene other, Predicate<Material> newCastsReflections) {
        return new ShapeSurfaces(other, shapes, materialNames, vertexColorMaterials, newCastsReflections,
                materialsOf(other, newCastsReflections));
    }

    /** Returns the materials of another scene at the indices of these. */
    MaterialTable materialsOf(Scene other, Predicate<Material> newCastsReflections) {
        return new MaterialTable(materialNames, vertexColorMaterials, other, materials, newCastsReflections);
    }

    /** Returns the shapes of another scene; materials keep their indices. */
    ShapeSurfaces withShapesOf(Scene other) {
        List<Shape> others = other.stage().rendered().shapes();
        return of(other, others, MaterialTable.materialNames(materialNames, others), materials, castsReflections);
    }

    /** Returns whether the scene defines all materials that a shape has or had. */
    boolean hasAllMaterials() {
        return scene.stage().rendered().materialsByName().keySet().containsAll(materialNames);
    }

    /** Returns the same shapes with the indices of materials in a list of names, which contains all that are in use. */
    ShapeSurfaces withMaterialNames(List<String> names) {
        return of(scene, shapes, names, null, castsReflections);
    }

    PrimitiveTable.BoxedPrimitives primitives() {
        Map<String, Integer> index = new HashMap<>();
        materialNames.forEach(name -> index.put(name, index.size()));
        int[] materialIndices = shapes.stream().mapToInt(s -> index.get(s.material())).toArray();
        return PrimitiveTable.of(scene.stage().rendered(), materialIndices, scene.camera().origin(), scene.camera().lens().aperture());
    }
}
