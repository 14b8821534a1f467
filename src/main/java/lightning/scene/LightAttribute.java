package lightning.scene;

import static lightning.scene.LightType.DIRECTIONAL;
import static lightning.scene.LightType.DISC;
import static lightning.scene.LightType.POINT;
import static lightning.scene.LightType.RECT;
import static lightning.scene.LightType.SPOT;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Texts;

/**
 * The attributes of lights, each described here and nowhere else, in the order in which a file writes them. What a light does
 * with them is told by the lighting equation.
 */
public final class LightAttribute<V> extends Attribute<Light, V> {

    /** What people find together. */
    public enum Section {
        /** What it is. */
        KIND,
        /** Whether it shines, and with which others. */
        SWITCHES,
        COLOUR,
        CONE,
        AREA,
        ATTENUATION,
        PLACE,
        LINKS
    }

    private static final List<LightAttribute<?>> DECLARED = new ArrayList<>();

    public static final LightAttribute<LightType> TYPE = of("type", Choice.of(LightType.class), POINT, "",
            Light::type, Light::withType, Section.KIND, Map.of());
    public static final LightAttribute<Rgb> COLOR = of("color", Quantity.color(Limits.MAX_LIGHT_COLOR), Rgb.WHITE,
            "linear red, green, blue", Light::color, Light::withColor, Section.COLOUR, all(LightTerm.WEIGHT));
    public static final LightAttribute<Double> INTENSITY = of("intensity", Quantity.number(0, Limits.MAX_INTENSITY, 0.1), 1.0, "",
            Light::intensity, Light::withIntensity, Section.COLOUR, all(LightTerm.WEIGHT));
    public static final LightAttribute<Vec3> POSITION = new LightAttribute<>("at", "position", Quantity.position(), Vec3.ZERO,
            "scene units", Light::position, Light::withPosition, Section.PLACE,
            Map.of(POINT, LightTerm.SOURCE, SPOT, LightTerm.SOURCE, RECT, LightTerm.SOURCE, DISC, LightTerm.SOURCE));
    public static final LightAttribute<Vec3> DIRECTION = of("direction", Quantity.direction(), new Vec3(0, -1, 0),
            "any length but 0", Light::direction, Light::withDirection, Section.PLACE,
            Map.of(DIRECTIONAL, LightTerm.SOURCE, SPOT, LightTerm.AXIS, RECT, LightTerm.SOURCE, DISC, LightTerm.SOURCE));
    public static final LightAttribute<Attenuation> ATTENUATION = of("attenuation", Quantity.attenuation(), Attenuation.NONE,
            "per scene unit to the power 0, 1, 2", Light::attenuation, Light::withAttenuation, Section.ATTENUATION,
            Map.of(POINT, LightTerm.FALLOFF, SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF, DISC, LightTerm.FALLOFF));
    public static final LightAttribute<Double> ANGLE = of("angle", Quantity.degrees(0, Limits.MAX_ANGLE, 1), 30.0,
            "degrees from the axis", Light::angle, Light::withAngle, Section.CONE, Map.of(SPOT, LightTerm.OPENING));
    public static final LightAttribute<Double> DROPOFF = of("dropoff", Quantity.number(0, Limits.MAX_DROPOFF, 0.1), 0.0,
            "exponent", Light::dropoff, Light::withDropoff, Section.CONE, Map.of(SPOT, LightTerm.FALLOFF));
    public static final LightAttribute<BarnDoors> DOORS = of("doors", Quantity.doors(), BarnDoors.OPEN, "degrees from the axis, 90 is open",
            Light::doors, Light::withDoors, Section.CONE, Map.of(SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF));
    public static final LightAttribute<Double> FEATHER = of("feather", Quantity.degrees(0, Limits.MAX_FEATHER, 1), 0.0,
            "degrees inside the edge of a door", Light::feather, Light::withFeather, Section.CONE,
            Map.of(SPOT, LightTerm.FALLOFF, RECT, LightTerm.FALLOFF));
    public static final LightAttribute<Optional<Gobo>> GOBO = of("gobo", new ValueKind.Projecting(), Optional.empty(), "a PNG or JPEG file",
            Light::gobo, Light::withGobo, Section.CONE, Map.of(SPOT, LightTerm.FALLOFF));
    public static final LightAttribute<Optional<Profile>> PROFILE = of("profile", new ValueKind.Shining(), Optional.empty(), "an IES file",
            Light::profile, Light::withProfile, Section.CONE, Map.of(POINT, LightTerm.FALLOFF, SPOT, LightTerm.FALLOFF));
    public static final LightAttribute<Double> RADIUS = of("radius", Quantity.number(0, Limits.MAX_EXTENT, 0.1), Area.DEFAULT.radius(),
            "scene units", l -> l.area().radius(), (l, v) -> l.withArea(l.area().withRadius(v)), Section.AREA,
            Map.of(POINT, LightTerm.SOURCE, SPOT, LightTerm.SOURCE, DISC, LightTerm.SOURCE));
    public static final LightAttribute<Double> SPREAD = of("spread", Quantity.degrees(0, Limits.MAX_SPREAD, 0.5), Area.DEFAULT.spread(),
            "degrees from the direction", l -> l.area().spread(), (l, v) -> l.withArea(l.area().withSpread(v)), Section.AREA,
            Map.of(DIRECTIONAL, LightTerm.SOURCE));
    public static final LightAttribute<Double> WIDTH = of("width", Quantity.number(0, Limits.MAX_EXTENT, 0.1), Area.DEFAULT.width(),
            "scene units", l -> l.area().width(), (l, v) -> l.withArea(l.area().withWidth(v)), Section.AREA,
            Map.of(RECT, LightTerm.SOURCE));
    public static final LightAttribute<Double> HEIGHT = of("height", Quantity.number(0, Limits.MAX_EXTENT, 0.1), Area.DEFAULT.height(),
            "scene units", l -> l.area().height(), (l, v) -> l.withArea(l.area().withHeight(v)), Section.AREA,
            Map.of(RECT, LightTerm.SOURCE));
    public static final LightAttribute<Vec3> UP = of("up", Quantity.direction(), Area.DEFAULT.up(), "any length but 0",
            l -> l.area().up(), (l, v) -> l.withArea(l.area().withUp(v)), Section.AREA, Map.of(RECT, LightTerm.SOURCE));
    public static final LightAttribute<Integer> SAMPLES = of("samples", Quantity.whole(Limits.MIN_LIGHT_SAMPLES, Limits.MAX_LIGHT_SAMPLES),
            Area.DEFAULT.samples(), "of a light that is larger than a point", l -> l.area().samples(),
            (l, v) -> l.withArea(l.area().withSamples(v)), Section.AREA, all(LightTerm.SOURCE));
    public static final LightAttribute<Boolean> ON = of("on", Choice.YES_OR_NO, true, "", Light::on, Light::withOn,
            Section.SWITCHES, Map.of());
    public static final LightAttribute<Boolean> SOLO = of("solo", Choice.YES_OR_NO, false, "", Light::solo, Light::withSolo,
            Section.SWITCHES, Map.of());
    public static final LightAttribute<String> BANK =
            of("bank", new ValueKind.Naming(scene -> scene.rig().banks().stream().map(Bank::name).toList(),
                    Texts.key("The bank that the light belongs to")), "", "the name of a bank", Light::bank, Light::withBank,
                    Section.SWITCHES, Map.of());
    public static final LightAttribute<Links> ILLUMINATES = of("illuminates", new ValueKind.Linking(
            Texts.key("Shines on"), Texts.key("The shapes and groups that the light shines on")), Links.ALL, "shapes and groups",
            Light::illuminates, Light::withIlluminates, Section.LINKS, all(LightTerm.REACH));
    public static final LightAttribute<Links> SHADOWED_BY = new LightAttribute<>("shadowed_by", "shadowed by", new ValueKind.Linking(
            Texts.key("Shadowed by"), Texts.key("The shapes and groups that throw shadows in its light")),
            Links.ALL, "shapes and groups", Light::shadowedBy, Light::withShadowedBy, Section.LINKS, all(LightTerm.SHADOW));

