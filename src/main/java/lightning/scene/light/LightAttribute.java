package lightning.scene.light;

import static lightning.scene.light.LightType.DIRECTIONAL;
import static lightning.scene.light.LightType.DISC;
import static lightning.scene.light.LightType.OBJECT;
import static lightning.scene.light.LightType.POINT;
import static lightning.scene.light.LightType.RECT;
import static lightning.scene.light.LightType.SPOT;
import static lightning.scene.light.LightType.TUBE;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.attribute.AttributePart;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/** Attributes of lights, in file order. The lighting equation defines their effect. */
public final class LightAttribute<V> extends SceneAttribute<Light, V> {

    /** Section of the attribute in the editor. */
    public enum Section {
        /** Type of the light. */
        KIND(Messages.key("kind")),
        /** On, solo and light group. */
        SWITCHES(Messages.key("switches")),
        COLOR(Messages.key("color")),
        CONE(Messages.key("cone")),
        AREA(Messages.key("area")),
        ATTENUATION(Messages.key("attenuation")),
        FILTERS(Messages.key("Flag and Filter")),
        PLACE(Messages.key("Position and Direction")),
        CONTRIBUTION(Messages.key("Contribution")),
        LINKS(Messages.key("Light Linking"));

        private final String title;

        Section(String title) {
            this.title = title;
        }

        public String title() {
            return title;
        }
    }

    private static final List<LightAttribute<?>> REGISTRY = new ArrayList<>();
    private static final AttributePart<Light, Emission> EMISSIONS =
            new AttributePart<>(Emission.DEFAULT, Light::emission, Light::withEmission);
    private static final AttributePart<Light, Beam> BEAMS = new AttributePart<>(Beam.OPEN, Light::beam, Light::withBeam);
    private static final AttributePart<Light, AreaShape> AREAS = new AttributePart<>(AreaShape.DEFAULT, Light::area, Light::withArea);
    private static final AttributePart<Light, Influence> INFLUENCES =
            new AttributePart<>(Influence.DEFAULT, Light::influence, Light::withInfluence);
    private static final AttributePart<Light, LightFlag> FLAGS = new AttributePart<>(LightFlag.NONE, Light::flag, Light::withFlag);
    private static final AttributePart<Light, LightFilter> LIGHT_FILTERS =
            new AttributePart<>(LightFilter.NONE, Light::filter, Light::withFilter);

