package lightning.document.manipulation;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.document.manipulation.LightPlacement.Goal;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.jspecify.annotations.Nullable;

/**
 * Places a light where nothing is between it and its point: in front of what would block it. A light whose shadow is placed stays behind the
 * caster and in front of the next object.
 *
 * @param light   placed light
 * @param blocker name of the object that blocks the light, or would at the requested place; empty for none
 * @param change  how the light evades it
 */
public record SightPlacement(Light light, Optional<String> blocker, Change change) {
    /** Change of the requested place. */
    public enum Change {
        NONE,
        /** It is closer to the point. */
        CLOSER,
        /** It is on another side of the point, closer to the surface's normal. */
        TILTED
    }

    /** Free distance in front of a blocker, as a share of its distance; for a large light up to {@link #LARGE_CLEARANCE}. */
    private static final double CLEARANCE = 0.1;
    private static final double LARGE_CLEARANCE = 0.5;
    /** A light tilts if less than this share of its distance is free. */
    private static final double MIN_FREE = 0.05;
    private static final int TILT_STEP_DEGREES = 5;
    private static final int MAX_TILT_DEGREES = 60;
    /** Ratio of a light's distance to that of the far side of its shadow's caster. */
    private static final double BEHIND_CASTER = 1.01;
    /** Most surfaces along the way of a shadow. */
    private static final int MAX_SURFACES = 64;
    /** A light from this share of a surface's distance on touches it. */
    private static final double TOUCHING = 0.99;

    /**
     * Part of a ray that a light may be on.
     *
     * @param from    distance from the point, ≥ 0; for a shadow that of the caster's far side
     * @param to      distance of the next surface, infinite without one
     * @param blocker name of its object; null without one
     */
    private record Free(double from, double to, @Nullable String blocker) {
        double limit(Light light) {
            double gap = to - from;
            return blocker == null ? to : to - Math.max(CLEARANCE * gap, Math.min(size(light), LARGE_CLEARANCE * gap));
        }
    }

    /**
     * Places the light for a point; see {@link LightPlacement#place}.
     *
     * @param picker finds surfaces of the scene
     * @throws IllegalArgumentException as there
     */
    public static SightPlacement of(LightPlacement placing, ScenePicker.SurfaceHit hit, ScenePicker picker) {
        if (placing.goal() instanceof Goal.Pool || placing.goal() instanceof Goal.Flag) {
            Light placed = placing.place(hit);
            return new SightPlacement(placed, picker.findOccluder(hit, placed).map(ScenePicker.SurfaceHit::shape), Change.NONE);
        }
        Vec3 exact = placing.directionToLight(hit);
        Free onExact = free(placing, hit, exact, picker);
        Vec3 toLight = clearDirection(placing, hit, exact, onExact, picker);
        boolean isTilted = toLight != exact;
        Free free = isTilted ? free(placing, hit, toLight, picker) : onExact;
        double requested = placing.distance() > BEHIND_CASTER * free.from ? placing.distance() : 2 * free.from;
        boolean hasPosition = placing.startLight().type().hasPosition();
        boolean isBlocked = free.blocker != null && (!hasPosition || requested > TOUCHING * free.to);
        Light light = placing.placeAlong(hit.point(), toLight, isBlocked ? free.limit(placing.startLight()) : requested);
        return new SightPlacement(light, isTilted || isBlocked ? Optional.ofNullable(onExact.blocker) : Optional.empty(),
                isTilted ? Change.TILTED : isBlocked && hasPosition ? Change.CLOSER : Change.NONE);
    }

    /**
     * Returns the direction to the light, or one closer to the normal if the light would be too close to the point, as where a smooth mesh blocks
     * itself.
     */
    private static Vec3 clearDirection(LightPlacement placing, ScenePicker.SurfaceHit hit, Vec3 exact, Free onExact, ScenePicker picker) {
        boolean hasPosition = placing.startLight().type().hasPosition();
        double least = MIN_FREE * (hasPosition ? placing.distance() : hit.point().minus(hit.eye()).length());
        if (placing.goal() instanceof Goal.Shadow || onExact.to >= least) {
            return exact;
        }
        return IntStream.rangeClosed(1, MAX_TILT_DEGREES / TILT_STEP_DEGREES)
                .mapToObj(i -> tilted(exact, hit.normal(), i * TILT_STEP_DEGREES))
                .filter(tilted -> free(placing, hit, tilted, picker).to >= (hasPosition ? least : Double.POSITIVE_INFINITY))
                .findFirst().orElse(exact);
    }

