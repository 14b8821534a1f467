package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.FileKind;
import lightning.format.jen.asset.FileName;
import lightning.format.jen.asset.NameSuggestion;
import lightning.format.jen.asset.TextureFolder;
import lightning.scene.asset.FileAsset;
import lightning.scene.asset.TextureMap;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/**
 * Property of a block type: its syntax, allowed values, default, and accessor in the scene.
 *
 * @param <T> scene record with the property
 * @param name name in the file
 * @param form syntax after the name
 * @param labels name of each number ("" if the property's own name suffices)
 * @param min minimum of each number
 * @param max maximum of each number
 * @param choices allowed words
 * @param initial default
 * @param unit unit for the documentation
 * @param isInteger true if the numbers must be integers
 * @param valueCheck checks the value as a whole; throws an IllegalArgumentException with the cause
 * @param getter reads the value from the scene
 */
record Property<T>(String name, Form form, List<String> labels, double min, double max, List<String> choices,
        Value initial, String unit, boolean isInteger, Consumer<Value> valueCheck, Function<T, Value> getter) {

    enum Form {
        NUMBERS,
        WORD,
        NAME,
        QUOTED,
        LINKS,
        GAINS,
        BLOCK
    }

    /** Returns the properties that represent attributes, in order. */
    static <T> List<Property<T>> of(List<? extends SceneAttribute<T, ?>> attributes) {
        return attributes.stream().flatMap(a -> of(a).stream()).toList();
    }

    /** Returns the properties of an attribute: a file, its placement and a wrap for an image, one property for all others. */
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
            case ValueKind.GainsKind _ -> List.of(new Property<>(a.name(), Form.GAINS, List.of(""), 0, SceneLimits.MAX_GAIN, List.of(),
                    new Value.Absent(), a.unit(), false, v -> {}, t -> gainsValue((ShapeGains) a.get(t))));
            case ValueKind.NameKind _ -> List.of(name(a.name(), new Value.Absent(), a.unit(), t -> nameValue((String) a.get(t))));
            case ValueKind.AssetKind<?> _ -> List.of(fileProperty(a, a.unit(), t -> ((Optional<?>) a.get(t))
                    .<Value>map(held -> new Value.Quoted(((FileAsset) held).file())).orElse(new Value.Absent())));
            case ValueKind.TextureKind k -> Stream.concat(
                    Stream.of(fileProperty(a, FileKind.TEXTURE.description(), t -> texture(a, t)
                            .<Value>map(map -> new Value.Quoted(map.file())).orElse(new Value.Absent()))),
                    k.placement(a).stream().flatMap(p -> of(p).stream().map(placed -> placed.presentIf(t -> texture(a, t).isPresent()))))
                    .toList();
        };
    }

    private static Value gainsValue(ShapeGains gains) {
        return gains.isNone() ? new Value.Absent() : new Value.Gains(gains);
    }

    private static Value nameValue(String name) {
        return name.isEmpty() ? new Value.Absent() : new Value.Name(name);
    }

    private static <T> Property<T> fileProperty(SceneAttribute<T, ?> a, String unit, Function<T, Value> getter) {
        return quoted(a.name(), unit, v -> FileName.check(a.name(), ((Value.Quoted) v).file(), TextureFolder.NAME), getter);
    }

    private static <T> Optional<TextureMap> texture(SceneAttribute<T, ?> a, T record) {
        return ((Optional<?>) a.get(record)).map(TextureMap.class::cast);
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

    /** Creates a property whose value is a name. */
    static <T> Property<T> name(String name, Value initial, String unit, Function<T, Value> getter) {
        return new Property<>(name, Form.NAME, List.of(), 0, 0, List.of(), initial, unit, false, v -> {}, getter);
    }

    static <T> Property<T> quoted(String name, String unit, Consumer<Value> valueCheck, Function<T, Value> getter) {
        return new Property<>(name, Form.QUOTED, List.of(), 0, 0, List.of(), new Value.Absent(), unit, false, valueCheck, getter);
    }

    /** Creates an optional property whose value is a block without a name, with the block's keyword as its name. */
    static <T, B> Property<T> block(BlockType<B> type, String unit, Function<T, Optional<B>> getter) {
        return new Property<>(type.keyword(), Form.BLOCK, List.of(), 0, 0, List.of(), new Value.Absent(), unit, false, v -> {},
                t -> getter.apply(t).<Value>map(b -> new Value.Nested(BlockContent.of(type, b))).orElse(new Value.Absent()));
    }

    /** Returns this property for a record that contains {@code T}. */
    <S> Property<S> adapt(Function<S, T> adapter) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, isInteger, valueCheck, adapter.andThen(getter));
    }

    /** Returns this property, present only if a condition holds. */
    Property<T> presentIf(Predicate<T> condition) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, isInteger, valueCheck,
                t -> condition.test(t) ? getter.apply(t) : new Value.Absent());
    }

    Property<T> asIntegers() {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, true, valueCheck, getter);
    }

    /** Returns the count of numbers after the name; 1 for words. */
    int count() {
        return form == Form.NUMBERS ? labels.size() : 1;
    }

    /**
     * Checks a number.
     *
     * @throws RefusalException if {@code v} is not allowed at {@code index}; the message contains expected and found
     *     value
     */
    void checkNumber(int index, double v) {
        boolean isFractional = isInteger && v != Math.rint(v);
        if (v >= min && v <= max && !isFractional) {
            return;
        }
        String label = name + labels.get(index);
        if (isFractional) {
            throw new RefusalException(label + " must be a whole number, was " + SceneLimits.format(v));
        }
        SceneLimits.checkRange(label, v, min, max);
    }

    /**
     * Checks a word.
     *
     * @throws RefusalException if {@code word} is not one of the choices
     */
    void checkWord(String word) {
        if (!choices.contains(word)) {
            throw new RefusalException(name + " must be " + alternatives() + ", was " + Quote.of(word)
                    + NameSuggestion.hint(word, choices));
        }
    }

    /**
     * Checks a value whose single numbers are valid.
     *
     * @throws RefusalException if it is invalid as a whole
     */
    void checkValue(Value value) {
        valueCheck.accept(value);
    }

    /** Returns the expected value, for messages. */
    String expected() {
        return switch (form) {
            case NUMBERS -> count() == 1 ? "a number" : count() + " numbers";
            case WORD, LINKS -> alternatives();
            case NAME -> "a name";
            case GAINS -> "names of shapes or groups in quotes, each with a number";
            case QUOTED -> "a file name in quotes";
            case BLOCK -> "'{'";
        };
    }

    private String alternatives() {
        var words = new ArrayList<>(choices);
        String last = words.removeLast();
        return words.isEmpty() ? last : String.join(", ", words) + " or " + last;
    }
}
