package lightning.document;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;

/**
 * One number of an attribute of a light, the world or the picture, as a field of the property editor edits it.
 *
 * @param element element for the name of a light
 * @param index index among the numbers of the attribute
 */
public record AttributeNumber<T, V>(Function<String, SceneElement<T>> element, SceneAttribute<T, V> attribute, NumericKind<V> kind,
        int index) {
    /** Ambient light. */
    public static final AttributeNumber<?, ?> AMBIENCE = ofWorld(World.AMBIENCE).findFirst().orElseThrow();
    /** Reflection bounces. */
    public static final AttributeNumber<?, ?> DEPTH = of(_ -> SceneElement.PICTURE, PictureSettings.DEPTH).findFirst().orElseThrow();
    /** All numbers that are not set together with others, those of lights first. */
    public static final List<AttributeNumber<?, ?>> ALL =
            Stream.<Stream<AttributeNumber<?, ?>>>of(LightAttribute.ALL.stream().flatMap(AttributeNumber::ofLight),
                    World.ATTRIBUTES.stream().flatMap(AttributeNumber::ofWorld), Stream.of(DEPTH)).flatMap(all -> all).toList();

    /** Returns the numbers of an attribute of a light; none if they are set together, as in a position. */
    public static <V> Stream<AttributeNumber<?, ?>> ofLight(LightAttribute<V> attribute) {
        return of(SceneElement.OfLight::new, attribute);
    }

    private static <V> Stream<AttributeNumber<?, ?>> ofWorld(SceneAttribute<World, V> attribute) {
        return of(_ -> SceneElement.WORLD, attribute);
    }

    private static <T, V> Stream<AttributeNumber<?, ?>> of(Function<String, SceneElement<T>> element, SceneAttribute<T, V> attribute) {
        return attribute.kind() instanceof NumericKind<V> kind && !kind.isVector()
                ? IntStream.range(0, kind.labels().size()).mapToObj(i -> new AttributeNumber<>(element, attribute, kind, i))
                : Stream.empty();
    }

    /** Returns the name of the number among those of the attribute; empty for a single one. */
    public String part() {
        return kind.labels().get(index);
    }

    /** Returns the title: {@code attenuation linear}; of a color, that of the channel. */
    public String title() {
        return part().isEmpty() ? attribute.title()
                : kind.form() == NumericKind.Form.COLOR ? part() : attribute.title() + " " + part();
    }

    public StepRange range() {
        return StepRange.of(kind);
    }

    public boolean isOfLight() {
        return attribute instanceof LightAttribute;
    }

    /** @param light name of the light; ignored for other elements */
    public double value(Scene scene, String light) {
        return kind.number(attribute.get(element.apply(light).get(scene)), index);
    }

    /** Sets the value; refused if it is out of range, or not an integer if required. */
    public EditOutcome set(Scene scene, String light, double value) {
        return EditOutcome.edit(scene, element.apply(light), record -> {
            kind.check(title(), value);
            return attribute.with(record, kind.with(attribute.get(record), index, value));
        });
    }

    /** Returns why the number has no effect; empty if it has, or if the element is missing. */
    public Optional<String> inactiveReason(Scene scene, String light) {
        return element.apply(light).find(scene).flatMap(attribute::inactiveReason);
    }

    @Override
    public String toString() {
        return title();
    }
}
