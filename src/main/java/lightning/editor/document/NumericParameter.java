package lightning.editor.document;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.NumericKind;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SceneAttribute;
import lightning.scene.World;

/**
 * One number that an arrow widget or a slider of the property editor turns (paper §3.2, Figure 5): of the selected
 * light, or of the whole scene.
 */
public final class NumericParameter {
    /** Of the scene. */
    public static final NumericParameter AMBIENCE = ofWorld(World.AMBIENCE);
    /** Of the scene: a factor of what comes from its environment. */
    public static final NumericParameter ENVIRONMENT_INTENSITY = ofWorld(World.INTENSITY);
    /** Of the scene: how far its environment is turned. */
    public static final NumericParameter ENVIRONMENT_ROTATION = ofWorld(World.ROTATION);
    /** Of the scene: how many lamps its environment's light is made of, whole. */
    public static final NumericParameter ENVIRONMENT_LAMPS = ofWorld(World.LIGHT_COUNT);
    /** Of the scene: how far each of these is spread over the part of the environment that it stands for. */
    public static final NumericParameter ENVIRONMENT_SOFTNESS = ofWorld(World.SOFTNESS);
    /** Of the scene: mirror bounces, whole. */
    public static final NumericParameter DEPTH = ofScene(PictureSettings.DEPTH, Scene::picture, Scene::withPicture, _ -> Optional.empty());

    /** All, those of lights first. */
    public static final List<NumericParameter> ALL =
            Stream.concat(LightAttribute.ALL.stream().flatMap(a -> of(a).stream()), Stream.of(AMBIENCE, ENVIRONMENT_INTENSITY,
                    ENVIRONMENT_ROTATION, ENVIRONMENT_LAMPS, ENVIRONMENT_SOFTNESS, DEPTH)).toList();

    private final String title;
    private final String label;
    private final NumericKind<?> quantity;
    private final boolean isOfScene;
    private final BiFunction<Scene, Optional<Light>, Optional<String>> disabledReason;
    private final Getter getter;
    private final Setter setter;

    private interface Getter {
        double get(Scene scene, String light);
    }

    private interface Setter {
        Scene set(Scene scene, String light, double value);
    }

    private interface PartGetter<T> {
        T get(Scene scene);
    }

    private interface PartSetter<T> {
        Scene set(Scene scene, T part);
    }

    private NumericParameter(String title, String label, NumericKind<?> quantity, boolean isOfScene,
            BiFunction<Scene, Optional<Light>, Optional<String>> disabledReason, Getter getter, Setter setter) {
        this.title = title;
        this.label = label;
        this.quantity = quantity;
        this.isOfScene = isOfScene;
        this.disabledReason = disabledReason;
        this.getter = getter;
        this.setter = setter;
    }

    /** A dial for each number of an attribute; none where it has no numbers, or where they are set together as a place is. */
    public static <V> List<NumericParameter> of(LightAttribute<V> attribute) {
        return attribute.kind() instanceof NumericKind<V> quantity && !quantity.isVector()
                ? IntStream.range(0, quantity.labels().size()).mapToObj(i -> of(attribute, quantity, i)).toList() : List.of();
    }

    private static <V> NumericParameter of(LightAttribute<V> attribute, NumericKind<V> quantity, int index) {
        String label = quantity.labels().get(index);
        // What a channel or an axis is of, people see by the color or the place that it stands beside.
        String title = label.isEmpty() ? attribute.title()
                : quantity.form() == NumericKind.Form.COLOR ? label : attribute.title() + " " + label;
        return new NumericParameter(title, label.isEmpty() ? title : label, quantity, false,
                (_, selected) -> selected.isEmpty() ? Optional.of(Messages.tr("no light is selected"))
                        : attribute.inactiveReason(selected.get().type()),
                (scene, light) -> quantity.number(attribute.get(LightEdits.light(scene, light)), index),
                (scene, light, value) -> {
                    Light before = LightEdits.light(scene, light);
                    return scene.withLight(attribute.with(before, quantity.with(attribute.get(before), index, value)));
                });
    }

    private static NumericParameter ofWorld(SceneAttribute<World, ?> attribute) {
        return ofScene(attribute, Scene::world, Scene::withWorld, scene -> scene.world().inactiveReason(attribute));
    }

    private static <T, V> NumericParameter ofScene(SceneAttribute<T, V> attribute, PartGetter<T> getPart, PartSetter<T> setPart,
            Function<Scene, Optional<String>> disabledReason) {
        if (!(attribute.kind() instanceof NumericKind<V> quantity)) {
            throw new IllegalArgumentException(attribute.title() + " is no number");
        }
        String title = attribute.title();
        return new NumericParameter(title, title.substring(title.lastIndexOf(' ') + 1), quantity, true,
                (scene, _) -> disabledReason.apply(scene),
                (scene, _) -> quantity.number(attribute.get(getPart.get(scene)), 0),
                (scene, _, value) -> setPart.set(scene,
                        attribute.with(getPart.get(scene), quantity.with(attribute.get(getPart.get(scene)), 0, value))));
    }

    /** For people, lower case: {@code attenuation linear}. */
    public String title() {
        return title;
    }

    /** The last word of the title: {@code linear}. */
    public String label() {
        return label;
    }

    /** What one click adds, and the limits. */
    public StepRange range() {
        return new StepRange(quantity.step(), quantity.min(), quantity.max());
    }

    /** What the number is measured in. */
    public NumberUnit measure() {
        return quantity.unit();
    }

    /** Whether it belongs to the scene and needs no light. */
    public boolean isOfScene() {
        return isOfScene;
    }

    /**
     * The value shown.
     *
     * @param light the name of a light of the scene; not looked at where {@link #isOfScene()}
     * @throws IllegalArgumentException if it is needed and there is none of that name
     */
    public double value(Scene scene, String light) {
        return getter.get(scene, light);
    }

    /** Sets the value; refused if it is out of its range, and if it is not whole where it must be. */
    public EditOutcome set(Scene scene, String light, double value) {
        return EditOutcome.of(() -> {
            quantity.check(title, value);
            return setter.set(scene, light, value);
        });
    }

    /**
     * Clicks the widget: adds steps, in decimal so that 1.1 and one step make 1.2, and stops at the limits.
     *
     * @param steps how many, down where negative
     */
    public EditOutcome step(Scene scene, String light, int steps) {
        return EditOutcome.of(() -> set(scene, light, range().addSteps(value(scene, light), steps)).sceneOr(scene));
    }

    /** Why it cannot be turned: a clause; empty if it can. */
    public Optional<String> disabledReason(Scene scene, Optional<Light> selected) {
        return disabledReason.apply(scene, selected);
    }

    @Override
    public String toString() {
        return title;
    }
}
