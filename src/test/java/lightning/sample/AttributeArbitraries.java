package lightning.sample;

import java.util.List;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Arbitrary changes of single attributes, for every attribute in the tables. */
public final class AttributeArbitraries {
    /** Values up to this limit are uniform; attributes have visible effects if numbers are as large as the scene. */
    private static final double ORDINARY_LIMIT = 8;

    private AttributeArbitraries() {}

    /**
     * Record before and after a change of one attribute.
     *
     * @param after possibly equal to before
     */
    public record Changed<T>(SceneAttribute<T, ?> attribute, T before, T after) {}

    /** Returns lights above the studio's floor, with the name of its light. */
    public static Arbitrary<Changed<Light>> lights() {
        return Combinators.combine(LightArbitraries.lights(), attributes()).flatAs((seed, attribute) -> changed(attribute,
                seed.instantiate(StudioScene.of(seed.attributes().type()), StudioScene.KEY)));
    }

    /** Returns materials of a name. */
    public static Arbitrary<Changed<Material>> materials(String name) {
        return Combinators.combine(MaterialArbitraries.materials(name), Arbitraries.of(MaterialAttribute.ALL))
                .flatAs((material, attribute) -> changed(attribute, material));
    }

    /** Returns edits of any attribute of a light. */
    static Arbitrary<LightChange> lightChanges() {
        return attributes().flatMap(AttributeArbitraries::lightChange);
    }

    private static <V> Arbitrary<LightChange> lightChange(LightAttribute<V> attribute) {
        return values(attribute, attribute.initial()).map(v -> new LightChange.SetAttribute<>(attribute, v));
    }

    private static Arbitrary<LightAttribute<?>> attributes() {
        return Arbitraries.of(LightAttribute.ALL);
    }

    private static <T, V> Arbitrary<Changed<T>> changed(SceneAttribute<T, V> attribute, T before) {
        return values(attribute, attribute.get(before)).map(v -> new Changed<>(attribute, before, attribute.with(before, v)));
    }

    /** Returns values of an attribute, sometimes its current or initial value. */
    private static <V> Arbitrary<V> values(SceneAttribute<?, V> attribute, V before) {
        Arbitrary<V> current = Arbitraries.of(List.of(before, attribute.initial()));
        return switch (attribute.kind()) {
            case NumericKind<V> q -> Arbitraries.frequencyOf(Tuple.of(6, numbers(q)), Tuple.of(1, current));
            case ChoiceKind<V> c -> Arbitraries.of(c.values());
            // Names of the studio's shapes and others; links to missing names have no effect.
            case ValueKind.LinksKind _ -> LightArbitraries.links().map(AttributeArbitraries::valueOf);
            case ValueKind.GainsKind _ -> LightArbitraries.gains().map(AttributeArbitraries::valueOf);
            case ValueKind.NameKind _ -> attribute == MaterialAttribute.BULB ? valueOf(MaterialArbitraries.bulbLights())
                    : attribute == LightAttribute.SHAPE ? valueOf(LightArbitraries.shapes()) : current;
            case ValueKind.AssetKind<?> _,ValueKind.TextureKind _ -> current;
        };
    }

    @SuppressWarnings("unchecked")
    private static <V> Arbitrary<V> valueOf(Arbitrary<String> names) {
        return (Arbitrary<V>) names;
    }

    @SuppressWarnings("unchecked")
    private static <V> V valueOf(Object links) {
        return (V) links;
    }

    /** Returns edits of any attribute of a light to any valid value. */
    static Arbitrary<LightChange> extremeLightChanges() {
        return attributes().flatMap(AttributeArbitraries::extremeLightChange);
    }

    private static <V> Arbitrary<LightChange> extremeLightChange(LightAttribute<V> attribute) {
        return extremes(attribute).map(v -> new LightChange.SetAttribute<>(attribute, v));
    }

    /** Returns edits of any attribute of a material to any valid value. */
    static Arbitrary<MaterialChange> extremeMaterialChanges() {
        return Arbitraries.of(MaterialAttribute.ALL).flatMap(AttributeArbitraries::extremeMaterialChange);
    }

    private static <V> Arbitrary<MaterialChange> extremeMaterialChange(MaterialAttribute<V> attribute) {
        return extremes(attribute).map(v -> new MaterialChange.SetAttribute<>(attribute, v));
    }

    /** Returns numbers of all magnitudes, with each power of ten equally likely; other kinds as usual. */
    private static <V> Arbitrary<V> extremes(SceneAttribute<?, V> attribute) {
        return switch (attribute.kind()) {
            case NumericKind<V> q -> combine(q, magnitudes(q));
            case ChoiceKind<V> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.AssetKind<
                    ?> _,ValueKind.NameKind _,ValueKind.TextureKind _ ->
                    values(attribute,
                            attribute.initial());
        };
    }

    /** Returns whether numbers that are each in range form a valid value, for example a direction. */
    private static <V> boolean isAllowed(NumericKind<V> q, V value) {
        try {
            q.check("", value);
            return true;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    private static Arbitrary<Double> magnitudes(NumericKind<?> q) {
        double max = Math.max(-q.min(), q.max());
        Arbitrary<Double> any =
                Combinators.combine(NumberArbitraries.powers(NumberArbitraries.MIN_EXPONENT, Math.log10(max)), Arbitraries.of(-1, 1))
                        .as((size, sign) -> sign * size);
        Arbitrary<Double> nearTheEnds = NumberArbitraries.powers(NumberArbitraries.MIN_EXPONENT, 0)
                .flatMap(off -> Arbitraries.of(q.min() + off, q.max() - off));
        return Arbitraries.frequencyOf(Tuple.of(4, any), Tuple.of(1, nearTheEnds), Tuple.of(2, Arbitraries.of(q.min(), q.max(), 0.0, 1.0)))
                .map(v -> Math.clamp(v, q.min(), q.max()));
    }

    static <V> Arbitrary<V> numbers(NumericKind<V> q) {
        Arbitrary<Double> ordinary = q.min() > ORDINARY_LIMIT ? NumberArbitraries.range(q.min(), q.max())
                : NumberArbitraries.range(Math.max(q.min(), -ORDINARY_LIMIT), Math.min(q.max(), ORDINARY_LIMIT));
        Arbitrary<Double> number = q.isVector() ? ordinary
                : Arbitraries.frequencyOf(Tuple.of(6, ordinary), Tuple.of(1, Arbitraries.of(q.min())));
        return combine(q, number);
    }

    private static <V> Arbitrary<V> combine(NumericKind<V> q, Arbitrary<Double> number) {
        return number.map(v -> q.integer() ? Math.rint(v) : v).list().ofSize(q.labels().size())
                .map(n -> q.compose().apply(n)).filter(v -> isAllowed(q, v));
    }
}
