package lightning.document;

import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ViewFocus;
import lightning.document.manipulation.Viewport;
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
    /** Place of the card on the way from the lit point to the light, if its handle is in the picture there. */
    private static final double PLACE = 0.5;
    /** Ratio of one place to the next, nearer to the lit point, and the number of places to try. */
    private static final double STEP = 0.85;
    private static final int STEPS = 16;
    /** Distance of the handle from the picture's edge, as a share of its side. */
    private static final double MARGIN = 0.1;
    /** Side of the card, relative to its distance from the lit point. */
    private static final double SIZE = 0.6;

    private NewBlocker() {}

    /** Returns the name of the next blocker. */
    public static String name(Scene scene) {
        return LightEdits.freeName(scene, NAME);
    }

    /**
     * Adds a card between a light and the point that the camera looks at, across the light's way: halfway, or nearer to the point where the
     * camera sees it.
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
        Vec3 toCard = toLight.times(place(scene, focus, toLight));
        double size = SIZE * toCard.length();
        // Turns the card's normal, which is y, toward the light.
        Vec3 rotation = new Vec3(Math.toDegrees(Math.acos(Math.clamp(axis.y(), -1, 1))),
                axis.x() == 0 && axis.z() == 0 ? 0 : Math.toDegrees(Math.atan2(axis.x(), axis.z())), 0);
        return new Placement(focus.plus(toCard), rotation, new Vec3(size, 1, size));
    }

    private static double place(Scene scene, Vec3 focus, Vec3 toLight) {
        return DoubleStream.iterate(PLACE, place -> place * STEP).limit(STEPS)
                .filter(place -> isInPicture(scene, focus.plus(toLight.times(place)))).findFirst().orElse(PLACE);
    }

    private static boolean isInPicture(Scene scene, Vec3 point) {
        var view = PreviewCamera.of(scene);
        var picture = new Viewport(scene.picture().width(), scene.picture().height());
        Viewport.Pixel pixel = picture.project(view, point);
        return view.depth(point) > 0 && Math.abs(pixel.x() / picture.width() - 0.5) <= 0.5 - MARGIN
                && Math.abs(pixel.y() / picture.height() - 0.5) <= 0.5 - MARGIN;
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