    public static final LightAttribute<LightType> TYPE = of("type", ChoiceKind.of(LightType.class), POINT, "",
            Light::type, Light::withType, Section.KIND, Map.of());
    public static final LightAttribute<Rgb> COLOR = of("color", NumericKind.color(SceneLimits.MAX_LIGHT_COLOR), Rgb.WHITE,
            "linear red, green, blue", Light::color, Light::withColor, Section.COLOR, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<Double> INTENSITY = of("intensity", NumericKind.number(0, SceneLimits.MAX_INTENSITY, 0.1), 1.0, "",
            Light::intensity, Light::withIntensity, Section.COLOR, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<Double> EXPOSURE = part(EMISSIONS, "exposure", "exposure", Emission.EXPOSURES, "stops",
            Emission::exposure, Emission::withExposure, Section.COLOR, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<IntensityUnit> UNIT = part(EMISSIONS, "unit", "intensity unit", ChoiceKind.of(IntensityUnit.class),
            "", Emission::unit, Emission::withUnit, Section.COLOR, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<Double> TEMPERATURE = part(EMISSIONS, "temperature", "temperature", Emission.TEMPERATURES, "kelvin",
            Emission::temperature, Emission::withTemperature, Section.COLOR, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<Vec3> POSITION = new LightAttribute<>("at", "position", "position", NumericKind.position(),
            Vec3.ZERO, "scene units", Light::position, Light::withPosition, Section.PLACE,
            Map.of(POINT, LightTerm.SOURCE, SPOT, LightTerm.SOURCE, RECT, LightTerm.SOURCE, DISC, LightTerm.SOURCE, TUBE,
                    LightTerm.SOURCE));
    public static final LightAttribute<Vec3> DIRECTION = of("direction", NumericKind.direction(), new Vec3(0, -1, 0),
            "any nonzero vector", Light::direction, Light::withDirection, Section.PLACE,
            Map.of(DIRECTIONAL, LightTerm.SOURCE, SPOT, LightTerm.CONE_AXIS, RECT, LightTerm.SOURCE, DISC, LightTerm.SOURCE,
                    TUBE, LightTerm.SOURCE));
    public static final LightAttribute<Falloff> FALLOFF = of("falloff", ChoiceKind.of(Falloff.class)
            .withLabels(List.of(Messages.key("custom"), Messages.key("inverse square"))), DistanceFalloff.DEFAULT.falloff(), "",
            Light::falloff,
            Light::withFalloff, Section.ATTENUATION,
            Map.of(POINT, LightTerm.FALLOFF, SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF, TUBE,
                    LightTerm.FALLOFF, OBJECT, LightTerm.FALLOFF));
    public static final LightAttribute<Attenuation> ATTENUATION =
            of("attenuation", NumericKind.attenuation(), DistanceFalloff.DEFAULT.attenuation(),
                    "per scene unit to the power 0, 1, 2", Light::attenuation, Light::withAttenuation, Section.ATTENUATION,
                    Map.of(POINT, LightTerm.FALLOFF, SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF, TUBE,
                            LightTerm.FALLOFF, OBJECT, LightTerm.FALLOFF));
    public static final LightAttribute<Double> ANGLE = of("angle", "cone half-angle", Cone.ANGLES, Cone.DEFAULT.angle(),
            "degrees, half-angle", Light::angle, Light::withAngle, Section.CONE, Map.of(SPOT, LightTerm.CONE_ANGLE));
    public static final LightAttribute<Double> DROPOFF = of("dropoff", "edge falloff", Cone.DROPOFFS, Cone.DEFAULT.dropoff(), "exponent",
            Light::dropoff, Light::withDropoff, Section.CONE, forShapedTypes());
    public static final LightAttribute<Double> CONE = part(BEAMS, "cone", "cone cutoff", Beam.CONES, "degrees, half-angle, 90 = open",
            Beam::cone, Beam::withCone, Section.CONE, forSurfaces());
    public static final LightAttribute<Double> CONE_SOFTNESS = part(BEAMS, "cone_softness", "cone softness", Beam.SOFTNESSES,
            "share of the cone", Beam::softness, Beam::withSoftness, Section.CONE, forSurfaces());
    public static final LightAttribute<Double> BEAM_SPREAD = part(BEAMS, "beam_spread", "beam spread", Beam.SPREADS,
            "degrees, half-angle, 90 = open", Beam::spread, Beam::withSpread, Section.CONE, forSurfaces());
    public static final LightAttribute<BarnDoors> DOORS =
            of("doors", "barn doors", NumericKind.doors(), Cone.DEFAULT.doors(), "degrees from the axis, 90 = open",
                    Light::doors, Light::withDoors, Section.CONE, forShapedTypes());
    public static final LightAttribute<Double> FEATHER = of("feather", Cone.FEATHERS, Cone.DEFAULT.feather(),
            "degrees inside the door's edge", Light::feather, Light::withFeather, Section.CONE,
            forShapedTypes());
    public static final LightAttribute<Optional<Gobo>> GOBO =
            of("gobo", new ValueKind.GoboKind(), Optional.empty(), "a PNG, JPEG, Radiance HDR or OpenEXR file",
                    Light::gobo, Light::withGobo, Section.CONE, forShapedTypes());
    public static final LightAttribute<Optional<IesProfile>> PROFILE =
            of("profile", "IES profile", new ValueKind.ProfileKind(), Optional.empty(), "an IES file",
                    Light::profile, Light::withProfile, Section.CONE,
                    Map.of(POINT, LightTerm.FALLOFF, SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF));
    public static final LightAttribute<Double> RADIUS = part(AREAS, "radius", "radius", AreaShape.EXTENTS, "scene units", AreaShape::radius,
            AreaShape::withRadius, Section.AREA,
            Map.of(POINT, LightTerm.SOURCE, SPOT, LightTerm.SOURCE, DISC, LightTerm.SOURCE, TUBE, LightTerm.SOURCE));
    public static final LightAttribute<Double> SPREAD = part(AREAS, "spread", "spread", AreaShape.SPREADS, "degrees, half-angle",
            AreaShape::spread, AreaShape::withSpread, Section.AREA, Map.of(DIRECTIONAL, LightTerm.SOURCE));
    public static final LightAttribute<Double> WIDTH = part(AREAS, "width", "width", AreaShape.EXTENTS, "scene units", AreaShape::width,
            AreaShape::withWidth, Section.AREA, Map.of(RECT, LightTerm.SOURCE));
    public static final LightAttribute<Double> HEIGHT = part(AREAS, "height", "height", AreaShape.EXTENTS, "scene units", AreaShape::height,
            AreaShape::withHeight, Section.AREA, Map.of(RECT, LightTerm.SOURCE, TUBE, LightTerm.SOURCE));
    public static final LightAttribute<Vec3> UP = part(AREAS, "up", "roll axis", AreaShape.UPS, "any nonzero vector", AreaShape::up,
            AreaShape::withUp, Section.AREA, Map.of(RECT, LightTerm.SOURCE, DISC, LightTerm.SOURCE));
    public static final LightAttribute<Optional<LightTexture>> TEXTURE =
            of("texture", new ValueKind.LightTextureKind(), Optional.empty(), "a PNG, JPEG, Radiance HDR or OpenEXR file",
                    Light::texture, Light::withTexture, Section.AREA, Map.of(RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF));
    public static final LightAttribute<String> SHAPE = of("shape", "shining object", AreaShape.SHAPES, AreaShape.DEFAULT.shape(),
            "name of a shape", l -> l.area().shape(),
            (l, v) -> l.withArea(l.area().withShape(v).withSurface(Optional.empty())), Section.AREA, Map.of(OBJECT, LightTerm.SOURCE));
    public static final LightAttribute<Integer> SAMPLES = part(AREAS, "samples", "samples", AreaShape.SAMPLE_COUNTS, "soft shadow samples",
            AreaShape::samples, AreaShape::withSamples, Section.AREA, forAllTypes(LightTerm.SOURCE));
    public static final LightAttribute<Boolean> VISIBLE =
            of("visible", "visible to camera", ChoiceKind.YES_OR_NO, AreaShape.DEFAULT.visibility() != FaceVisibility.HIDDEN, "",
                    l -> l.area().visibility() != FaceVisibility.HIDDEN,
                    (l, v) -> l.withArea(l.area().withVisibility(v ? FaceVisibility.GLOWING : FaceVisibility.HIDDEN)), Section.AREA,
                    Map.of(POINT, LightTerm.FACE, SPOT, LightTerm.FACE, RECT, LightTerm.FACE, DISC, LightTerm.FACE, TUBE,
                            LightTerm.FACE));
    public static final LightAttribute<Boolean> ON = of("on", ChoiceKind.YES_OR_NO, Switches.DEFAULT.on(), "", Light::on, Light::withOn,
            Section.SWITCHES, Map.of());
    public static final LightAttribute<Boolean> SOLO =
            of("solo", ChoiceKind.YES_OR_NO, Switches.DEFAULT.solo(), "", Light::solo, Light::withSolo,
                    Section.SWITCHES, Map.of());
    public static final LightAttribute<String> LIGHT_GROUP =
            of("bank", "light group", Switches.GROUPS, Switches.DEFAULT.lightGroup(), "name of a light group", Light::lightGroup,
                    Light::withLightGroup,
                    Section.SWITCHES, Map.of());
    public static final LightAttribute<ShapeLinks> ILLUMINATES = of("illuminates", new ValueKind.LinksKind(
            Messages.key("Illuminates"), Messages.key("Objects and groups that the light illuminates")),
            ShapeLinks.ALL, "shapes and groups", Light::illuminates, Light::withIlluminates, Section.LINKS,
            forAllTypes(LightTerm.ILLUMINATION_LINKS));
    public static final LightAttribute<ShapeLinks> SHADOWED_BY = new LightAttribute<>("shadowed_by", "shadowed by", "shadowed by",
            new ValueKind.LinksKind(Messages.key("Casts shadows from"),
                    Messages.key("Objects and groups that cast shadows from this light")),
            ShapeLinks.ALL, "shapes and groups", Light::shadowedBy, Light::withShadowedBy, Section.LINKS,
            forAllTypes(LightTerm.SHADOW_LINKS));
    public static final LightAttribute<Boolean> CASTS_SHADOWS = part(INFLUENCES, "casts_shadows", "casts shadows", ChoiceKind.YES_OR_NO, "",
            Influence::castsShadows, Influence::withCastsShadows, Section.CONTRIBUTION, forAllTypes(LightTerm.SHADOW_LINKS));
    public static final LightAttribute<Double> DIFFUSE = part(INFLUENCES, "diffuse", "diffuse gain", Influence.GAINS,
            "multiplies diffuse light", Influence::diffuse, Influence::withDiffuse, Section.CONTRIBUTION, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<Double> SPECULAR = part(INFLUENCES, "specular", "specular gain", Influence.GAINS,
            "multiplies highlights", Influence::specular, Influence::withSpecular, Section.CONTRIBUTION, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<Double> FOG = part(INFLUENCES, "fog", "fog gain", Influence.GAINS, "multiplies light in fog",
            Influence::fog, Influence::withFog, Section.CONTRIBUTION, forAllTypes(LightTerm.WEIGHT));
    public static final LightAttribute<ShapeGains> GAINS = part(INFLUENCES, "gains", "gains on objects",
            new ValueKind.GainsKind(Messages.key("Factors of this light on single objects and groups")),
            "shapes and groups, each with a factor", Influence::gains, Influence::withGains, Section.LINKS, forAllTypes(LightTerm.WEIGHT));

    public static final LightAttribute<Boolean> FLAG = flag("flag", "flag", ChoiceKind.YES_OR_NO, "", LightFlag::on, LightFlag::withOn);
    public static final LightAttribute<Vec3> FLAG_POSITION = flag("flag_at", "flag position", NumericKind.position(), "scene units",
            LightFlag::position, LightFlag::withPosition);
    public static final LightAttribute<Vec3> FLAG_ROTATION = flag("flag_rotate", "flag rotation", LightFilter.ROTATIONS,
            "degrees about x, then y, then z", LightFlag::rotation, LightFlag::withRotation);
    public static final LightAttribute<Double> FLAG_WIDTH =
            flag("flag_width", "flag width", LightFlag.LENGTHS, "scene units", LightFlag::width, LightFlag::withWidth);
    public static final LightAttribute<Double> FLAG_HEIGHT =
            flag("flag_height", "flag height", LightFlag.LENGTHS, "scene units", LightFlag::height, LightFlag::withHeight);
    public static final LightAttribute<Double> FLAG_SOFTNESS = flag("flag_softness", "flag softness", LightFilter.SHARES,
            "share of half its size", LightFlag::softness, LightFlag::withSoftness);
    public static final LightAttribute<Double> FLAG_DENSITY = flag("flag_density", "flag density", LightFilter.SHARES,
            "share of the light that it takes", LightFlag::density, LightFlag::withDensity);
    public static final LightAttribute<FilterShape> FILTER =
            filter("filter", "filter", ChoiceKind.of(FilterShape.class), "", LightFilter::shape, LightFilter::withShape);
    public static final LightAttribute<Vec3> FILTER_POSITION = filter("filter_at", "filter position", NumericKind.position(), "scene units",
            LightFilter::position, LightFilter::withPosition);
    public static final LightAttribute<Vec3> FILTER_ROTATION = filter("filter_rotate", "filter rotation", LightFilter.ROTATIONS,
            "degrees about x, then y, then z", LightFilter::rotation, LightFilter::withRotation);
    public static final LightAttribute<Vec3> FILTER_SIZE =
            filter("filter_size", "filter size", LightFilter.SIZES, "scene units", LightFilter::size, LightFilter::withSize);
    public static final LightAttribute<Double> FILTER_SOFTNESS = filter("filter_softness", "filter softness", LightFilter.SHARES,
            "share of half its size", LightFilter::softness, LightFilter::withSoftness);
    public static final LightAttribute<Double> FILTER_DENSITY = filter("filter_density", "filter density", LightFilter.SHARES,
            "share of the light that it takes", LightFilter::density, LightFilter::withDensity);
    public static final LightAttribute<Boolean> FILTER_INVERTED = filter("filter_invert", "filter invert", ChoiceKind.YES_OR_NO, "",
            LightFilter::inverted, LightFilter::withInverted);

    /** All attributes, in declaration order. */
    public static final List<LightAttribute<?>> ALL = List.copyOf(REGISTRY);

    private final ValueKind.LightKind<V> kind;
    private final Section section;
    private final Map<LightType, LightTerm> terms;

    /**
     * @param terms terms that it changes for each type of light that has it; none for attributes that only decide which others or which
     *     lights act
     */
    private LightAttribute(String name, String id, String title, ValueKind.LightKind<V> kind, V initial, String unit,
            Function<Light, V> get, BiFunction<Light, V, Light> with, Section section, Map<LightType, LightTerm> terms) {
        super(name, id, title, kind, initial, unit, get, with);
        this.kind = kind;
        this.section = section;
        this.terms = terms;
        REGISTRY.add(this);
    }

    private static <V> LightAttribute<V> of(String name, ValueKind.LightKind<V> kind, V initial, String unit, Function<Light, V> get,
            BiFunction<Light, V, Light> with, Section section, Map<LightType, LightTerm> terms) {
        return of(name, name, kind, initial, unit, get, with, section, terms);
    }

    private static <V> LightAttribute<V> of(String name, String title, ValueKind.LightKind<V> kind, V initial, String unit,
            Function<Light, V> get, BiFunction<Light, V, Light> with, Section section, Map<LightType, LightTerm> terms) {
        return new LightAttribute<>(name, name, title, kind, initial, unit, get, with, section, terms);
    }

    private static <V> LightAttribute<V> flag(String name, String title, ValueKind.LightKind<V> kind, String unit,
            Function<LightFlag, V> get, BiFunction<LightFlag, V, LightFlag> with) {
        return part(FLAGS, name, title, kind, unit, get, with, Section.FILTERS, forAllTypes(LightTerm.FALLOFF));
    }

    private static <V> LightAttribute<V> filter(String name, String title, ValueKind.LightKind<V> kind, String unit,
            Function<LightFilter, V> get, BiFunction<LightFilter, V, LightFilter> with) {
        return part(LIGHT_FILTERS, name, title, kind, unit, get, with, Section.FILTERS, forAllTypes(LightTerm.FALLOFF));
    }

    private static <P, V> LightAttribute<V> part(AttributePart<Light, P> part, String name, String title, ValueKind.LightKind<V> kind,
            String unit, Function<P, V> get, BiFunction<P, V, P> with, Section section, Map<LightType, LightTerm> terms) {
        return of(name, title, kind, get.apply(part.initial()), unit, part.getter(get), part.setter(with), section, terms);
    }

    /** Returns the falloff of rectangles and discs. */
    private static Map<LightType, LightTerm> forSurfaces() {
        return Map.of(RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF);
    }

    /** Returns the falloff of lights with a position and a direction. */
    private static Map<LightType, LightTerm> forShapedTypes() {
        return Map.of(SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF);
    }

    private static Map<LightType, LightTerm> forAllTypes(LightTerm term) {
        return Map.of(DIRECTIONAL, term, POINT, term, SPOT, term, RECT, term, DISC, term, TUBE, term, OBJECT, term);
    }

    @Override
    public ValueKind.LightKind<V> kind() {
        return kind;
    }

    public Section section() {
        return section;
    }

    /** Returns the term that it changes for this type of light; empty if it has no effect, or only decides about other attributes. */
    public Optional<LightTerm> term(LightType type) {
        return Optional.ofNullable(terms.get(type));
    }

    /**
     * Returns the term that it changes for this light; the number of samples and an image have no effect on a point light, nor have custom terms on an
     * inverse-square falloff.
     */
    public Optional<LightTerm> term(Light light) {
        return (this == SAMPLES || this == TEXTURE) && !light.isArea() || isReplacedBy(light.falloff())
                || missingPart(light).isPresent() ? Optional.empty()
                        : term(light.type());
    }

    private boolean isReplacedBy(Falloff falloff) {
        return this == ATTENUATION && falloff != Falloff.CUSTOM;
    }

    /** Returns whether it affects the image for this type of light. The value is kept in any case (paper §4.5). */
    public boolean appliesTo(LightType type) {
        return terms.isEmpty() || terms.containsKey(type);
    }

    @Override
    public Optional<String> inactiveReason(Light light) {
        return inactiveReason(light.type()).or(() -> isReplacedBy(light.falloff())
                ? Optional.of(Messages.tr("the falloff of the light is inverse square")) : Optional.empty()).or(() -> missingPart(light));
    }

    /** Returns a clause that says that the light has no flag or filter which this describes; empty if it has, or if this does not. */
    private Optional<String> missingPart(Light light) {
        if (section != Section.FILTERS || this == FLAG || this == FILTER) {
            return Optional.empty();
        }
        boolean ofFlag = name().startsWith("flag");
        return ofFlag ? light.flag().on() ? Optional.empty() : Optional.of(Messages.tr("the light has no flag"))
                : light.filter().isActive() ? Optional.empty() : Optional.of(Messages.tr("the light has no filter"));
    }

    /** Returns a clause that says why it has no effect for this type of light; empty if it has. */
    public Optional<String> inactiveReason(LightType type) {
        return appliesTo(type) ? Optional.empty()
                : Optional.of(Messages.tr("a {0} light has no {1}", TYPE.kind().format(type), Messages.tr(title())));
    }

    /** Returns whether copying a light's settings includes it: all except its placement and switches. */
    public boolean isSetting() {
        return switch (section) {
            case KIND, COLOR, CONE, AREA, ATTENUATION, FILTERS, CONTRIBUTION -> true;
            case PLACE, SWITCHES, LINKS -> false;
        };
    }
}
