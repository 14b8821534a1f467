package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;

/**
 * Address of an element of a scene: a record with attributes. A scene need not have it.
 *
 * @param <T> type of the record
 */
public sealed interface SceneElement<T> {
    SceneElement<PictureSettings> PICTURE = new OfPicture();
    SceneElement<IndirectSettings> INDIRECT = new OfIndirect();
    SceneElement<Camera> CAMERA = new OfCamera();
    SceneElement<World> WORLD = new OfWorld();

    record OfPicture() implements SceneElement<PictureSettings> {}

    record OfIndirect() implements SceneElement<IndirectSettings> {}

    record OfCamera() implements SceneElement<Camera> {}

    record OfWorld() implements SceneElement<World> {}

    record OfLight(String name) implements SceneElement<Light>, Contribution {}

    record OfLightGroup(String name) implements SceneElement<LightGroup> {}

    /** @param name {@link Dome#OWN} for the world's own environment; its visible image is part of the contribution */
    record OfDome(String name) implements SceneElement<Dome>, Contribution {}

    /** Shape or group. */
    record OfNode(String name) implements SceneElement<SceneNode> {}

    record OfMaterial(String name) implements SceneElement<Material> {}

    /** Returns the elements with names, in the scene's order: lights, light groups, domes, shapes and groups, and materials. */
    static Stream<SceneElement<?>> named(Scene scene) {
        return Stream.<Stream<SceneElement<?>>>of(scene.lights().stream().map(light -> new OfLight(light.name())),
                scene.rig().lightGroups().stream().map(group -> new OfLightGroup(group.name())),
                scene.world().named().stream().map(dome -> new OfDome(dome.name())),
                Stream.of(scene.nodes()).mapMulti(SceneElement::addNodes),
                scene.materials().stream().map(material -> new OfMaterial(material.name()))).flatMap(elements -> elements);
    }

    private static void addNodes(List<SceneNode> nodes, Consumer<SceneElement<?>> all) {
        for (SceneNode node : nodes) {
            all.accept(new OfNode(node.name()));
            if (node instanceof NodeGroup group) {
                addNodes(group.children(), all);
            }
        }
    }

    /** Returns the element of a name, the first in the order of {@link #named(Scene)}; empty if the scene has none. */
    static Optional<SceneElement<?>> named(Scene scene, String name) {
        return Stream
                .<SceneElement<?>>of(new OfLight(name), new OfLightGroup(name), new OfDome(name), new OfNode(name), new OfMaterial(name))
                .filter(element -> !name.isEmpty() && element.find(scene).isPresent()).findFirst();
    }

    /** Returns its name; empty for an element of which a scene has one. */
    default String name() {
        return "";
    }

    /** Returns its record; empty if the scene does not have it. */
    // A type of elements has one type of records.
    @SuppressWarnings("unchecked")
    default Optional<T> find(Scene scene) {
        return (Optional<T>) switch (this) {
            case OfPicture _ -> Optional.of(scene.picture());
            case OfIndirect _ -> scene.picture().indirect();
            case OfCamera _ -> Optional.of(scene.camera());
            case OfWorld _ -> Optional.of(scene.world());
            case OfLight(String name) -> scene.light(name);
            case OfLightGroup(String name) -> scene.rig().lightGroup(name);
            case OfDome(String name) -> scene.world().domeOrOwn(name);
            case OfNode(String name) -> scene.stage().node(name);
            case OfMaterial(String name) -> Optional.ofNullable(scene.materialsByName().get(name));
        };
    }

    /**
     * Returns its record.
     *
     * @throws IllegalArgumentException if the scene does not have it
     */
    default T get(Scene scene) {
        return find(scene).orElseThrow(() -> new RefusalException(switch (this) {
            case OfLight(String name) -> Messages.tr("light {0} not found", Quote.of(name));
            case OfLightGroup(String name) -> Messages.tr("light group {0} not found", Quote.of(name));
            case OfDome(String name) -> Messages.tr("dome {0} not found", Quote.of(name));
            case OfNode(String name) -> Messages.tr("object {0} not found", Quote.of(name));
            case OfMaterial(String name) -> Messages.tr("material {0} not found", Quote.of(name));
            case OfIndirect _ -> Messages.tr("the scene has no indirect light");
            case OfPicture _,OfCamera _,OfWorld _ -> throw new AssertionError(this);
        }));
    }

