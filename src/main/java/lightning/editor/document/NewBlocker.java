package lightning.editor.document;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.editor.document.manipulation.ViewFocus;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/** Adds blockers: cards that block the light of all lights, or of linked ones, and are not seen. */
public final class NewBlocker {
    private static final String NAME = "blocker";
    /** Place of the card on the way from the lit point to the light. */
    private static final double PLACE = 0.5;
    /** Side of the card, relative to the length of this way. */
    private static final double SIZE = 0.3;

    private NewBlocker() {}

    /** Returns the name of the next blocker. */
    public static String name(Scene scene) {
        return LightEdits.freeName(scene, NAME);
    }

    /**
     * Adds a card between a light and the point that the camera looks at, across the light's way.
     *
     * @param light name of the light; if the scene has none of this name, the strongest counts, and without lights the card is above the point
     */
    public static EditOutcome add(Scene scene, String light) {
        return EditOutcome.of(() -> {
            Material material =
                    MaterialLibrary.unique(scene, Material.of(NAME).withTransmission(Transmission.NONE.withShadows(ShadowCasting.ONLY)));
            SceneNode card = new Shape(Solid.PLANE, name(scene), material.name(), placement(scene, light));
            return MaterialLibrary.with(scene, material).withNodes(Stream.concat(scene.nodes().stream(), Stream.of(card)).toList());
        });
    }

    private static Placement placement(Scene scene, String name) {
        Vec3 focus = ViewFocus.of(scene);
        double reach = focus.minus(scene.camera().from()).length();
        Vec3 toLight = light(scene, name).map(l -> toLight(l, focus, reach)).filter(v -> v.maxAbs() > 0).findFirst()
                .orElse(new Vec3(0, reach, 0));
        Vec3 axis = toLight.normalized();
        double size = SIZE * toLight.length();
        // Turns the card's normal, which is y, toward the light.
        Vec3 rotation = new Vec3(Math.toDegrees(Math.acos(Math.clamp(axis.y(), -1, 1))),
                axis.x() == 0 && axis.z() == 0 ? 0 : Math.toDegrees(Math.atan2(axis.x(), axis.z())), 0);
        return new Placement(focus.plus(toLight.times(PLACE)), rotation, new Vec3(size, 1, size));
    }

    private static Stream<Light> light(Scene scene, String name) {
        List<Light> strongest = scene.lights().stream().filter(scene.rig()::isActive)
                .sorted(Comparator.comparingDouble((Light l) -> scene.rig().effectiveLight(l).weight().luminance()).reversed()).toList();
        return Stream.concat(scene.light(name).stream(), strongest.stream());
    }

    private static Vec3 toLight(Light light, Vec3 focus, double reach) {
        return light.type().hasPosition() ? light.position().minus(focus) : light.direction().normalized().times(-reach);
    }
}
