package lightning.scene;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.attribute.AttributePart;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.value.Fog;
import lightning.scene.value.SceneLimits;

/** Attributes of a world's {@link Fog}. */
public final class FogAttributes {
    private static final AttributePart<World, Fog> PART = new AttributePart<>(Fog.NONE, World::fog, World::withFog,
            world -> world.fog().isPresent() ? Optional.empty() : Optional.of(Messages.tr("the scene has no fog")));

    public static final SceneAttribute<World, Double> DENSITY = PART.attribute("fog", "fog density",
            NumericKind.number(0, SceneLimits.MAX_FOG_DENSITY, 0.01), "per scene unit; 3 / fog is the visibility distance",
            Fog::density, Fog::withDensity).inactiveIf(_ -> Optional.empty());
    public static final SceneAttribute<World, Rgb> COLOR = PART.attribute("fog_color", "fog color", NumericKind.color(1),
            "linear red, green, blue: the share of light that is scattered", Fog::color, Fog::withColor);
    public static final SceneAttribute<World, Rgb> AMBIENT = PART.attribute("fog_ambient", "fog ambient light",
            NumericKind.color(SceneLimits.MAX_EMISSION), "linear red, green, blue", Fog::ambient, Fog::withAmbient);
    public static final SceneAttribute<World, Double> ANISOTROPY = PART.attribute("fog_anisotropy", "fog anisotropy",
            NumericKind.number(-SceneLimits.MAX_ANISOTROPY, SceneLimits.MAX_ANISOTROPY, 0.1),
            "mean cosine: 0 = even, above 0 = forward, below 0 = back", Fog::anisotropy, Fog::withAnisotropy);
    public static final SceneAttribute<World, Double> HEIGHT = PART.attribute("fog_height", "fog height",
            NumericKind.number(-SceneLimits.MAX_COORDINATE, SceneLimits.MAX_COORDINATE, 0.1), "y up to which the density is full",
            Fog::height, Fog::withHeight);
    public static final SceneAttribute<World, Double> FALLOFF = PART.attribute("fog_falloff", "fog falloff with height",
            NumericKind.number(0, SceneLimits.MAX_FOG_DENSITY, 0.1), "per scene unit above the height, 0 = none",
            Fog::falloff, Fog::withFalloff);
    public static final SceneAttribute<World, Vec3> CENTER = PART.attribute("fog_center", "fog center", NumericKind.position(),
            "center of the box, scene units", Fog::center, Fog::withCenter);
    public static final SceneAttribute<World, Vec3> SIZE = PART.attribute("fog_size", "fog size",
            NumericKind.lengths(SceneLimits.MAX_COORDINATE),
            "lengths of the box, scene units, 0 = fog everywhere", Fog::size, Fog::withSize);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<World, ?>> ALL = List.of(DENSITY, COLOR, AMBIENT, ANISOTROPY, HEIGHT, FALLOFF, CENTER, SIZE);

    private FogAttributes() {}
}