    /**
     * Returns the scene with its record changed.
     *
     * @throws IllegalArgumentException if the scene does not have it, or may not have the record
     */
    default Scene edit(Scene scene, UnaryOperator<T> change) {
        return with(scene, change.apply(get(scene)));
    }

    /**
     * Returns the scene with another record. What refers to it follows a new name.
     *
     * @throws IllegalArgumentException if the scene does not have it, except for indirect light, or may not have the record
     */
    default Scene with(Scene scene, T record) {
        return switch (this) {
            case OfPicture _ -> scene.withPicture((PictureSettings) record);
            case OfIndirect _ -> scene.withPicture(scene.picture().withIndirect(Optional.of((IndirectSettings) record)));
            case OfCamera _ -> scene.withCamera((Camera) record);
            case OfWorld _ -> scene.withWorld((World) record);
            case OfLight(String name) -> {
                Light light = (Light) record;
                yield (light.name().equals(name) ? scene : scene.renameLight(name, light.name())).withLight(light);
            }
            case OfLightGroup(String name) -> {
                LightGroup group = (LightGroup) record;
                LightRig rig = scene.rig();
                yield scene.withRig((group.name().equals(name) ? rig : rig.renameLightGroup(name, group.name())).with(group));
            }
            case OfDome(String name) -> scene.withWorld(scene.world().withDome(name, (Dome) record));
            case OfNode(String name) -> scene.withNode(name, (SceneNode) record);
            case OfMaterial _ -> scene.withMaterial((Material) record);
        };
    }

    /**
     * Returns the scene without it. The lights of a group stay, a group of shapes takes its content along.
     *
     * @throws IllegalArgumentException if the scene does not have it, or cannot be without it
     */
    default Scene delete(Scene scene) {
        T record = get(scene);
        return switch (this) {
            case OfLight _ -> scene.withLights(scene.lights().stream().filter(light -> light != record).toList());
            case OfLightGroup(String name) -> scene.withRig(scene.rig().removeLightGroup(name));
            case OfDome _ -> scene.withWorld(scene.world().withDomes(
                    scene.world().domes().stream().filter(dome -> dome != record).toList()));
            case OfNode(String name) -> scene.replaceNode(name, List.of());
            case OfPicture _,OfIndirect _,OfCamera _,OfWorld _,OfMaterial _ ->
                    throw new RefusalException(label() + " cannot be deleted");
        };
    }

    /**
     * Returns its attributes; those of a shape or group depend on the scene, which must have it.
     *
     * @throws IllegalArgumentException if the scene does not have the shape or group
     */
    // A type of elements has one type of records.
    @SuppressWarnings("unchecked")
    default List<SceneAttribute<T, ?>> attributes(Scene scene) {
        return (List<SceneAttribute<T, ?>>) (List<?>) switch (this) {
            case OfPicture _ -> List.of(PictureSettings.DEPTH, PictureSettings.REFLECTION_RAYS);
            case OfIndirect _ -> IndirectSettings.ATTRIBUTES;
            case OfCamera _ -> Camera.ATTRIBUTES;
            case OfWorld _ -> World.ATTRIBUTES;
            case OfLight _ -> LightAttribute.ALL;
            case OfLightGroup _ -> LightGroup.ATTRIBUTES;
            case OfDome _ -> Dome.ATTRIBUTES;
            case OfNode node -> node.get(scene).attributes();
            case OfMaterial _ -> MaterialAttribute.ALL;
        };
    }

    /** Returns one of its attributes; empty if it has none of that name. Throws as {@link #attributes}. */
    default Optional<SceneAttribute<T, ?>> attribute(Scene scene, String name) {
        return attributes(scene).stream().filter(attribute -> attribute.name().equals(name)).findFirst();
    }

    /** Returns whether the scene has it. */
    default boolean existsIn(Scene scene) {
        return find(scene).isPresent();
    }

    /** Returns its name for messages: {@code light 'key'}. */
    default String label() {
        return switch (this) {
            case OfPicture _ -> "picture";
            case OfIndirect _ -> "indirect light";
            case OfCamera _ -> "camera";
            case OfWorld _ -> "world";
            case OfLight(String name) -> "light " + Quote.of(name);
            case OfLightGroup(String name) -> "light group " + Quote.of(name);
            case OfDome(String name) -> name.equals(Dome.OWN) ? "environment" : "dome " + Quote.of(name);
            case OfNode(String name) -> "object or group " + Quote.of(name);
            case OfMaterial(String name) -> "material " + Quote.of(name);
        };
    }
}
