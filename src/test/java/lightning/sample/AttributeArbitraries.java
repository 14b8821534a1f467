package lightning.sample;

import java.util.List;
import lightning.scene.Attribute;
import lightning.scene.Choice;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Links;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Quantity;
import lightning.scene.ValueKind;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/** Records with one attribute set anew, for each that the tables hold: nothing here names any. */
public final class AttributeArbitraries {
    /** Values up to here are drawn evenly; what an attribute does shows best where numbers are as large as the scene. */
    private static final double ORDINARY = 8;

    private AttributeArbitraries() {}

    /**
     * A record before and after one of its attributes was set.
     *
     * @param after perhaps the same as before
     */
    public record Changed<T>(Attribute<T, ?> attribute, T before, T after) {}

    /** Lights that stand over the studio's floor and have the name of its light. */
    public static Arbitrary<Changed<Light>> lights() {
        return Combinators.combine(LightArbitraries.lights(), attributes()).flatAs((seed, attribute) -> changed(attribute,
                seed.in(StudioScene.of(seed.attributes().type()), StudioScene.KEY)));
    }

    /** Materials of a name. */
    public static Arbitrary<Changed<Material>> materials(String name) {
        return Combinators.combine(MaterialArbitraries.materials(name), Arbitraries.of(MaterialAttribute.ALL))
                .flatAs((material, attribute) -> changed(attribute, material));
    }

    /** Edits that set any attribute of a light. */
    static Arbitrary<LightChange> lightChanges() {
        return attributes().flatMap(AttributeArbitraries::lightChange);
    }

    private static <V> Arbitrary<LightChange> lightChange(LightAttribute<V> attribute) {
        return values(attribute, attribute.initial()).map(v -> new LightChange.Anew<>(attribute, v));
    }

    private static Arbitrary<LightAttribute<?>> attributes() {
        return Arbitraries.of(LightAttribute.ALL);
    }

    private static <T, V> Arbitrary<Changed<T>> changed(Attribute<T, V> attribute, T before) {
        return values(attribute, attribute.of(before)).map(v -> new Changed<>(attribute, before, attribute.with(before, v)));
    }

    /** Values of an attribute, sometimes the one that it has already, or is without being said. */
    private static <V> Arbitrary<V> values(Attribute<?, V> attribute, V before) {
        Arbitrary<V> known = Arbitraries.of(List.of(before, attribute.initial()));
        return switch (attribute.kind()) {
            case Quantity<V> q -> Arbitraries.frequencyOf(Tuple.of(6, numbers(q)), Tuple.of(1, known));
            case Choice<V> c -> Arbitraries.of(c.all());
            // Names of the studio's shapes and of others': what a scene lacks is linked to nothing.
            case ValueKind.Linking _ -> LightArbitraries.links().map(AttributeArbitraries::cast);
            case ValueKind.Filed<?> _,ValueKind.Naming _,ValueKind.Texturing _ -> known;
        };
    }

    @SuppressWarnings("unchecked")
    private static <V> V cast(Links links) {
        return (V) links;
    }

    /** Edits that set any attribute of a light to anything that it may be. */
    static Arbitrary<LightChange> extremeLightChanges() {
        return attributes().flatMap(AttributeArbitraries::extremeLightChange);
    }

    private static <V> Arbitrary<LightChange> extremeLightChange(LightAttribute<V> attribute) {
        return extremes(attribute).map(v -> new LightChange.Anew<>(attribute, v));
    }

    /** Edits that set any attribute of a material to anything that it may be. */
    static Arbitrary<MaterialChange> extremeMaterialChanges() {
        return Arbitraries.of(MaterialAttribute.ALL).flatMap(AttributeArbitraries::extremeMaterialChange);
    }

    private static <V> Arbitrary<MaterialChange> extremeMaterialChange(MaterialAttribute<V> attribute) {
        return extremes(attribute).map(v -> new MaterialChange.Anew<>(attribute, v));
    }

    /** Numbers of all magnitudes, each power of ten as likely as any other; what has none as always. */
    private static <V> Arbitrary<V> extremes(Attribute<?, V> attribute) {
        return switch (attribute.kind()) {
            case Quantity<V> q -> joined(q, magnitudes(q));
            case Choice<V> _,ValueKind.Linking _,ValueKind.Filed<?> _,ValueKind.Naming _,ValueKind.Texturing _ -> values(attribute,
                    attribute.initial());
        };
    }

    /** Whether numbers that are each in range may stand together, as those of a direction. */
    private static <V> boolean isAllowed(Quantity<V> q, V value) {
        try {
            q.check("", value);
            return true;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    private static Arbitrary<Double> magnitudes(Quantity<?> q) {
        double most = Math.max(-q.min(), q.max());
        Arbitrary<Double> any = Combinators.combine(Numbers.powers(Numbers.NOTHING, Math.log10(most)), Arbitraries.of(-1, 1))
                .as((size, sign) -> sign * size);
        Arbitrary<Double> nearTheEnds = Numbers.powers(Numbers.NOTHING, 0)
                .flatMap(off -> Arbitraries.of(q.min() + off, q.max() - off));
        return Arbitraries.frequencyOf(Tuple.of(4, any), Tuple.of(1, nearTheEnds), Tuple.of(2, Arbitraries.of(q.min(), q.max(), 0.0, 1.0)))
                .map(v -> Math.clamp(v, q.min(), q.max()));
    }

    static <V> Arbitrary<V> numbers(Quantity<V> q) {
        Arbitrary<Double> ordinary = Numbers.between(Math.max(q.min(), -ORDINARY), Math.min(q.max(), ORDINARY));
        Arbitrary<Double> number = q.isVector() ? ordinary
                : Arbitraries.frequencyOf(Tuple.of(6, ordinary), Tuple.of(1, Arbitraries.of(q.min())));
        return joined(q, number);
    }

    private static <V> Arbitrary<V> joined(Quantity<V> q, Arbitrary<Double> number) {
        return number.map(v -> q.whole() ? Math.rint(v) : v).list().ofSize(q.labels().size())
                .map(n -> q.join().apply(n)).filter(v -> isAllowed(q, v));
    }
}
