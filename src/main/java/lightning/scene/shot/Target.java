package lightning.scene.shot;

import java.util.List;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.LightAttribute;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.text.Quote;

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
