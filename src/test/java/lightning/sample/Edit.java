package lightning.sample;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Lens;
import lightning.scene.value.Placement;

/** Edit of a scene; without effect if it does not apply to the scene. Lights are identified by their index. */
public sealed interface Edit {

    /**
     * Returns the scene after the edit.
     *
     * @param history all scenes so far; the edit applies to the last
     */
    Scene apply(List<Scene> history);

    /** Applies the edit; returns the last scene if the result would be too bright, as the editor rejects it. */
    default Scene applyIfValid(List<Scene> history) {
        try {
            return apply(history);
        } catch (IllegalArgumentException e) {
            if (e.getMessage().contains("must add up to")) {
                return history.getLast();
            }
            throw e;
        }
    }

    private static Light light(Scene scene, int index) {
        return scene.lights().get(index % scene.lights().size());
    }

    private static String unusedName(Scene scene, String stem) {
        return IntStream.iterate(0, i -> i + 1).mapToObj(i -> stem + i).filter(n -> scene.light(n).isEmpty())
                .findFirst().orElseThrow();
    }

    private static Scene insert(Scene scene, int index, Light light) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(index % (lights.size() + 1), light);
        return scene.withLights(lights);
    }

    /** Changes an attribute of one light. */
    record EditLight(int index, LightChange change) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            return scene.lights().isEmpty() ? scene : scene.withLight(change.on(light(scene, index), scene));
        }
    }

    record AddLight(int at, LightTemplate seed) implements Edit {
        private static final int MOST = 7;

        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            return scene.lights().size() >= MOST ? scene : insert(scene, at, seed.instantiate(scene, unusedName(scene, "added")));
        }
    }

    record DuplicateLight(int index, int at) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            return scene.lights().isEmpty() || scene.lights().size() >= AddLight.MOST ? scene
                    : insert(scene, at, light(scene, index).withName(unusedName(scene, "copy")));
        }
    }

    record DeleteLight(int index) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            return scene.lights().isEmpty() ? scene
                    : scene.withLights(scene.lights().stream().filter(l -> l != light(scene, index)).toList());
        }
    }

    record RenameLight(int index) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            return scene.lights().isEmpty() ? scene : scene.withLights(scene.lights().stream()
                    .map(l -> l == light(scene, index) ? l.withName(unusedName(scene, "renamed")) : l).toList());
        }
    }

    /** Swaps the names of two lights: their settings and positions in the sum are exchanged. */
    record SwapLightNames(int one, int other) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            if (scene.lights().size() < 2) {
                return scene;
            }
            Light a = light(scene, one);
            Light b = light(scene, other);
            return scene.withLights(scene.lights().stream()
                    .map(l -> l == a ? a.withName(b.name()) : l == b ? b.withName(a.name()) : l).toList());
        }
    }

    record ReorderLights(int from, int to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            if (scene.lights().isEmpty()) {
                return scene;
            }
            Light moved = light(scene, from);
            return insert(scene.withLights(scene.lights().stream().filter(l -> l != moved).toList()), to, moved);
        }
    }

    /** Adds a light to a light group, or removes it from its group. */
    record AssignLightGroup(int index, int group) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            List<LightGroup> banks = scene.rig().lightGroups();
            return scene.lights().isEmpty() ? scene
                    : scene.withLight(light(scene, index).withLightGroup(group < banks.size() ? banks.get(group).name() : ""));
        }
    }

    /** Replaces a light group; adds it if there is none. */
    record EditLightGroup(int index, LightGroup to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            LightRig rig = history.getLast().rig();
            return history.getLast().withRig(rig.lightGroups().isEmpty() ? rig.addLightGroup(to)
                    : rig.with(to.withName(rig.lightGroups().get(index % rig.lightGroups().size()).name())));
        }
    }

    /** Deletes a light group and keeps its lights, or adds one. */
    record DeleteLightGroup(int index) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            LightRig rig = history.getLast().rig();
            return history.getLast().withRig(rig.lightGroups().isEmpty() ? rig.addLightGroup(LightGroup.of("fresh"))
                    : rig.removeLightGroup(rig.lightGroups().get(index % rig.lightGroups().size()).name()));
        }
    }

    record RenameLightGroup(int index) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            LightRig rig = history.getLast().rig();
            String bank = rig.lightGroups().isEmpty() ? "" : rig.lightGroups().get(index % rig.lightGroups().size()).name();
            return history.getLast().withRig(rig.lightGroups().isEmpty() ? rig
                    : rig.renameLightGroup(bank, bank.equals("named") || rig.isNameUsed("named") ? bank : "named"));
        }
    }

    /** Changes an attribute of the world. */
    record EditWorld<V>(SceneAttribute<World, V> attribute, V to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withWorld(attribute.with(history.getLast().world(), to));
        }
    }

    /** Changes an attribute of a dome, or adds one. */
    record EditDome<V>(int index, SceneAttribute<Dome, V> attribute, V to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            World world = history.getLast().world();
            if (world.named().isEmpty()) {
                return history.getLast().withWorld(world.withNamed(List.of(attribute.with(Dome.of("fresh dome"), to))));
            }
            Dome dome = world.named().get(index % world.named().size());
            return history.getLast().withWorld(world.withDome(dome.name(), attribute.with(dome, to)));
        }
    }

    /** Replaces all domes. */
    record SetDomes(List<Dome> to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withWorld(history.getLast().world().withNamed(to));
        }
    }

    record SetEnvironment(Optional<Environment> to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withWorld(history.getLast().world().withEnvironment(to).withOwn(own -> own.withLightCount(5)));
        }
    }

    record SetDepth(int to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withPicture(history.getLast().picture().withDepth(to));
        }
    }

    record Resize(int width, int height) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withPicture(history.getLast().picture().withSize(width, height));
        }
    }

    record SetSampling(SamplingSettings to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withPicture(history.getLast().picture().withSampling(to));
        }
    }

    record SetIndirect(Optional<IndirectSettings> to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withPicture(history.getLast().picture().withIndirect(to));
        }
    }

    /** Orbits the camera around its target. */
    record OrbitCamera(double side) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Camera c = history.getLast().camera();
            Vec3 step = new Vec3(side * c.from().minus(c.to()).length(), 0, 0);
            return history.getLast().withCamera(c.withView(c.from().plus(step), c.to(), c.up()));
        }
    }

    record SetLens(Lens to) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.getLast().withCamera(history.getLast().camera().withLens(to));
        }
    }

    /** Removes a node, which changes the geometry. */
    record RemoveNode(int index) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene s = history.getLast();
            if (s.nodes().isEmpty()) {
                return s;
            }
            List<SceneNode> nodes = new ArrayList<>(s.nodes());
            nodes.remove(index % nodes.size());
            return s.withNodes(nodes);
        }
    }

    /** Changes a property of one material. */
    record EditMaterial(int index, MaterialChange change) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            return scene.materials().isEmpty() ? scene
                    : scene.withMaterial(change.on(scene.materials().get(index % scene.materials().size())));
        }
    }

    /** Adds or removes an unused material, and reorders the others. */
    record AddUnusedMaterial() implements Edit {
        private static final String NAME = "unused";

        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            List<Material> materials = new ArrayList<>(scene.materials());
            if (!materials.removeIf(m -> m.name().equals(NAME))) {
                materials.add(Material.of(NAME).withAmbient(Rgb.WHITE).withDiffuse(Rgb.WHITE).withSpecular(Rgb.WHITE).withShininess(3)
                        .withReflective(Rgb.WHITE));
            }
            return scene.withMaterials(materials.reversed());
        }
    }

    /** Overrides the default material of shapes without a material, or removes the override. */
    record OverrideDefaultMaterial(MaterialChange change) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            List<Material> materials = new ArrayList<>(scene.materials());
            if (!materials.removeIf(m -> m.name().equals(Material.DEFAULT.name()))) {
                materials.add(change.on(Material.DEFAULT));
            }
            return scene.withMaterials(materials);
        }
    }

    /** Assigns another material to a top-level shape. */
    record AssignMaterial(int index, String material) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene s = history.getLast();
            if (s.nodes().isEmpty()) {
                return s;
            }
            List<SceneNode> nodes = new ArrayList<>(s.nodes());
            nodes.set(index % nodes.size(), switch (nodes.get(index % nodes.size())) {
                case Shape n -> n.withMaterial(material);
                case NodeGroup n -> n;
            });
            return s.withNodes(nodes);
        }
    }

    /** Changes a property of one shape or group, possibly nested. */
    record EditNode(int index, NodeChange change) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene scene = history.getLast();
            List<SceneNode> nodes = new ArrayList<>();
            collect(scene.nodes(), nodes);
            if (nodes.isEmpty()) {
                return scene;
            }
            SceneNode node = nodes.get(index % nodes.size());
            return scene.withNode(node.name(), change.on(node));
        }

        private static void collect(List<SceneNode> nodes, List<SceneNode> to) {
            for (SceneNode node : nodes) {
                to.add(node);
                if (node instanceof NodeGroup g) {
                    collect(g.children(), to);
                }
            }
        }
    }

    /** Duplicates a top-level shape or group at another index. */
    record DuplicateNode(int index, int at) implements Edit {
        private static final int MOST = 14;

        @Override
        public Scene apply(List<Scene> history) {
            Scene s = history.getLast();
            if (s.nodes().isEmpty() || s.nodes().size() >= MOST) {
                return s;
            }
            List<SceneNode> nodes = new ArrayList<>(s.nodes());
            SceneNode copy = NodeArbitraries.withName(nodes.get(index % nodes.size()), fresh(s));
            nodes.add(at % (nodes.size() + 1), copy);
            return s.withNodes(nodes);
        }

        private static String fresh(Scene scene) {
            return IntStream.iterate(0, i -> i + 1).mapToObj(i -> "twin" + i).filter(n -> !scene.isNameUsed(n)).findFirst().orElseThrow();
        }
    }

    /** Moves a top-level node into an identity group, the last or first node; dissolves the group if the node is it. */
    record GroupNode(int index, boolean last) implements Edit {
        private static final String NAME = "wrap";

        @Override
        public Scene apply(List<Scene> history) {
            Scene s = history.getLast();
            if (s.nodes().isEmpty()) {
                return s;
            }
            List<SceneNode> nodes = new ArrayList<>(s.nodes());
            SceneNode node = nodes.remove(index % nodes.size());
            if (node instanceof NodeGroup g && g.name().equals(NAME)) {
                nodes.addAll(g.children());
                return s.withNodes(nodes);
            }
            List<SceneNode> children = new ArrayList<>(List.of(node));
            nodes.removeIf(n -> n instanceof NodeGroup g && g.name().equals(NAME) && children.addAll(g.children()));
            nodes.add(last ? nodes.size() : 0, new NodeGroup(NAME, Placement.IDENTITY, children));
            return s.withNodes(nodes);
        }
    }

    /** Swaps two top-level nodes in the file. */
    record SwapNodes(int one, int other) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            Scene s = history.getLast();
            List<SceneNode> nodes = new ArrayList<>(s.nodes());
            if (!nodes.isEmpty()) {
                Collections.swap(nodes, one % nodes.size(), other % nodes.size());
            }
            return s.withNodes(nodes);
        }
    }

    /** Returns to an earlier scene. */
    record Undo(int steps) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            return history.get(Math.max(0, history.size() - 1 - steps));
        }
    }

    /** Applies several edits in one step (paper §4.9). */
    record CompositeEdit(List<Edit> edits) implements Edit {
        @Override
        public Scene apply(List<Scene> history) {
            List<Scene> scenes = new ArrayList<>(history);
            for (Edit edit : edits) {
                scenes.add(edit.apply(scenes));
            }
            return scenes.getLast();
        }
    }
}
