package lightning.scene.shot;

import java.util.List;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Choice;
import lightning.scene.LightAttribute;
import lightning.scene.Node;
import lightning.scene.Quantity;
import lightning.scene.Scene;
import lightning.scene.ValueKind;

/**
 * What has keys.
 *
 * @param name empty for the camera
 */
public record Target(What what, String name) {
    public static final Target CAMERA = new Target(What.CAMERA, "");

    /** What it is. */
    public enum What {
        CAMERA,
        LIGHT,
        BANK,
        /** A shape or a group. */
        NODE
    }

    public static Target light(String name) {
        return new Target(What.LIGHT, name);
    }

    public static Target bank(String name) {
        return new Target(What.BANK, name);
    }

    public static Target node(String name) {
        return new Target(What.NODE, name);
    }

    /** Whether the scene has it. */
    public boolean isIn(Scene scene) {
        return switch (what) {
            case CAMERA -> true;
            case LIGHT -> scene.light(name).isPresent();
            case BANK -> scene.rig().bank(name).isPresent();
            case NODE -> scene.stage().hasNode(name);
        };
    }

    /**
     * All that is known of its attributes, with keys or without.
     *
     * @throws IllegalArgumentException if the scene does not have it
     */
    public List<? extends Attribute<?, ?>> attributes(Scene scene) {
        if (!isIn(scene)) {
            throw new IllegalArgumentException("there is no " + this);
        }
        return switch (what) {
            case CAMERA -> Camera.ATTRIBUTES;
            case LIGHT -> LightAttribute.ALL;
            case BANK -> Bank.ATTRIBUTES;
            case NODE -> scene.stage().node(name).map(Node::attributes).orElseThrow();
        };
    }

    /**
     * What is known of one of them; empty where it has none of that name.
     *
     * @throws IllegalArgumentException if the scene does not have it
     */
    public Optional<? extends Attribute<?, ?>> attribute(Scene scene, String attribute) {
        return attributes(scene).stream().filter(a -> a.name().equals(attribute)).findFirst();
    }

    /**
     * What a key of an attribute would say to leave it as it is.
     *
     * @throws IllegalArgumentException if the scene does not have it, if it lacks the attribute, or if that has no keys
     */
    public Setting setting(Scene scene, String attribute) {
        if (!isIn(scene)) {
            throw new IllegalArgumentException("there is no " + this);
        }
        return switch (what) {
            case CAMERA -> setting(scene.camera(), Camera.ATTRIBUTES, attribute);
            case LIGHT -> setting(scene.light(name).orElseThrow(), LightAttribute.ALL, attribute);
            case BANK -> setting(scene.rig().bank(name).orElseThrow(), Bank.ATTRIBUTES, attribute);
            case NODE -> {
                Node node = scene.stage().node(name).orElseThrow();
                yield setting(node, node.attributes(), attribute);
            }
        };
    }

    private <T> Setting setting(T record, List<? extends Attribute<T, ?>> attributes, String attribute) {
        return attributes.stream().filter(a -> a.name().equals(attribute)).findFirst().map(a -> setting(record, a))
                .orElseThrow(() -> new IllegalArgumentException(this + " has no " + attribute + " with keys"));
    }

    private <T, V> Setting setting(T record, Attribute<T, V> attribute) {
        return switch (attribute.kind()) {
            case Quantity<V> q -> new Setting.Numbers(q.split().apply(attribute.of(record)));
            case Choice<V> c -> new Setting.Word(c.text(attribute.of(record)));
            case ValueKind.Filed<?> _,ValueKind.Linking _,ValueKind.Naming _,ValueKind.Texturing _ ->
                    throw new IllegalArgumentException(this + ": " + attribute.name() + " has no keys: only numbers and words have");
        };
    }

    /** As people are told it: {@code light 'key'}. */
    @Override
    public String toString() {
        return switch (what) {
            case CAMERA -> "camera";
            case LIGHT -> "light " + Quote.of(name);
            case BANK -> "bank " + Quote.of(name);
            case NODE -> "shape or group " + Quote.of(name);
        };
    }
}
