package lightning.scene;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.scene.attribute.AttributePart;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.sky.Sky;
import lightning.scene.sky.SkyUnit;
import lightning.scene.value.SceneLimits;

/** Attributes of a world's {@link Sky}. */
public final class SkyAttributes {
    private static final AttributePart<World, Sky> PART = new AttributePart<>(Sky.NONE, World::sky, World::withSky,
            world -> world.sky().on() ? Optional.empty() : Optional.of(Messages.tr("the physical sky is off")));

    public static final SceneAttribute<World, Boolean> ON = PART.attribute("sky", "physical sky", ChoiceKind.YES_OR_NO,
            "", Sky::on, Sky::withOn).inactiveIf(_ -> Optional.empty());
    public static final SceneAttribute<World, Double> ELEVATION = PART.attribute("sky_elevation", "sun elevation",
            NumericKind.degrees(Sky.MIN_ELEVATION, 90, 5), "degrees above the horizon", Sky::elevation, Sky::withElevation);
    public static final SceneAttribute<World, Double> AZIMUTH = PART.attribute("sky_azimuth", "sun azimuth",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), "degrees from -z toward x", Sky::azimuth,
            Sky::withAzimuth);
    public static final SceneAttribute<World, Double> TURBIDITY = PART.attribute("sky_turbidity", "sky turbidity",
            NumericKind.number(1, Sky.MAX_TURBIDITY, 0.5), "1 = pure air, 2 to 3 = clear day, 10 = haze", Sky::turbidity,
            Sky::withTurbidity);
    public static final SceneAttribute<World, Rgb> GROUND = PART.attribute("sky_ground", "ground color", NumericKind.color(1),
            "linear red, green, blue: the share of light that the ground reflects", Sky::ground, Sky::withGround);
    public static final SceneAttribute<World, Double> SUN = PART.attribute("sky_sun", "sun strength",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), "multiplies the sun's light, not the sky's", Sky::sun,
            Sky::withSun);
    public static final SceneAttribute<World, Double> SUN_RADIUS = PART.attribute("sky_sun_radius", "sun radius",
            NumericKind.degrees(Sky.MIN_SUN_RADIUS, Sky.MAX_SUN_RADIUS, 0.1), "half the angle of its disc, degrees", Sky::sunRadius,
            Sky::withSunRadius);
    public static final SceneAttribute<World, SkyUnit> UNIT = PART.attribute("sky_unit", "sky unit", ChoiceKind.of(SkyUnit.class),
            "", Sky::unit, Sky::withUnit);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<World, ?>> ALL = List.of(ON, ELEVATION, AZIMUTH, TURBIDITY, GROUND, SUN, SUN_RADIUS, UNIT);

    private SkyAttributes() {}
}
