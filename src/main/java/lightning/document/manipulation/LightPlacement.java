package lightning.document.manipulation;

import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;

/**
 * Placement of a light by its effect at a chosen surface point, such as a highlight or a shadow. Lights with a direction turn to the point.
 * A drag depends only on the light at its start and the point under the mouse.
 *
 * @param startLight light at the start of the drag
 * @param goal       effect at the point
 * @param distance   distance from the point to the light, &gt; 0, if the light has a position
 */
public record LightPlacement(Light startLight, Goal goal, double distance) {
    /** Minimum distance between two points that define a direction. */
    private static final double MIN_DISTANCE = 1e-9;
    /** Minimum sine of the angle between view and normal for a rim light. */
    private static final double MIN_RIM_SINE = 1e-3;
    /** Minimum ratio of the light's distance to the caster's distance from the shadow. */
    private static final double SHADOW_DISTANCE_FACTOR = 1.01;

    /** Way from the point to the light at which a flag is, and the size of a new flag, as shares of the distance. */
    private static final double FLAG_PLACE = 0.5;
    private static final double FLAG_SIZE = 0.15;

    /** Least sine of the angle between a tube and a direction for which the tube only tilts. */
    private static final double MIN_SIDE = 1e-3;

    /** Effect of the light at the point. */
    public sealed interface Goal {
        /** Aims at the point without moving. */
        record Pool() implements Goal {}

        /** Places the highlight there: moves along the mirrored view direction (V·R = 1 in paper §2.2). */
        record Highlight() implements Goal {}

        /** Lights the surface head-on there: moves along the normal (N·L = 1). */
        record Diffuse() implements Goal {}

        /**
         * Starts a rim light there that reaches to the object's silhouette. Moves behind the object, tangentially, in the plane of view and
         * normal (N·L = 0).
         */
        record Rim() implements Goal {}

        /**
         * Casts the shadow of a point there: moves behind that point.
         *
         * @param occluder point on the shadow's caster
         */
        record Shadow(Vec3 occluder) implements Goal {}

        /** Blocks the light there by its flag, which faces the light halfway. */
        record Flag() implements Goal {}
    }

    /** Starts a drag at a point; the light keeps its distance from there. */
    public static LightPlacement start(Light light, Goal goal, Vec3 point) {
        double distance = light.position().minus(point).length();
        return new LightPlacement(light, goal, distance >= MIN_DISTANCE ? distance : 1);
    }

    /** Returns this placement at another distance. */
    public LightPlacement withDistance(double v) {
        return new LightPlacement(startLight, goal, v);
    }

    /**
     * Returns the light placed for a point.
     *
     * @throws RefusalException if no placement exists, or if the light would have to turn but has no direction
     */
    public Light place(ScenePicker.SurfaceHit hit) {
        Vec3 point = hit.point();
        return switch (goal) {
            case Goal.Pool() -> aimAt(point);
            case Goal.Flag() -> placeFlag(point, hit.eye());
            case Goal.Highlight(),Goal.Diffuse(),Goal.Rim() -> placeAlong(point, directionToLight(hit), distance);
            case Goal.Shadow(Vec3 thrower) -> {
                double toOccluder = thrower.minus(point).length();
                yield placeAlong(point, directionToLight(hit), distance > toOccluder ? distance : 2 * toOccluder);
            }
        };
    }

    /**
     * Returns the unit direction from a point to the place of a light that moves for its goal.
     *
     * @throws RefusalException if there is none
     */
    Vec3 directionToLight(ScenePicker.SurfaceHit hit) {
        Vec3 view = hit.point().minus(hit.eye()).normalized();
        Vec3 normal = hit.normal();
        return switch (goal) {
            case Goal.Highlight() -> view.minus(normal.times(2 * view.dot(normal)));
            case Goal.Diffuse() -> normal;
            case Goal.Rim() -> {
                Vec3 tangent = view.minus(normal.times(view.dot(normal)));
                if (!(tangent.length() >= MIN_RIM_SINE)) {
                    throw new RefusalException(Messages.tr("the surface faces the camera here; a rim light needs a silhouette"));
                }
                yield tangent.normalized();
            }
            case Goal.Shadow(Vec3 thrower) -> {
                Vec3 toOccluder = thrower.minus(hit.point());
                if (!(toOccluder.maxAbs() >= MIN_DISTANCE)) {
                    throw new RefusalException(Messages.tr("the shadow falls on its own caster"));
                }
                yield toOccluder.normalized();
            }
            case Goal.Pool(),Goal.Flag() -> throw new IllegalStateException("the light keeps its place");
        };
    }

    private Light placeFlag(Vec3 point, Vec3 eye) {
        boolean hasPosition = startLight.type().hasPosition();
        Vec3 toLight = hasPosition ? startLight.position().minus(point) : startLight.direction().negated();
        if (!(toLight.maxAbs() >= MIN_DISTANCE)) {
            throw new RefusalException(Messages.tr("the target is at the light's position"));
        }
        double length = hasPosition ? toLight.length() : point.minus(eye).length();
        Vec3 axis = toLight.normalized();
        LightFlag flag = startLight.flag();
        double size = FLAG_SIZE * length;
        return startLight.withFlag((flag.on() ? flag : flag.with(f -> f.on(true).width(size).height(size)))
                .withPosition(point.plus(axis.times(FLAG_PLACE * length)))
                .withRotation(new Vec3(-Math.toDegrees(Math.asin(Math.clamp(axis.y(), -1, 1))),
                        Math.toDegrees(Math.atan2(axis.x(), axis.z())), 0)));
    }

    /**
     * Moves a placed light to another distance from its point, keeping its effect there. It stays behind the caster of its shadow. A
     * directional light does not move.
     *
     * @param placed result of {@link #place} for the point
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

    /** Turns the light to a point; see {@link #place}. */
    public Light aimAt(Vec3 point) {
        LightAttribute.DIRECTION.inactiveReason(startLight.type()).ifPresent(reason -> {
            throw new RefusalException(reason);
        });
        Vec3 direction = point.minus(startLight.position());
        if (!(direction.maxAbs() >= 1e-12)) {
            throw new RefusalException(Messages.tr("the target is at the light's position"));
        }
        return turned(startLight, direction);
    }

    /** Returns a light that shines in a direction: a tube turns its side there, with as little rotation as possible. */
    public static Light turned(Light light, Vec3 direction) {
        if (light.type() != LightType.TUBE) {
            return light.withDirection(direction);
        }
        Vec3 forward = direction.normalized();
        Vec3 axis = light.direction().normalized();
        Vec3 across = axis.minus(forward.times(axis.dot(forward)));
        return light.withDirection(across.length() > MIN_SIDE ? across.normalized() : AreaShape.DEFAULT.right(forward));
    }

    /** Returns the light at a distance from a point in a direction, and turned to the point. */
    Light placeAlong(Vec3 point, Vec3 towardsLight, double distance) {
        Light placed = startLight.type().hasPosition() ? startLight.withPosition(point.plus(towardsLight.times(distance))) : startLight;
        return startLight.type().hasDirection() ? turned(placed, towardsLight.times(-startLight.direction().length())) : placed;
    }
}
