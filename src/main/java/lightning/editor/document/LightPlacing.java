package lightning.editor.document;

import lightning.base.math.Vec3;
import lightning.base.text.Texts;
import lightning.scene.Light;
import lightning.scene.LightAttribute;

/**
 * Places a light by what it does in the picture, at a point that the artist shows. Where it has a direction it is turned to shine there.
 * What a drag does follows from the light as it was when the drag began and from the point under the mouse alone.
 *
 * @param begin    the light as it was
 * @param act      what it shall do there
 * @param distance from the point to the light, &gt; 0, where the light has a position
 */
public record LightPlacing(Light begin, Act act, double distance) {
    /** Nearer than this a direction cannot be told. */
    private static final double NEAREST = 1e-9;
    /** The sine of the least angle between the view and the normal at which there is a rim. */
    private static final double LEAST_SLOPE = 1e-3;
    /** A light is at least this many times as far from a shadow as what throws it. */
    private static final double BEHIND = 1.01;

    /** What the light shall do at the point. */
    public sealed interface Act {
        /** It aims there and stays where it is. */
        record Pool() implements Act {}

        /** Its highlight lies there: it goes where the view is mirrored to (V·R = 1 in paper §2.2). */
        record Highlight() implements Act {}

        /** It shines straight onto the surface there: it goes along the normal (N·L = 1). */
        record Diffuse() implements Act {}

        /**
         * Its light begins there and reaches to the edge of the shape as the eye sees it: it goes behind, along the surface, in the plane of
         * view and normal (N·L = 0).
         */
        record Rim() implements Act {}

        /**
         * The shadow of a point falls there: it goes behind that point.
         *
         * @param thrower of what throws the shadow
         */
        record Shadow(Vec3 thrower) implements Act {}
    }

    /** A drag that begins at a point; the light keeps its distance from there. */
    public static LightPlacing from(Light begin, Act act, Vec3 point) {
        double distance = begin.position().minus(point).length();
        return new LightPlacing(begin, act, distance >= NEAREST ? distance : 1);
    }

    /** The same from another distance. */
    public LightPlacing withDistance(double v) {
        return new LightPlacing(begin, act, v);
    }

    /**
     * The light that does it at a point.
     *
     * @throws IllegalArgumentException where it cannot, and if the light has no direction but would have to turn
     */
    public Light at(ScenePicker.Found found) {
        Vec3 point = found.point();
        Vec3 view = point.minus(found.eye()).normalized();
        Vec3 normal = found.normal();
        return switch (act) {
            case Act.Pool() -> aimed(point);
            case Act.Highlight() -> shiningFrom(point, view.minus(normal.times(2 * view.dot(normal))), distance);
            case Act.Diffuse() -> shiningFrom(point, normal, distance);
            case Act.Rim() -> {
                Vec3 along = view.minus(normal.times(view.dot(normal)));
                if (!(along.length() >= LEAST_SLOPE)) {
                    throw new IllegalArgumentException(Texts.of("the surface faces the eye there; a rim is where it turns away"));
                }
                yield shiningFrom(point, along.normalized(), distance);
            }
            case Act.Shadow(Vec3 thrower) -> {
                Vec3 way = thrower.minus(point);
                if (!(way.maxAbs() >= NEAREST)) {
                    throw new IllegalArgumentException(Texts.of("the shadow falls on what throws it"));
                }
                yield shiningFrom(point, way.normalized(), distance > way.length() ? distance : 2 * way.length());
            }
        };
    }

    /**
     * A light that was placed, at another distance from its point on the same side: what it does there it does still. Nearer than what
     * throws its shadow it does not go. A directional light stays.
     *
     * @param placed as {@link #at} gave it for the point
     */
    public Light atDistance(Light placed, Vec3 point, double wanted) {
        Vec3 way = placed.position().minus(point);
        if (!placed.type().hasPosition() || !(way.maxAbs() >= NEAREST)) {
            return placed;
        }
        double least = act instanceof Act.Shadow(Vec3 thrower) ? BEHIND * thrower.minus(point).length() : NEAREST;
        return placed.withPosition(point.plus(way.normalized().times(Math.max(wanted, least))));
    }

    /** The light turned to a point; see {@link #at}. */
    Light aimed(Vec3 point) {
        LightAttribute.DIRECTION.obstacle(begin.type()).ifPresent(reason -> {
            throw new IllegalArgumentException(reason);
        });
        Vec3 way = point.minus(begin.position());
        if (!(way.maxAbs() >= 1e-12)) {
            throw new IllegalArgumentException(Texts.of("the light stands at the point that it should aim at"));
        }
        return begin.withDirection(way);
    }

    private Light shiningFrom(Vec3 point, Vec3 towardsLight, double far) {
        Light placed = begin.type().hasPosition() ? begin.withPosition(point.plus(towardsLight.times(far))) : begin;
        return begin.type().hasDirection() ? placed.withDirection(towardsLight.times(-begin.direction().length())) : placed;
    }
}
