package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/**
 * Complete input of a render. Two equal scenes give the same image in every bit.
 *
 * @param camera camera of the picture
 * @param stage shapes and materials
 * @param rig   lights; no light or light group has the name of a shape or a group, no dome that of any of these, and their total brightness passes {@link OverflowCheck}
 * @param cameras cameras to choose from, which the picture does not depend on
 */
@RecordBuilder
public record Scene(PictureSettings picture, Camera camera, World world, Stage stage, LightRig rig, List<NamedCamera> cameras)
        implements SceneBuilder.With {

    public Scene {
        rig.checkDisjoint(stage.names());
        DomeNames.checkDisjoint(world.named(), rig, stage);
        rig = rig.withEnvironments(world.environmentLights(rig::isNameUsed), world.meters()).withSurfaces(stage.surfaces(rig));
        stage = stage.withBulbs(rig).withFaces(rig);
        OverflowCheck.check(stage, rig);
        cameras = NamedCamera.check(cameras);
    }

    /** Creates a scene without named cameras. */
    public Scene(PictureSettings picture, Camera camera, World world, Stage stage, LightRig rig) {
        this(picture, camera, world, stage, rig, List.of());
    }

    /**
     * Creates a scene without named cameras from its parts.
     *
     * @param materials as {@link Stage} requires
     * @param nodes     as {@link Stage} requires
     * @param lights    as {@link LightRig} requires
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

    /** Returns the lights in the order in which their contributions are summed. */
    public List<Light> lights() {
        return rig.lights();
    }

    /** Returns all visible shapes, in file order, with materials and groups resolved. */
    public List<PlacedShape> placedShapes() {
        return stage.placedShapes();
    }

    /** Returns every material that a shape may name, including {@code default}. */
    public Map<String, Material> materialsByName() {
        return stage.materialsByName();
    }

    /** Returns the lights that are rendered, with lights for all of the environments: for programs without environments. */
    public List<Light> lightsForOtherPrograms() {
        List<Light> all = new ArrayList<>(rig.effectiveLights().subList(0, lights().size()));
        all.addAll(world.approximateLights(this::isNameUsed));
        return all;
    }

    /** Returns the names of the cameras that are kept. */
    public List<String> cameraNames() {
        return cameras.stream().map(NamedCamera::name).toList();
    }

    /** Returns the camera that is kept under a name. */
    public Optional<Camera> namedCamera(String name) {
        return cameras.stream().filter(camera -> camera.name().equals(name)).map(NamedCamera::camera).findFirst();
    }

    public Optional<Light> light(String name) {
        return rig.light(name);
    }

    /** Returns whether a light, a light group, a dome, a shape or a group has the name. */
    public boolean isNameUsed(String name) {
        return rig.isNameUsed(name) || world.dome(name).isPresent() || stage.hasNode(name);
    }

    /** Returns whether a light contributes: it is on, and solo if any light is, with its group applied. */
    public boolean isActive(Light light) {
        return rig.isActive(light);
    }

    /**
     * Returns whether both show the same shapes from the same camera at the same size, so that one can reuse the other's cache. They may
     * differ in lights, materials, the world and the reflection depth.
     */
    public boolean hasSameShapes(Scene o) {
        return hasSameView(o) && stage.rendered().hasSameNodes(o.stage.rendered());
    }

    /** Returns whether both have the same camera and image size. */
    public boolean hasSameView(Scene o) {
        return picture.width() == o.picture.width() && picture.height() == o.picture.height() && camera.equals(o.camera);
    }

    /** Returns whether both differ in the view transform at most, so that they have the same linear image. */
    public boolean hasSameImage(Scene o) {
        return picture.hasSameImage(o.picture) && camera.hasSameView(o.camera) && hasSameSamples(o) && world.equals(o.world)
                && stage.equals(o.stage) && rig.equals(o.rig);
    }

    /** Returns whether finer samples, if there are any, are at the same places of the pixels and of the lens, seen from the same camera. */
    public boolean hasSameSamples(Scene o) {
        SamplingSettings sampling = picture.sampling();
        return sampling.hasSameSamples(o.picture.sampling())
                && (!sampling.isSupersampled() || camera.lens().hasSameRays(o.camera.lens()));
    }

    /**
     * Returns whether only pixels at edges have finer samples, the first of which decide about the others. An open lens may blur an edge into
     * any pixel, and few of its points would miss much of what it sees: then all pixels have all samples.
     */
    public boolean hasSamplesOnlyAtEdges() {
        return picture.sampling().antialias() == AntialiasMode.EDGES && !camera.lens().isOpen();
    }

    /** Returns whether points off the plane of focus are blurred: the lens is open, and there are finer samples. */
    public boolean hasDepthOfField() {
        return camera.lens().isOpen() && picture.sampling().isSupersampled();
    }

    /**
     * Returns this scene with the light of the same name replaced.
     *
     * @throws RefusalException if no light has that name
     */
    public Scene withLight(Light light) {
        return withRig(rig.with(light));
    }

    /** Returns this scene with other lights and the same light groups. */
    public Scene withLights(List<Light> v) {
        return withRig(rig.withLights(v));
    }

    /**
     * Returns this scene with a light renamed; its bulbs follow the name.
     *
     * @throws RefusalException if there is no such light, or if the new name is taken or invalid
     */
    public Scene renameLight(String name, String newName) {
        if (light(name).isEmpty()) {
            throw new RefusalException("there is no light " + Quote.of(name));
        }
        return new Scene(picture, camera, world, stage.renameBulbs(name, newName),
                rig.withLights(lights().stream().map(l -> l.name().equals(name) ? l.withName(newName) : l).toList()), cameras);
    }

    public Optional<Material> material(String name) {
        return materials().stream().filter(m -> m.name().equals(name)).findFirst();
    }

    /**
     * Returns this scene with the material of the same name replaced. Adds the first material named {@code default}, which shapes without a
     * material use, at the end.
     *
     * @throws RefusalException if no material has that name
     */
    public Scene withMaterial(Material material) {
        if (material(material.name()).isEmpty()) {
            if (!material.name().equals(Material.DEFAULT.name())) {
                throw new RefusalException("there is no material " + Quote.of(material.name()));
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

    /** Returns this scene with the shape or group of that name replaced; links of lights follow a new name. */
    public Scene withNode(String name, SceneNode node) {
        return replaceNode(name, List.of(node));
    }

    /**
     * Returns this scene with the node of that name replaced by none, one or several: see {@link Stage#replaceNode}. If it is one, links of
     * lights follow its name.
     */
    public Scene replaceNode(String node, List<? extends SceneNode> replacement) {
        return replacement.size() != 1 ? withStage(stage.replaceNode(node, replacement))
                : withRig(rig.mapLinked(light -> light.renameLinks(node, replacement.getFirst().name())))
                        .withStage(stage.replaceNode(node, replacement));
    }

    /** Returns the names of all objects of a kind, in their order. */
    public List<String> names(ValueKind.NameKind.Referent referent) {
        return switch (referent) {
            case LIGHT -> lights().stream().map(Light::name).toList();
            case SHAPE -> stage.shapes().stream().map(Shape::name).toList();
            case LIGHT_GROUP -> rig.lightGroups().stream().map(LightGroup::name).toList();
        };
    }

    /** Returns this scene with another stage; links of lights lose the names of removed shapes and groups. */
    @Override
    public Scene withStage(Stage v) {
        return new Scene(picture, camera, world, v, v.sharesNames(stage) ? rig : rig.mapLinked(light -> light.retainLinks(v::hasNode)),
                cameras);
    }

    /** Returns the scene without indirect light: itself if it has none. */
    public Scene withoutIndirect() {
        return picture.indirect().isEmpty() ? this : withPicture(picture.withIndirect(Optional.empty()));
    }
}
