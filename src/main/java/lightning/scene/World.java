package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.Texts;

/**
 * What surrounds the shapes.
 *
 * @param ambience    the factor on every material's ambient colour, ≥ 0
 * @param background  the linear colour where a ray hits nothing, ≥ 0; an environment takes its place
 * @param environment what is far around, seen where a ray hits nothing, and a light
 * @param rotation    how far the environment is turned about y, degrees
 * @param intensity   a factor of all that comes from the environment
 * @param lamps       how many directional lamps its light is made of
 * @param softness    how far each lamp is spread over the part that it stands for, 0 … 1
 */
@RecordBuilder
public record World(double ambience, Rgb background, Optional<Panorama> environment, double rotation, double intensity, int lamps,
        double softness) implements WorldBuilder.With {
    public static final Attribute<World, Double> AMBIENCE = new Attribute<>("ambience", "ambience",
            Quantity.number(0, Limits.MAX_AMBIENCE, 0.1), 1.0, "", World::ambience, World::withAmbience);
    public static final Attribute<World, Rgb> BACKGROUND = new Attribute<>("background", "background",
            Quantity.color(Limits.MAX_EMISSION), Rgb.BLACK, "linear red, green, blue", World::background, World::withBackground);
    public static final Attribute<World, Optional<Panorama>> ENVIRONMENT = new Attribute<>("environment", "environment",
            new ValueKind.Surrounding(), Optional.empty(), "a Radiance HDR file", World::environment, World::withEnvironment);
    public static final Attribute<World, Double> ROTATION = new Attribute<>("rotation", "environment rotation",
            Quantity.degrees(-Limits.MAX_ROTATION, Limits.MAX_ROTATION, 5), 0.0, "degrees about y", World::rotation, World::withRotation);
    public static final Attribute<World, Double> INTENSITY = new Attribute<>("intensity", "environment intensity",
            Quantity.number(0, Limits.MAX_BANK_INTENSITY, 0.1), 1.0, "factor of the environment", World::intensity, World::withIntensity);
    public static final Attribute<World, Integer> LAMPS = new Attribute<>("lamps", "environment lamps",
            Quantity.whole(Limits.MIN_LIGHT_SAMPLES, Limits.MAX_LIGHT_SAMPLES), 16, "that the environment's light is made of", World::lamps,
            World::withLamps);

    public static final Attribute<World, Double> SOFTNESS = new Attribute<>("softness", "environment softness",
            Quantity.number(0, 1, 0.1), 0.0, "share of the parts that the lamps stand for", World::softness, World::withSoftness);

    /** All of them, in the order in which a file writes them. */
    public static final List<Attribute<World, ?>> ATTRIBUTES =
            List.of(AMBIENCE, BACKGROUND, ENVIRONMENT, ROTATION, INTENSITY, LAMPS, SOFTNESS);

    /** Of a lamp that is spread: the least, as there are many lamps. */
    private static final int SAMPLES = Limits.MIN_LIGHT_SAMPLES;

    public static final World DEFAULT = new World(AMBIENCE.initial(), BACKGROUND.initial());

    public World {
        AMBIENCE.check(ambience);
        BACKGROUND.check(background);
        ROTATION.check(rotation);
        INTENSITY.check(intensity);
        LAMPS.check(lamps);
        SOFTNESS.check(softness);
    }

    /** A world without an environment. */
    public World(double ambience, Rgb background) {
        this(ambience, background, ENVIRONMENT.initial(), ROTATION.initial(), INTENSITY.initial(), LAMPS.initial(),
                SOFTNESS.initial());
    }

    /** Why a value of an attribute does nothing in this world: a clause; empty where it acts. */
    public Optional<String> obstacle(Attribute<World, ?> attribute) {
        boolean ofEnvironment = attribute == ROTATION || attribute == INTENSITY || attribute == LAMPS || attribute == SOFTNESS;
        return ofEnvironment && environment.isEmpty() ? Optional.of(Texts.of("the scene has no environment")) : Optional.empty();
    }

    /**
     * The directional lights that its environment is made of, none without one.
     *
     * @param taken whether a name is another light's
     */
    List<Light> lights(Predicate<String> taken) {
        if (environment.isEmpty()) {
            return List.of();
        }
        List<Light> lights = new ArrayList<>();
        double cos = Transform.cosDegrees(rotation);
        double sin = Transform.sinDegrees(rotation);
        String name = "environment";
        while (taken.test(name + " 1")) {
            name += "'";
        }
        for (SkyLamp lamp : environment.get().sky().lamps(lamps)) {
            Vec3 at = lamp.towards();
            double most = Math.max(lamp.red(), Math.max(lamp.green(), lamp.blue()));
            lights.add(Light.of(name + " " + (lights.size() + 1), LightType.DIRECTIONAL)
                    .withDirection(new Vec3(-(at.x() * cos + at.z() * sin), -at.y(), at.x() * sin - at.z() * cos))
                    .withColor(most > 0 ? new Rgb(lamp.red() / most, lamp.green() / most, lamp.blue() / most) : Rgb.BLACK)
                    .withIntensity(Math.min(most * intensity, Limits.MAX_LAMP_INTENSITY))
                    .withArea(Area.DEFAULT.withSpread(lamp.spread() * softness).withSamples(SAMPLES)));
        }
        return lights;
    }
}
