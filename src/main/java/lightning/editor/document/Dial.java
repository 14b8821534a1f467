package lightning.editor.document;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.text.Measure;
import lightning.base.text.Texts;
import lightning.scene.Attribute;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Picture;
import lightning.scene.Quantity;
import lightning.scene.Scene;
import lightning.scene.World;

/**
 * One number that an arrow widget or a slider of the property editor turns (paper §3.2, Figure 5): of the selected
 * light, or of the whole scene.
 */
public final class Dial {
    /** Of the scene. */
    public static final Dial AMBIENCE = ofWorld(World.AMBIENCE);
    /** Of the scene: a factor of what comes from its environment. */
    public static final Dial ENVIRONMENT_INTENSITY = ofWorld(World.INTENSITY);
    /** Of the scene: how far its environment is turned. */
    public static final Dial ENVIRONMENT_ROTATION = ofWorld(World.ROTATION);
    /** Of the scene: how many lamps its environment's light is made of, whole. */
    public static final Dial ENVIRONMENT_LAMPS = ofWorld(World.LAMPS);
    /** Of the scene: how far each of these is spread over the part of the environment that it stands for. */
    public static final Dial ENVIRONMENT_SOFTNESS = ofWorld(World.SOFTNESS);
    /** Of the scene: mirror bounces, whole. */
    public static final Dial DEPTH = ofScene(Picture.DEPTH, Scene::picture, Scene::withPicture, _ -> Optional.empty());

    /** All, those of lights first. */
    public static final List<Dial> ALL =
            Stream.concat(LightAttribute.ALL.stream().flatMap(a -> of(a).stream()), Stream.of(AMBIENCE, ENVIRONMENT_INTENSITY,
                    ENVIRONMENT_ROTATION, ENVIRONMENT_LAMPS, ENVIRONMENT_SOFTNESS, DEPTH)).toList();

    private final String title;
    private final String label;
    private final Quantity<?> quantity;
    private final boolean ofScene;
    private final BiFunction<Scene, Optional<Light>, Optional<String>> obstacle;
    private final Get get;
    private final Set set;

    private interface Get {
        double from(Scene scene, String light);
    }

    private interface Set {
        Scene on(Scene scene, String light, double value);
    }

    private interface Part<T> {
        T of(Scene scene);
    }

    private interface WithPart<T> {
        Scene on(Scene scene, T part);
    }

    private Dial(String title, String label, Quantity<?> quantity, boolean ofScene,
            BiFunction<Scene, Optional<Light>, Optional<String>> obstacle, Get get, Set set) {
        this.title = title;
        this.label = label;
        this.quantity = quantity;
        this.ofScene = ofScene;
        this.obstacle = obstacle;
        this.get = get;
        this.set = set;
    }

    /** A dial for each number of an attribute; none where it has no numbers, or where they are set together as a place is. */
    public static <V> List<Dial> of(LightAttribute<V> attribute) {
        return attribute.kind() instanceof Quantity<V> quantity && !quantity.isVector()
                ? IntStream.range(0, quantity.labels().size()).mapToObj(i -> of(attribute, quantity, i)).toList() : List.of();
    }

    private static <V> Dial of(LightAttribute<V> attribute, Quantity<V> quantity, int index) {
        String label = quantity.labels().get(index);
        // What a channel or an axis is of, people see by the colour or the place that it stands beside.
        String title = label.isEmpty() ? attribute.title()
                : quantity.form() == Quantity.Form.COLOR ? label : attribute.title() + " " + label;
        return new Dial(title, label.isEmpty() ? title : label, quantity, false,
                (_, selected) -> selected.isEmpty() ? Optional.of(Texts.of("no light is selected"))
                        : attribute.obstacle(selected.get().type()),
                (scene, light) -> quantity.number(attribute.of(LightEdits.light(scene, light)), index),
                (scene, light, value) -> {
                    Light before = LightEdits.light(scene, light);
                    return scene.withLight(attribute.with(before, quantity.with(attribute.of(before), index, value)));
                });
    }

    private static Dial ofWorld(Attribute<World, ?> attribute) {
        return ofScene(attribute, Scene::world, Scene::withWorld, scene -> scene.world().obstacle(attribute));
    }

    private static <T, V> Dial ofScene(Attribute<T, V> attribute, Part<T> part, WithPart<T> with,
            Function<Scene, Optional<String>> obstacle) {
        if (!(attribute.kind() instanceof Quantity<V> quantity)) {
            throw new IllegalArgumentException(attribute.title() + " is no number");
        }
        String title = attribute.title();
        return new Dial(title, title.substring(title.lastIndexOf(' ') + 1), quantity, true,
                (scene, _) -> obstacle.apply(scene),
                (scene, _) -> quantity.number(attribute.of(part.of(scene)), 0),
                (scene, _, value) -> with.on(scene,
                        attribute.with(part.of(scene), quantity.with(attribute.of(part.of(scene)), 0, value))));
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
    public Steps steps() {
        return new Steps(quantity.step(), quantity.min(), quantity.max());
    }

    /** What the number is measured in. */
    public Measure measure() {
        return quantity.measure();
    }

    /** Whether it belongs to the scene and needs no light. */
    public boolean isOfScene() {
        return ofScene;
    }

    /**
     * The value shown.
     *
     * @param light the name of a light of the scene; not looked at where {@link #isOfScene()}
     * @throws IllegalArgumentException if it is needed and there is none of that name
     */
    public double value(Scene scene, String light) {
        return get.from(scene, light);
    }

    /** Sets the value; refused if it is out of its range, and if it is not whole where it must be. */
    public Change set(Scene scene, String light, double value) {
        return Change.of(() -> {
            quantity.check(title, value);
            return set.on(scene, light, value);
        });
    }

    /**
     * Clicks the widget: adds steps, in decimal so that 1.1 and one step make 1.2, and stops at the limits.
     *
     * @param steps how many, down where negative
     */
    public Change stepped(Scene scene, String light, int steps) {
        return Change.of(() -> set(scene, light, steps().from(value(scene, light), steps)).or(scene));
    }

    /** Why it cannot be turned: a clause; empty if it can. */
    public Optional<String> obstacle(Scene scene, Optional<Light> selected) {
        return obstacle.apply(scene, selected);
    }

    @Override
    public String toString() {
        return title;
    }
}
