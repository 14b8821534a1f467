package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.text.Quote;

/**
 * Everything a picture depends on. Two equal scenes give the same picture in every bit.
 *
 * @param stage shapes and materials
 * @param rig   the lights; no light and no bank has the name of a shape or a group, and together they are not too bright for the
 *              materials ({@link OverflowCheck})
 */
public record Scene(PictureSettings picture, Camera camera, World world, Stage stage, LightRig rig) {

    public Scene {
        rig.names().checkDisjoint(stage);
        rig = rig.withEnvironment(world);
        OverflowCheck.check(stage, rig);
    }

    /**
     * A scene made of its parts.
     *
     * @param materials as {@link Stage} wants them, likewise {@code nodes}
     * @param lights    as {@link LightRig} wants them
     */
    public Scene(PictureSettings picture, Camera camera, World world, List<Material> materials, List<SceneNode> nodes, List<Light> lights) {
        this(picture, camera, world, new Stage(materials, nodes), LightRig.of(lights));
    }

    public List<Material> materials() {
        return stage.materials();
    }

    public List<SceneNode> nodes() {
        return stage.nodes();
    }

    /** In the order in which their contributions are summed. */
    public List<Light> lights() {
        return rig.lights();
    }

    /** All visible shapes, in the order of the file, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        return stage.placedShapes();
    }

    /** Every material that a shape may name, {@code default} included. */
    public Map<String, Material> materialsByName() {
        return stage.materialsByName();
    }

    public Optional<Light> light(String name) {
        return rig.light(name);
    }

    /** Whether a light, a bank, a shape or a group has the name. */
    public boolean isNameUsed(String name) {
        return rig.isNameUsed(name) || stage.hasNode(name);
    }

    /** Whether a light contributes: it is on, and solo if any light is; what its bank says counts. */
    public boolean isActive(Light light) {
        return rig.isActive(light);
    }

    /**
     * Whether both show the same shapes from the same camera at the same size, so that what is known of the one's picture
     * serves the other's: they differ in lights, materials, the world and how deep mirrors are followed at most.
     */
    public boolean hasSameShapes(Scene o) {
        return hasSameView(o) && stage.hasSameNodes(o.stage);
    }

    /** Whether both are seen by the same camera at the same size. */
    public boolean hasSameView(Scene o) {
        return picture.width() == o.picture.width() && picture.height() == o.picture.height() && camera.equals(o.camera);
    }

    /**
     * This scene with the light of the same name replaced.
     *
     * @throws IllegalArgumentException if no light has that name
     */
    public Scene withLight(Light light) {
        return withRig(rig.with(light));
    }

    /** This scene with other lights and the same banks. */
    public Scene withLights(List<Light> v) {
        return withRig(rig.withLights(v));
    }

    public Scene withRig(LightRig v) {
        return new Scene(picture, camera, world, stage, v);
    }

    public Optional<Material> material(String name) {
        return materials().stream().filter(m -> m.name().equals(name)).findFirst();
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
                throw new IllegalArgumentException("there is no material " + Quote.of(material.name()));
            }
            List<Material> added = new ArrayList<>(materials());
            added.add(material);
            return withMaterials(added);
        }
        return withMaterials(materials().stream().map(m -> m.name().equals(material.name()) ? material : m).toList());
    }

    public Scene withMaterials(List<Material> v) {
        return withStage(stage.withMaterials(v));
    }

    public Scene withNodes(List<SceneNode> v) {
        return withStage(stage.withNodes(v));
    }

    /** This scene with a shape or a group in place of that name's; what links of lights name follows where it has another name. */
    public Scene withNode(String name, SceneNode node) {
        return replaceNode(name, List.of(node));
    }

    /**
     * This scene with none, one or several nodes in place of that name's: see {@link Stage#replaceNode}. Where it is one, links of lights
     * follow its name.
     */
    public Scene replaceNode(String node, List<? extends SceneNode> replacement) {
        return replacement.size() != 1 ? withStage(stage.replaceNode(node, replacement))
                : withRig(rig.mapLinks(links -> links.rename(node, replacement.getFirst().name())))
                        .withStage(stage.replaceNode(node, replacement));
    }

    /** This scene with another stage; links of lights lose the names of shapes and groups that are gone. */
    public Scene withStage(Stage v) {
        return new Scene(picture, camera, world, v, v.sharesNames(stage) ? rig : rig.mapLinks(links -> links.retain(v::hasNode)));
    }

    public Scene withPicture(PictureSettings v) {
        return new Scene(v, camera, world, stage, rig);
    }

    public Scene withWorld(World v) {
        return new Scene(picture, camera, v, stage, rig);
    }

    public Scene withCamera(Camera v) {
        return new Scene(picture, v, world, stage, rig);
    }
}
