package lightning.scene.shot;

import java.util.List;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.node.SceneNode;

/**
 * Object whose attributes have keyframes.
 *
 * @param name empty for the camera
 */
public record TrackTarget(Kind kind, String name) {
    public static final TrackTarget CAMERA = new TrackTarget(Kind.CAMERA, "");

    /** Kind of the object. */
    public enum Kind {
        CAMERA,
        LIGHT,
        LIGHT_GROUP,
        DOME,
        /** Shape or group. */
        NODE
    }

    public static TrackTarget light(String name) {
        return new TrackTarget(Kind.LIGHT, name);
    }

    public static TrackTarget bank(String name) {
        return new TrackTarget(Kind.LIGHT_GROUP, name);
    }

    public static TrackTarget dome(String name) {
        return new TrackTarget(Kind.DOME, name);
    }

    public static TrackTarget node(String name) {
        return new TrackTarget(Kind.NODE, name);
    }

    /** Returns whether the scene has it. */
    public boolean existsIn(Scene scene) {
        return switch (kind) {
            case CAMERA -> true;
            case LIGHT -> scene.light(name).isPresent();
            case LIGHT_GROUP -> scene.rig().lightGroup(name).isPresent();
            case DOME -> scene.world().dome(name).isPresent();
            case NODE -> scene.stage().hasNode(name);
        };
    }

    /**
     * Returns all its attributes, animated or not.
     *
     * @throws RefusalException if the scene does not have it
     */
    public List<? extends SceneAttribute<?, ?>> attributes(Scene scene) {
        if (!existsIn(scene)) {
            throw new RefusalException("there is no " + this);
        }
        return switch (kind) {
            case CAMERA -> Camera.ATTRIBUTES;
            case LIGHT -> LightAttribute.ALL;
            case LIGHT_GROUP -> LightGroup.ATTRIBUTES;
            case DOME -> Dome.ATTRIBUTES;
            case NODE -> scene.stage().node(name).map(SceneNode::attributes).orElseThrow();
        };
    }

    /**
     * Returns one of its attributes; empty if it has none of that name.
     *
     * @throws RefusalException if the scene does not have it
     */
    public Optional<? extends SceneAttribute<?, ?>> attribute(Scene scene, String attribute) {
        return attributes(scene).stream().filter(a -> a.name().equals(attribute)).findFirst();
    }

    /**
     * Returns the keyframe value that equals an attribute's current value.
     *
     * @throws RefusalException if the scene does not have it, if it lacks the attribute, or if that cannot be animated
     */
    public KeyframeValue value(Scene scene, String attribute) {
        if (!existsIn(scene)) {
            throw new RefusalException("there is no " + this);
        }
        return switch (kind) {
            case CAMERA -> value(scene.camera(), Camera.ATTRIBUTES, attribute);
            case LIGHT -> value(scene.light(name).orElseThrow(), LightAttribute.ALL, attribute);
            case LIGHT_GROUP -> value(scene.rig().lightGroup(name).orElseThrow(), LightGroup.ATTRIBUTES, attribute);
            case DOME -> value(scene.world().dome(name).orElseThrow(), Dome.ATTRIBUTES, attribute);
            case NODE -> {
                SceneNode node = scene.stage().node(name).orElseThrow();
                yield value(node, node.attributes(), attribute);
            }
        };
    }

    private <T> KeyframeValue value(T record, List<? extends SceneAttribute<T, ?>> attributes, String attribute) {
        return attributes.stream().filter(a -> a.name().equals(attribute)).findFirst().map(a -> value(record, a))
                .orElseThrow(() -> new RefusalException(this + " has no " + attribute + " that can be animated"));
    }

    private <T, V> KeyframeValue value(T record, SceneAttribute<T, V> attribute) {
        return switch (attribute.kind()) {
            case NumericKind<V> q -> new KeyframeValue.Numbers(q.components().apply(attribute.get(record)));
            case ChoiceKind<V> c -> new KeyframeValue.Word(c.format(attribute.get(record)));
            case ValueKind.AssetKind<?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.TextureKind _ ->
                    throw new RefusalException(this + ": " + attribute.name() + " cannot be animated: only numbers and words can");
        };
    }

    /** Returns the name for the user: {@code light 'key'}. */
    @Override
    public String toString() {
        return switch (kind) {
            case CAMERA -> "camera";
            case LIGHT -> "light " + Quote.of(name);
            case LIGHT_GROUP -> "light group " + Quote.of(name);
            case DOME -> "dome " + Quote.of(name);
            case NODE -> "object or group " + Quote.of(name);
        };
    }
}
