package lightning.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.math.Transform;

/**
 * Everything a picture depends on. Two equal scenes give the same picture in every bit.
 *
 * @param materials names unique among themselves
 * @param nodes     shapes and groups; names unique among nodes and lights; each shape's material is
 *                  the name of one of {@code materials}, or {@code default} where none has that name
 * @param lights    in the order in which their contributions are summed
 */
public record Scene(Picture picture, Camera camera, World world, List<Material> materials, List<Node> nodes,
        List<Light> lights) {

    public Scene {
        materials = List.copyOf(materials);
        nodes = List.copyOf(nodes);
        lights = List.copyOf(lights);
        Limits.range("the number of lights", lights.size(), 0, Limits.MAX_LIGHTS);
        Limits.range("the number of materials", materials.size(), 0, Limits.MAX_MATERIALS);
        Set<String> materialNames = new HashSet<>();
        materials.forEach(m -> unique(materialNames, "material", m.name()));
        materialNames.add(Material.DEFAULT.name());
        Set<String> names = new HashSet<>();
        int shapes = checkNodes(nodes, names, materialNames, 0, 1, 1);
        Limits.range("the number of shapes", shapes, 0, Limits.MAX_SHAPES);
        lights.forEach(l -> unique(names, "light", l.name()));
    }

    private static int checkNodes(List<Node> nodes, Set<String> names, Set<String> materials, int nesting,
            double leastScale, double mostScale) {
        Limits.range("the nesting of groups", nesting, 0, Limits.MAX_NESTING);
        int shapes = 0;
        for (Node node : nodes) {
            unique(names, "shape", node.name());
            double least = leastScale * node.placement().leastScale();
            double most = mostScale * node.placement().mostScale();
            Limits.combinedScale("shape '" + node.name() + "'", least, most);
            switch (node) {
                case Group g -> shapes += checkNodes(g.children(), names, materials, nesting + 1, least, most);
                case Shape s -> {
                    if (!materials.contains(s.material())) {
                        throw new IllegalArgumentException(
                                "shape '" + s.name() + "': there is no material '" + s.material() + "'");
                    }
                    shapes++;
                }
            }
        }
        return shapes;
    }

    private static void unique(Set<String> names, String what, String name) {
        if (!names.add(name)) {
            throw new IllegalArgumentException(what + " '" + name + "': the name is already taken");
        }
    }

    /** All shapes, in the order of the file, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        List<PlacedShape> placed = new ArrayList<>();
        place(nodes, Transform.IDENTITY, Transform.IDENTITY, materialsByName(), placed);
        return placed;
    }

    /** Every material that a shape may name, {@code default} included. */
    public Map<String, Material> materialsByName() {
        Map<String, Material> byName = new HashMap<>();
        byName.put(Material.DEFAULT.name(), Material.DEFAULT);
        materials.forEach(m -> byName.put(m.name(), m));
        return byName;
    }

    private static void place(List<Node> nodes, Transform outer, Transform back, Map<String, Material> byName,
            List<PlacedShape> placed) {
        for (Node node : nodes) {
            Transform toWorld = outer.times(node.placement().transform());
            Transform directionsBack = node.placement().directionsBack().times(back);
            switch (node) {
                case Group g -> place(g.children(), toWorld, directionsBack, byName, placed);
                case Shape s -> placed.add(new PlacedShape(s, byName.get(s.material()), toWorld, directionsBack));
            }
        }
    }

    public Optional<Light> light(String name) {
        return lights.stream().filter(l -> l.name().equals(name)).findFirst();
    }

    /** Whether a light contributes: it is on, and solo if any light is. */
    public boolean shines(Light light) {
        return light.on() && (light.solo() || lights.stream().noneMatch(l -> l.solo() && l.on()));
    }

    /**
     * This scene with the light of the same name replaced.
     *
     * @throws IllegalArgumentException if no light has that name
     */
    public Scene withLight(Light light) {
        if (light(light.name()).isEmpty()) {
            throw new IllegalArgumentException("there is no light '" + light.name() + "'");
        }
        return withLights(lights.stream().map(l -> l.name().equals(light.name()) ? light : l).toList());
    }

    public Scene withLights(List<Light> v) {
        return new Scene(picture, camera, world, materials, nodes, v);
    }

    public Optional<Material> material(String name) {
        return materials.stream().filter(m -> m.name().equals(name)).findFirst();
    }

    /**
     * This scene with the material of the same name replaced; the first of the name {@code default}, which shapes without a
     * material have, is added as the last.
     *
     * @throws IllegalArgumentException if no material has that name
     */
    public Scene withMaterial(Material material) {
        if (material(material.name()).isEmpty()) {
            if (!material.name().equals(Material.DEFAULT.name())) {
                throw new IllegalArgumentException("there is no material '" + material.name() + "'");
            }
            List<Material> more = new ArrayList<>(materials);
            more.add(material);
            return withMaterials(more);
        }
        return withMaterials(materials.stream().map(m -> m.name().equals(material.name()) ? material : m).toList());
    }

    public Scene withMaterials(List<Material> v) {
        return new Scene(picture, camera, world, v, nodes, lights);
    }

    public Scene withPicture(Picture v) {
        return new Scene(v, camera, world, materials, nodes, lights);
    }

    public Scene withWorld(World v) {
        return new Scene(picture, camera, v, materials, nodes, lights);
    }

    public Scene withCamera(Camera v) {
        return new Scene(picture, v, world, materials, nodes, lights);
    }
}
