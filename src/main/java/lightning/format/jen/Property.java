package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import lightning.base.text.Quote;
import lightning.scene.ChoiceKind;
import lightning.scene.FileAsset;
import lightning.scene.NumericKind;
import lightning.scene.SceneAttribute;
import lightning.scene.SceneLimits;
import lightning.scene.ShapeLinks;
import lightning.scene.TextureMap;
import lightning.scene.ValueKind;

/**
 * One property of one kind of block: how it is written, which values it may have, what it is
 * without being written, and where the scene keeps it.
 *
 * @param <T>     the record of the scene that has the property
 * @param name    as the file writes it
 * @param form    what follows the name
 * @param labels  the names of the numbers, one for each ("" where the property's own name says it)
 * @param min     the least value of each number
 * @param max     the largest value of each number
 * @param choices the allowed words
 * @param initial the value where the file does not say
 * @param unit    for the documentation
 * @param isInteger   whether the numbers must be whole
 * @param valueCheck   what the values must be together; throws an IllegalArgumentException that says it
 * @param getter     reads the value from the scene
 */
record Property<T>(String name, Form form, List<String> labels, double min, double max, List<String> choices,
        Value initial, String unit, boolean isInteger, Consumer<Value> valueCheck, Function<T, Value> getter) {

    enum Form {
        NUMBERS,
        WORD,
        NAME,
        QUOTED,
        LINKS
    }

    /** How a file writes attributes, in their order. */
    static <T> List<Property<T>> of(List<? extends SceneAttribute<T, ?>> attributes) {
        return attributes.stream().flatMap(a -> of(a).stream()).toList();
    }

    /** How a file writes an attribute: a picture as its file and how often it repeats, all others as one property. */
    static <T, V> List<Property<T>> of(SceneAttribute<T, V> a) {
        return switch (a.kind()) {
            case NumericKind<V> n -> List.of(new Property<>(a.name(), Form.NUMBERS,
                    n.labels().stream().map(l -> l.isEmpty() ? l : " " + l).toList(), n.min(), n.max(), List.of(),
                    new Value.Numbers(n.components().apply(a.initial())), a.unit(), n.integer(),
                    v -> n.check(a.name(), n.compose().apply(((Value.Numbers) v).values())),
                    t -> new Value.Numbers(n.components().apply(a.get(t)))));
            case ChoiceKind<V> c -> List.of(choice(a.name(), new Value.Word(c.format(a.initial())), c.words(),
                    t -> new Value.Word(c.format(a.get(t)))));
            case ValueKind.LinksKind _ -> List.of(new Property<>(a.name(), Form.LINKS, List.of(), 0, 0,
                    List.of(Value.ALL, Value.NONE, Value.ONLY, Value.EXCEPT), new Value.LinkSet((ShapeLinks) a.initial()), a.unit(), false,
                    v -> {},
                    t -> new Value.LinkSet((ShapeLinks) a.get(t))));
            case ValueKind.NameKind _ -> List.of(name(a.name(), new Value.Absent(), a.unit(), t -> nameValue((String) a.get(t))));
            case ValueKind.AssetKind<?> _ -> List.of(fileProperty(a, a.unit(), t -> ((Optional<?>) a.get(t))
                    .<Value>map(held -> new Value.Quoted(((FileAsset) held).file())).orElse(new Value.Absent())));
            case ValueKind.TextureKind k -> List.of(
                    fileProperty(a, "a PNG or JPEG file", t -> textureValue(a.get(t), map -> new Value.Quoted(map.file()))),
                    Property.<T>numbers(k.repeatName(), List.of(" u", " v"), Value.of(1, 1), -SceneLimits.MAX_REPEAT,
                            SceneLimits.MAX_REPEAT,
                            "times, needs a " + a.name(), t -> textureValue(a.get(t), map -> Value.of(map.repeatU(), map.repeatV())))
                            .withCheck(v -> new TextureMap("", ((Value.Numbers) v).values().get(0), ((Value.Numbers) v).values().get(1),
                                    null)));
        };
    }

    private static Value nameValue(String name) {
        return name.isEmpty() ? new Value.Absent() : new Value.Name(name);
    }

    private static <T> Property<T> fileProperty(SceneAttribute<T, ?> a, String unit, Function<T, Value> getter) {
        return quoted(a.name(), unit, v -> FileName.check(a.name(), ((Value.Quoted) v).file(), TextureFolder.NAME), getter);
    }

    private static Value textureValue(Object map, Function<TextureMap, Value> getter) {
        return ((Optional<?>) map).map(m -> getter.apply((TextureMap) m)).orElse(new Value.Absent());
    }

    static <T> Property<T> number(String name, double initial, double min, double max, String unit,
            Function<T, Double> getter) {
        return numbers(name, List.of(""), Value.of(initial), min, max, unit, t -> Value.of(getter.apply(t)));
    }

    static <T> Property<T> numbers(String name, List<String> labels, Value initial, double min, double max,
            String unit, Function<T, Value> getter) {
        return new Property<>(name, Form.NUMBERS, labels, min, max, List.of(), initial, unit, false, v -> {}, getter);
    }

    static <T> Property<T> choice(String name, Value initial, List<String> choices, Function<T, Value> getter) {
        return new Property<>(name, Form.WORD, List.of(), 0, 0, choices, initial, "", false, v -> {}, getter);
    }

    /** The name of something. */
    static <T> Property<T> name(String name, Value initial, String unit, Function<T, Value> getter) {
        return new Property<>(name, Form.NAME, List.of(), 0, 0, List.of(), initial, unit, false, v -> {}, getter);
    }

    static <T> Property<T> quoted(String name, String unit, Consumer<Value> valueCheck, Function<T, Value> getter) {
        return new Property<>(name, Form.QUOTED, List.of(), 0, 0, List.of(), new Value.Absent(), unit, false, valueCheck, getter);
    }

    /** The same of what has such a record in it. */
    <S> Property<S> adapt(Function<S, T> adapter) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, isInteger, valueCheck, adapter.andThen(getter));
    }

    /** The same where only some records have it. */
    Property<T> presentIf(Predicate<T> condition) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, isInteger, valueCheck,
                t -> condition.test(t) ? getter.apply(t) : new Value.Absent());
    }

    Property<T> asIntegers() {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, true, valueCheck, getter);
    }

    Property<T> withCheck(Consumer<Value> check) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, isInteger, check, getter);
    }

    /** How many numbers follow the name; 1 for words. */
    int count() {
        return form == Form.NUMBERS ? labels.size() : 1;
    }

    /**
     * @throws IllegalArgumentException if {@code v} may not be the number at {@code index}; the
     *     message says what was expected and found
     */
    void checkNumber(int index, double v) {
        boolean isFractional = isInteger && v != Math.rint(v);
        if (v >= min && v <= max && !isFractional) {
            return;
        }
        String label = name + labels.get(index);
        if (isFractional) {
            throw new IllegalArgumentException(label + " must be a whole number, was " + SceneLimits.format(v));
        }
        SceneLimits.checkRange(label, v, min, max);
    }

    /** @throws IllegalArgumentException if {@code word} is none of the choices */
    void checkWord(String word) {
        if (!choices.contains(word)) {
            throw new IllegalArgumentException(name + " must be " + alternatives() + ", was " + Quote.of(word)
                    + NameSuggestion.hint(word, choices));
        }
    }

    /** @throws IllegalArgumentException if the value, each number of which is right, is not right as a whole */
    void checkValue(Value value) {
        valueCheck.accept(value);
    }

    /** What was expected, as a message says it. */
    String expected() {
        return switch (form) {
            case NUMBERS -> count() == 1 ? "a number" : count() + " numbers";
            case WORD, LINKS -> alternatives();
            case NAME -> "a name";
            case QUOTED -> "a file name in quotes";
        };
    }

    private String alternatives() {
        var words = new ArrayList<>(choices);
        String last = words.removeLast();
        return words.isEmpty() ? last : String.join(", ", words) + " or " + last;
    }
}