    /** Returns this placement with another light. */
    public SightPlacement withLight(Light v) {
        return new SightPlacement(v, blocker, change);
    }

    /** Returns the light with rounded numbers; as placed, if it would be blocked with those. */
    public Light rounded(ScenePicker.SurfaceHit hit, ScenePicker picker, Light rounded) {
        boolean isLost = change != Change.NONE && picker.findOccluder(hit, rounded).isPresent();
        return isLost && picker.findOccluder(hit, light).isEmpty() ? light : rounded;
    }

    /**
     * Moves a placed light to another distance from its point, as {@link LightPlacement#moveToDistance}, up to what would block it.
     *
     * @param placed result of a placement for the point
     */
    public static SightPlacement atDistance(LightPlacement placing, Light placed, ScenePicker.SurfaceHit hit, double requested,
            ScenePicker picker) {
        Vec3 toLight = placed.position().minus(hit.point());
        if (!placed.type().hasPosition() || toLight.length() == 0) {
            return new SightPlacement(placed, Optional.empty(), Change.NONE);
        }
        Free free = free(placing, hit, toLight.normalized(), picker);
        double limit = free.limit(placed);
        boolean isBlocked = requested > limit;
        Light moved = placing.moveToDistance(placed, hit.point(), Math.max(Math.min(requested, limit), BEHIND_CASTER * free.from));
        return new SightPlacement(moved, isBlocked ? Optional.ofNullable(free.blocker) : Optional.empty(),
                isBlocked ? Change.CLOSER : Change.NONE);
    }

    private static Free free(LightPlacement placing, ScenePicker.SurfaceHit hit, Vec3 direction, ScenePicker picker) {
        boolean isShadow = placing.goal() instanceof Goal.Shadow;
        List<ScenePicker.SurfaceHit> surfaces =
                picker.occluders(hit, direction, placing.startLight().shadowCasters(), isShadow ? MAX_SURFACES : 1);
        return placing.goal() instanceof Goal.Shadow(Vec3 thrower) ? behindCaster(hit, thrower, surfaces)
                : surfaces.isEmpty() ? new Free(0, Double.POSITIVE_INFINITY, null)
                : new Free(0, distance(hit, surfaces.getFirst()), surfaces.getFirst().shape());
    }

    /** Returns the part behind the last surface of the caster up to the next object. */
    private static Free behindCaster(ScenePicker.SurfaceHit hit, Vec3 thrower, List<ScenePicker.SurfaceHit> surfaces) {
        double toThrower = thrower.minus(hit.point()).length();
        int caster = -1;
        double from = toThrower;
        for (int i = 0; i < surfaces.size(); i++) {
            double distance = distance(hit, surfaces.get(i));
            if (caster < 0 && distance >= toThrower * (1 - 1e-3)) {
                caster = i;
            }
            if (caster >= 0 && !surfaces.get(i).shape().equals(surfaces.get(caster).shape())) {
                return new Free(from, distance, surfaces.get(i).shape());
            }
            from = caster >= 0 ? Math.max(from, distance) : from;
        }
        return new Free(from, Double.POSITIVE_INFINITY, null);
    }

    private static double distance(ScenePicker.SurfaceHit hit, ScenePicker.SurfaceHit surface) {
        return surface.point().minus(hit.point()).length();
    }

    private static Vec3 tilted(Vec3 direction, Vec3 normal, double degrees) {
        Vec3 side = normal.minus(direction.times(direction.dot(normal)));
        return side.length() < 1e-6 ? direction
                : direction.times(Transform.cosDegrees(degrees)).plus(side.normalized().times(Transform.sinDegrees(degrees)));
    }

    /** Returns the radius of a sphere that contains a light. */
    private static double size(Light light) {
        AreaShape area = light.area();
        return light.type() == LightType.RECT ? Math.hypot(area.width(), area.height()) / 2
                : light.type() == LightType.TUBE ? area.height() / 2 + area.radius() : area.radius();
    }
}