    /** All of them, as they are declared above. */
    public static final List<LightAttribute<?>> ALL = List.copyOf(DECLARED);

    private final ValueKind.OfLight<V> kind;
    private final Section section;
    private final Map<LightType, LightTerm> terms;

    /**
     * @param terms what it changes of a light of each type that has it; none where it decides which others act, or
     *              whether any does
     */
    private LightAttribute(String name, String title, ValueKind.OfLight<V> kind, V initial, String unit, Function<Light, V> get,
            BiFunction<Light, V, Light> with, Section section, Map<LightType, LightTerm> terms) {
        super(name, title, kind, initial, unit, get, with);
        this.kind = kind;
        this.section = section;
        this.terms = terms;
        DECLARED.add(this);
    }

    private static <V> LightAttribute<V> of(String name, ValueKind.OfLight<V> kind, V initial, String unit, Function<Light, V> get,
            BiFunction<Light, V, Light> with, Section section, Map<LightType, LightTerm> terms) {
        return new LightAttribute<>(name, name, kind, initial, unit, get, with, section, terms);
    }

    private static Map<LightType, LightTerm> all(LightTerm term) {
        return Map.of(DIRECTIONAL, term, POINT, term, SPOT, term, RECT, term, DISC, term);
    }

    @Override
    public ValueKind.OfLight<V> kind() {
        return kind;
    }

    public Section section() {
        return section;
    }

    /** What it changes of a light of this type; empty where it does not act, and for those that decide about others. */
    public Optional<LightTerm> term(LightType type) {
        return Optional.ofNullable(terms.get(type));
    }

    /** What it changes of this light; samples change nothing of one that is a point. */
    public Optional<LightTerm> term(Light light) {
        return this == SAMPLES && !light.isArea() ? Optional.empty() : term(light.type());
    }

    /** Whether it acts on the picture of a light of this type. The value is kept all the same (paper §4.5). */
    public boolean acts(LightType type) {
        return terms.isEmpty() || terms.containsKey(type);
    }

    /** Why it does nothing for a light of this type: a clause; empty where it acts. */
    public Optional<String> obstacle(LightType type) {
        return acts(type) ? Optional.empty() : Optional.of(Texts.of("a {0} light has no {1}", TYPE.kind().text(type), Texts.of(title())));
    }

    /** Whether a light takes it over from another whose settings it is given: all but where it is and whether it shines. */
    public boolean isSetting() {
        return switch (section) {
            case KIND, COLOUR, CONE, AREA, ATTENUATION -> true;
            case PLACE, SWITCHES, LINKS -> false;
        };
    }
}
