package lightning.editor.document;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.scene.FogAttributes;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SkyAttributes;
import lightning.scene.World;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;

/** Numeric parameter of the property editor's arrow widgets and sliders (paper §3.2, Figure 5), of the selected light or of the scene. */
public final class NumericParameter {
    /** Beginnings of titles that the section says. */
    private static final List<String> PREFIXES = List.of("environment ", "fog ");
    /** Ambient light of the scene. */
    public static final NumericParameter AMBIENCE = ofWorld(World.AMBIENCE);
    /** Numbers of the world's own environment. */
    public static final List<NumericParameter> ENVIRONMENT =
            Stream.of(World.INTENSITY, World.GAIN, World.ROTATION, World.TILT, World.ROLL, World.LIGHT_COUNT, World.SOFTNESS)
                    .<NumericParameter>map(NumericParameter::ofWorld).toList();
    /** Meters per scene unit, for photometric units. */
    public static final NumericParameter METERS = ofWorld(World.METERS);
    /** Sun and air of a physical sky. */
    public static final List<NumericParameter> SKY = List.of(ofWorld(SkyAttributes.ELEVATION), ofWorld(SkyAttributes.AZIMUTH),
            ofWorld(SkyAttributes.TURBIDITY), ofWorld(SkyAttributes.SUN), ofWorld(SkyAttributes.SUN_RADIUS));
    /** Extinction of fog. */
    public static final NumericParameter FOG_DENSITY = ofWorld(FogAttributes.DENSITY);
    /** Fog where there is any: its scattering, and how it ends upward. */
    public static final List<NumericParameter> FOG =
            List.of(ofWorld(FogAttributes.ANISOTROPY), ofWorld(FogAttributes.HEIGHT), ofWorld(FogAttributes.FALLOFF));
    /** Center of the box that contains the fog: x, y, z. */
    public static final List<NumericParameter> FOG_CENTER = vectorOfWorld(FogAttributes.CENTER);
    /** Lengths of this box: x, y, z; all 0 without a box. */
    public static final List<NumericParameter> FOG_SIZE = vectorOfWorld(FogAttributes.SIZE);
    /** Reflection bounces, an integer. */
    public static final NumericParameter DEPTH =
            ofScene(PictureSettings.DEPTH, 0, Scene::picture, Scene::withPicture, _ -> Optional.empty());

    /** All parameters, those of lights first. */
    public static final List<NumericParameter> ALL =
            Stream.of(LightAttribute.ALL.stream().flatMap(a -> of(a).stream()), Stream.of(AMBIENCE), ENVIRONMENT.stream(),
                    Stream.of(METERS, DEPTH, FOG_DENSITY), SKY.stream(), FOG.stream(), FOG_CENTER.stream()).flatMap(all -> all).toList();

    private final String id;
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

    private NumericParameter(String id, String title, String label, NumericKind<?> quantity, boolean isOfScene,
            BiFunction<Scene, Optional<Light>, Optional<String>> disabledReason, Getter getter, Setter setter) {
        this.id = id;
        this.title = title;
        this.label = label;
        this.quantity = quantity;
        this.isOfScene = isOfScene;
        this.disabledReason = disabledReason;
        this.getter = getter;
        this.setter = setter;
    }

    /**
     * Returns a parameter for each number of an attribute; none for other attributes, or if the numbers are set together, as in a position.
     */
    public static <V> List<NumericParameter> of(LightAttribute<V> attribute) {
        return attribute.kind() instanceof NumericKind<V> quantity && !quantity.isVector()
                ? IntStream.range(0, quantity.labels().size()).mapToObj(i -> of(attribute, quantity, i)).toList() : List.of();
    }

