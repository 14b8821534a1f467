package lightning.render.match;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import lightning.base.math.Vec3;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Beam;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.ColorTemperature;
import lightning.scene.value.SceneLimits;

/**
 * A number of a light, or of the environment, that a search changes. Its value is the difference from the scene where the search starts.
 *
 * @param light the light, or the environment
 * @param scale change that makes a visible difference
 * @param min   least value, ≤ 0
 * @param max   largest value, ≥ 0
 * @param isTurn whether the smallest and the largest value mean the same, and the best may be anywhere between
 * @param edit  changes a scene by a value
 */
record LightParameter(Contribution light, double scale, double min, double max, boolean isTurn, Edit edit) {
    /** Part of the distance between a light and what the camera looks at. */
    private static final double POSITION_SCALE = 0.2;
    /** Tangent of a turn. */
    private static final double DIRECTION_SCALE = 0.15;
    private static final double MAX_TURN = 1.5;
    private static final double CONE_SCALE = 5;
    private static final double MIN_CONE = 1;
    /** Millionths of the inverse of a temperature: equal steps look equally large. */
    private static final double MIRED_SCALE = 25;
    private static final double MIRED = 1e6;
    private static final double ROTATION_SCALE = 10;
    private static final double HALF_TURN = 180;

    /** Change of a scene. */
    @FunctionalInterface
    interface Edit {
        Scene apply(Scene scene, double value);
    }

    /**
     * Returns what a match may change of the lights that shine.
     *
     * @param lights these lights, and the environment
     */
    static List<LightParameter> of(Scene scene, List<Contribution> lights, MatchSettings settings) {
        List<LightParameter> parameters = new ArrayList<>();
        for (Contribution part : lights) {
            if (part.light(scene).isPresent()) {
                addLight(scene, part.light(scene).get(), settings, parameters);
            } else if (part.equals(Contribution.ENVIRONMENT) && settings.changes().contains(MatchChange.ROTATION)) {
                double rotation = World.ROTATION.get(scene.world());
                parameters.add(new LightParameter(part, ROTATION_SCALE, -HALF_TURN, HALF_TURN, true,
                        (s, v) -> s.withWorld(World.ROTATION.with(s.world(), withinLimits(rotation + v)))));
            }
        }
        return List.copyOf(parameters);
    }

    /** Returns the same rotation within the limits of scenes. */
    private static double withinLimits(double rotation) {
        return Math.abs(rotation) <= SceneLimits.MAX_ROTATION ? rotation : rotation - Math.signum(rotation) * 2 * HALF_TURN;
    }

    private static void addLight(Scene scene, Light light, MatchSettings settings, List<LightParameter> parameters) {
        if (settings.changes().contains(MatchChange.TEMPERATURES) && !settings.changes().contains(MatchChange.COLORS)) {
            double mired = MIRED / light.emission().temperature();
            parameters.add(new LightParameter(Contribution.of(light), MIRED_SCALE, MIRED / ColorTemperature.MAX - mired,
                    MIRED / ColorTemperature.MIN - mired, false,
                    ofLight(light.name(), (l, v) -> l.withEmission(l.emission().withTemperature(
                            Math.clamp(MIRED / (mired + v), ColorTemperature.MIN, ColorTemperature.MAX))))));
        }
        if (settings.changes().contains(MatchChange.POSITIONS) && LightAttribute.POSITION.appliesTo(light.type())) {
            double distance = light.position().minus(scene.camera().to()).length();
            for (Vec3 axis : List.of(new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1))) {
                parameters.add(
                        new LightParameter(Contribution.of(light), POSITION_SCALE * (distance > 0 ? distance : 1), Double.NEGATIVE_INFINITY,
                                Double.POSITIVE_INFINITY, false,
                                ofLight(light.name(), (l, v) -> l.withPosition(l.position().plus(axis.times(v))))));
            }
        }
        if (settings.changes().contains(MatchChange.DIRECTIONS) && LightAttribute.DIRECTION.appliesTo(light.type())) {
            Vec3 axis = light.direction().normalized();
            Vec3 right = axis.cross(Math.abs(axis.y()) < 0.9 ? Vec3.Y : new Vec3(1, 0, 0)).normalized();
            for (Vec3 side : List.of(right, right.cross(axis))) {
                Vec3 turn = side.times(light.direction().length());
                parameters.add(new LightParameter(Contribution.of(light), DIRECTION_SCALE, -MAX_TURN, MAX_TURN, false,
                        ofLight(light.name(), (l, v) -> l.withDirection(l.direction().plus(turn.times(v))))));
            }
        }
        if (settings.changes().contains(MatchChange.CONES)) {
            addCone(light, parameters);
        }
    }

    private static void addCone(Light light, List<LightParameter> parameters) {
        if (light.type() == LightType.SPOT) {
            parameters.add(cone(light, SceneLimits.MAX_ANGLE, Light::angle, angle -> light.withAngle(angle)));
        } else if (LightAttribute.CONE.appliesTo(light.type()) && light.beam().cone() < Beam.OPEN_ANGLE) {
            parameters.add(cone(light, Beam.OPEN_ANGLE, l -> l.beam().cone(), angle -> light.withBeam(light.beam().withCone(angle))));
        }
    }

    private static LightParameter cone(Light light, double largest, ToDoubleFunction<Light> get, DoubleFunction<Light> changed) {
        double angle = get.applyAsDouble(light);
        return new LightParameter(Contribution.of(light), CONE_SCALE, Math.min(0, MIN_CONE - angle), largest - angle, false,
                ofLight(light.name(), (l, v) -> l.withCone(changed.apply(Math.clamp(angle + v, 0, largest)).cone())));
    }

    private interface LightEdit {
        Light apply(Light light, double value);
    }

    private static Edit ofLight(String name, LightEdit edit) {
        return (scene, v) -> v == 0 ? scene : scene.withLight(edit.apply(scene.light(name).orElseThrow(), v));
    }

    /** Returns the scene where a search starts with all its parameters changed. */
    static Scene edited(Scene start, List<LightParameter> parameters, double[] values) {
        Scene scene = start;
        for (int i = 0; i < values.length; i++) {
            scene = parameters.get(i).edit.apply(scene, values[i]);
        }
        return scene;
    }

    double clamped(double value) {
        return Math.clamp(value, min, max);
    }
}
