package lightning.editor.document;

import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.Light;
import lightning.scene.LightAttribute;

/**
 * Places a light by what it does in the picture, at a point that the artist shows. Where it has a direction it is turned to shine there.
 * What a drag does follows from the light as it was when the drag began and from the point under the mouse alone.
 *
 * @param startLight    the light as it was
 * @param goal      what it shall do there
 * @param distance from the point to the light, &gt; 0, where the light has a position
 */
public record LightPlacement(Light startLight, Goal goal, double distance) {
    /** Nearer than this a direction cannot be told. */
    private static final double MIN_DISTANCE = 1e-9;
    /** The sine of the least angle between the view and the normal at which there is a rim. */
    private static final double MIN_RIM_SINE = 1e-3;
    /** A light is at least this many times as far from a shadow as what throws it. */
    private static final double SHADOW_DISTANCE_FACTOR = 1.01;

    /** What the light shall do at the point. */
    public sealed interface Goal {
        /** It aims there and stays where it is. */
        record Pool() implements Goal {}

        /** Its highlight lies there: it goes where the view is mirrored to (V·R = 1 in paper §2.2). */
        record Highlight() implements Goal {}

        /** It shines straight onto the surface there: it goes along the normal (N·L = 1). */
        record Diffuse() implements Goal {}

        /**
         * Its light begins there and reaches to the edge of the shape as the eye sees it: it goes behind, along the surface, in the plane of
         * view and normal (N·L = 0).
         */
        record Rim() implements Goal {}

        /**
         * The shadow of a point falls there: it goes behind that point.
         *
         * @param occluder of what throws the shadow
         */
        record Shadow(Vec3 occluder) implements Goal {}
    }

    /** A drag that begins at a point; the light keeps its distance from there. */
    public static LightPlacement start(Light light, Goal goal, Vec3 point) {
        double distance = light.position().minus(point).length();
        return new LightPlacement(light, goal, distance >= MIN_DISTANCE ? distance : 1);
    }

    /** The same from another distance. */
    public LightPlacement withDistance(double v) {
        return new LightPlacement(startLight, goal, v);
    }

    /**
     * The light that does it at a point.
     *
     * @throws IllegalArgumentException where it cannot, and if the light has no direction but would have to turn
     */
    public Light place(ScenePicker.SurfaceHit hit) {
        Vec3 point = hit.point();
        Vec3 view = point.minus(hit.eye()).normalized();
        Vec3 normal = hit.normal();
        return switch (goal) {
            case Goal.Pool() -> aimAt(point);
            case Goal.Highlight() -> placeAlong(point, view.minus(normal.times(2 * view.dot(normal))), distance);
            case Goal.Diffuse() -> placeAlong(point, normal, distance);
            case Goal.Rim() -> {
                Vec3 tangent = view.minus(normal.times(view.dot(normal)));
                if (!(tangent.length() >= MIN_RIM_SINE)) {
                    throw new IllegalArgumentException(Messages.tr("the surface faces the camera here; a rim light needs a silhouette"));
                }
                yield placeAlong(point, tangent.normalized(), distance);
            }
            case Goal.Shadow(Vec3 thrower) -> {
                Vec3 toOccluder = thrower.minus(point);
                if (!(toOccluder.maxAbs() >= MIN_DISTANCE)) {
                    throw new IllegalArgumentException(Messages.tr("the shadow falls on its own caster"));
                }
                yield placeAlong(point, toOccluder.normalized(), distance > toOccluder.length() ? distance : 2 * toOccluder.length());
            }
        };
    }

    /**
     * A light that was placed, at another distance from its point on the same side: what it does there it does still. Nearer than what
     * throws its shadow it does not go. A directional light stays.
     *
     * @param placed as {@link #place} gave it for the point
     */
    public Light moveToDistance(Light placed, Vec3 point, double requested) {
        Vec3 offset = placed.position().minus(point);
        if (!placed.type().hasPosition() || !(offset.maxAbs() >= MIN_DISTANCE)) {
            return placed;
        }
        double minDistance =
                goal instanceof Goal.Shadow(Vec3 thrower) ? SHADOW_DISTANCE_FACTOR * thrower.minus(point).length() : MIN_DISTANCE;
        return placed.withPosition(point.plus(offset.normalized().times(Math.max(requested, minDistance))));
    }

    /** The light turned to a point; see {@link #place}. */
    Light aimAt(Vec3 point) {
        LightAttribute.DIRECTION.inactiveReason(startLight.type()).ifPresent(reason -> {
            throw new IllegalArgumentException(reason);
        });
        Vec3 direction = point.minus(startLight.position());
        if (!(direction.maxAbs() >= 1e-12)) {
            throw new IllegalArgumentException(Messages.tr("the target is at the light's position"));
        }
        return startLight.withDirection(direction);
    }

    private Light placeAlong(Vec3 point, Vec3 towardsLight, double distance) {
        Light placed = startLight.type().hasPosition() ? startLight.withPosition(point.plus(towardsLight.times(distance))) : startLight;
        return startLight.type().hasDirection() ? placed.withDirection(towardsLight.times(-startLight.direction().length())) : placed;
    }
}