    private static <V> NumericParameter of(LightAttribute<V> attribute, NumericKind<V> quantity, int index) {
        String label = quantity.labels().get(index);
        // A color next to the field shows which channel it is.
        String title = label.isEmpty() ? attribute.title()
                : quantity.form() == NumericKind.Form.COLOR ? label : attribute.title() + " " + label;
        // A section that has the attribute's name says the rest.
        String shownLabel = attribute.title().equals(attribute.section().title()) && !label.isEmpty() ? label : title;
        return new NumericParameter(label.isEmpty() ? attribute.id() : label, title, shownLabel, quantity, false,
                (_, selected) -> selected.isEmpty() ? Optional.of(Messages.tr("no light is selected"))
                        : attribute.inactiveReason(selected.get()),
                (scene, light) -> quantity.number(attribute.get(LightEdits.light(scene, light)), index),
                (scene, light, value) -> {
                    Light before = LightEdits.light(scene, light);
                    return scene.withLight(attribute.with(before, quantity.with(attribute.get(before), index, value)));
                });
    }

    private static NumericParameter ofWorld(SceneAttribute<World, ?> attribute) {
        return ofScene(attribute, 0, Scene::world, Scene::withWorld, scene -> scene.world().inactiveReason(attribute));
    }

    private static List<NumericParameter> vectorOfWorld(SceneAttribute<World, Vec3> attribute) {
        return IntStream.range(0, 3).mapToObj(
                i -> ofScene(attribute, i, Scene::world, Scene::withWorld, scene -> scene.world().inactiveReason(attribute))).toList();
    }

    private static <T, V> NumericParameter ofScene(SceneAttribute<T, V> attribute, int index, PartGetter<T> getPart, PartSetter<T> setPart,
            Function<Scene, Optional<String>> disabledReason) {
        if (!(attribute.kind() instanceof NumericKind<V> quantity)) {
            throw new IllegalArgumentException(attribute.title() + " is no number");
        }
        String part = quantity.labels().get(index);
        String title = part.isEmpty() ? attribute.title() : attribute.title() + " " + part;
        String label =
                PREFIXES.stream().filter(title::startsWith).findFirst().map(prefix -> title.substring(prefix.length())).orElse(title);
        return new NumericParameter((part.isEmpty() ? attribute.id() : attribute.id() + " " + part).replace(' ', '-'), title, label,
                quantity,
                true,
                (scene, _) -> disabledReason.apply(scene),
                (scene, _) -> quantity.number(attribute.get(getPart.get(scene)), index),
                (scene, _, value) -> setPart.set(scene,
                        attribute.with(getPart.get(scene), quantity.with(attribute.get(getPart.get(scene)), index, value))));
    }

    /** Returns the stable id of the parameter's control: {@code linear}. */
    public String id() {
        return id;
    }

    /** Returns the title for people in lower case: {@code attenuation linear}. */
    public String title() {
        return title;
    }

    /** Returns the label next to the control, the title without the section's name: {@code linear}. */
    public String label() {
        return label;
    }

    /** Returns the step of one click and the limits. */
    public StepRange range() {
        return new StepRange(quantity.step(), quantity.min(), quantity.max());
    }

    /** Returns the unit of the number. */
    public NumberUnit measure() {
        return quantity.unit();
    }

    /** Returns whether the parameter belongs to the scene and needs no light. */
    public boolean isOfScene() {
        return isOfScene;
    }

    /**
     * Returns the displayed value.
     *
     * @param light name of a light of the scene; ignored if {@link #isOfScene()}
     * @throws IllegalArgumentException if the light is needed and does not exist
     */
    public double value(Scene scene, String light) {
        return getter.get(scene, light);
    }

    /** Sets the value; refused if it is out of range, or not an integer if required. */
    public EditOutcome set(Scene scene, String light, double value) {
        return EditOutcome.of(() -> {
            quantity.check(title, value);
            return setter.set(scene, light, value);
        });
    }

    /**
     * Adds steps in decimal arithmetic, so that 1.1 and one step make 1.2, clamped to the limits.
     *
     * @param steps number of steps, negative for down
     */
    public EditOutcome step(Scene scene, String light, int steps) {
        return EditOutcome.of(() -> set(scene, light, range().addSteps(value(scene, light), steps)).sceneOr(scene));
    }

    /** Returns the reason why the parameter is disabled, a clause; empty if it is enabled. */
    public Optional<String> disabledReason(Scene scene, Optional<Light> selected) {
        return disabledReason.apply(scene, selected);
    }

    @Override
    public String toString() {
        return title;
    }
}
