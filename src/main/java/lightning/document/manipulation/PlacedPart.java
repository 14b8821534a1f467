package lightning.document.manipulation;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Fog;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Part of a scene that handles move: a shape or group, the flag or the filter of a light, or the box of the fog. */
public sealed interface PlacedPart {
    /** Returns where it is, in its parent's space; its scale is its size if it is no shape. */
    Placement placement();

    /**
     * Returns the scene with it elsewhere.
     *
     * @throws IllegalArgumentException if it does not exist any more, or cannot be there
     */
    Scene place(Scene scene, Placement v);

    /** Returns whether a placement has another size. */
    default boolean isScaled(Placement v) {
        return !v.scale().equals(placement().scale());
    }

    /** Returns whether it can be turned. */
    default boolean canRotate() {
        return true;
    }

    /**
     * Returns the parts whose handles are shown: the selected shape, or the flag and the filter of the selected light; and the box of the fog.
     *
     * @param node      selected shape or group; null for none
     * @param light     selected light; null for none
     * @param showsFog  whether the box of the fog has handles
     */
    static List<PlacedPart> of(Scene scene, @Nullable SceneNode node, @Nullable Light light, boolean showsFog) {
        List<PlacedPart> parts = new ArrayList<>();
        if (node != null) {
            parts.add(new OfNode(node));
        } else if (light != null) {
            if (light.flag().on()) {
                parts.add(new OfFlag(light));
            }
            if (light.filter().isActive()) {
                parts.add(new OfFilter(light));
            }
        }
        Fog fog = scene.world().fog();
        if (showsFog && fog.isPresent() && fog.hasBox()) {
            parts.add(new OfFog(fog));
        }
        return parts;
    }

    /** Returns a size that a placement may have as its scale. */
    private static Vec3 scale(Vec3 size) {
        return new Vec3(scale(size.x()), scale(size.y()), scale(size.z()));
    }

    private static double scale(double size) {
        return Math.clamp(size, SceneLimits.MIN_SCALE, SceneLimits.MAX_SCALE);
    }

    /** Shape or group. */
    record OfNode(SceneNode node) implements PlacedPart {
        @Override
        public Placement placement() {
            return node.placement();
        }

        @Override
        public Scene place(Scene scene, Placement v) {
            return scene.withNode(node.name(), node.withPlacement(v));
        }
    }

    /** Flag of a light. */
    record OfFlag(Light light) implements PlacedPart {
        @Override
        public Placement placement() {
            return new Placement(light.flag().position(), light.flag().rotation(),
                    scale(new Vec3(light.flag().width(), light.flag().height(), 1)));
        }

        @Override
        public Scene place(Scene scene, Placement v) {
            Light now = scene.light(light.name()).orElse(light);
            return scene.withLight(now.withFlag(now.flag().withPosition(v.position()).withRotation(v.rotation())
                    .withWidth(isScaled(v) ? v.scale().x() : light.flag().width())
                    .withHeight(isScaled(v) ? v.scale().y() : light.flag().height())));
        }
    }

    /** Filter of a light. */
    record OfFilter(Light light) implements PlacedPart {
        @Override
        public Placement placement() {
            return new Placement(light.filter().position(), light.filter().rotation(), scale(light.filter().size()));
        }

        @Override
        public Scene place(Scene scene, Placement v) {
            Light now = scene.light(light.name()).orElse(light);
            return scene.withLight(now.withFilter(now.filter().withPosition(v.position()).withRotation(v.rotation())
                    .withSize(isScaled(v) ? v.scale() : light.filter().size())));
        }
    }

    /** Box of the fog, which is upright. */
    record OfFog(Fog fog) implements PlacedPart {
        @Override
        public Placement placement() {
            return new Placement(fog.center(), Vec3.ZERO, scale(fog.size()));
        }

        @Override
        public Scene place(Scene scene, Placement v) {
            return scene.withWorld(scene.world().withFog(scene.world().fog().withCenter(v.position())
                    .withSize(isScaled(v) ? v.scale() : fog.size())));
        }

        @Override
        public boolean canRotate() {
            return false;
        }
    }
}
