package lightning.format.jen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import lightning.base.text.Quote;
import lightning.scene.Attribute;
import lightning.scene.Choice;
import lightning.scene.FromFile;
import lightning.scene.Limits;
import lightning.scene.Links;
import lightning.scene.Quantity;
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
 * @param whole   whether the numbers must be whole
 * @param extra   what the values must be together; throws an IllegalArgumentException that says it
 * @param get     reads the value from the scene
 */
record Property<T>(String name, Form form, List<String> labels, double min, double max, List<String> choices,
        Value initial, String unit, boolean whole, Consumer<Value> extra, Function<T, Value> get) {

    enum Form {
        NUMBERS,
        WORD,
        NAME,
        QUOTED,
        LINKS
    }

    /** How a file writes attributes, in their order. */
    static <T> List<Property<T>> of(List<? extends Attribute<T, ?>> attributes) {
        return attributes.stream().flatMap(a -> of(a).stream()).toList();
    }

    /** How a file writes an attribute: a picture as its file and how often it repeats, all others as one property. */
    static <T, V> List<Property<T>> of(Attribute<T, V> a) {
        return switch (a.kind()) {
            case Quantity<V> n -> List.of(new Property<>(a.name(), Form.NUMBERS,
                    n.labels().stream().map(l -> l.isEmpty() ? l : " " + l).toList(), n.min(), n.max(), List.of(),
                    new Value.Numbers(n.split().apply(a.initial())), a.unit(), n.whole(),
                    v -> n.check(a.name(), n.join().apply(((Value.Numbers) v).all())),
                    t -> new Value.Numbers(n.split().apply(a.of(t)))));
            case Choice<V> c -> List.of(choice(a.name(), new Value.Word(c.text(a.initial())), c.words(),
                    t -> new Value.Word(c.text(a.of(t)))));
            case ValueKind.Linking _ -> List.of(new Property<>(a.name(), Form.LINKS, List.of(), 0, 0,
                    List.of(Value.ALL, Value.NONE, Value.ONLY, Value.EXCEPT), new Value.Linked((Links) a.initial()), a.unit(), false,
                    v -> {},
                    t -> new Value.Linked((Links) a.of(t))));
            case ValueKind.Naming _ -> List.of(name(a.name(), new Value.Absent(), a.unit(), t -> named((String) a.of(t))));
            case ValueKind.Filed<?> _ -> List.of(filed(a, a.unit(), t -> ((Optional<?>) a.of(t))
                    .<Value>map(held -> new Value.Quoted(((FromFile) held).file())).orElse(new Value.Absent())));
            case ValueKind.Texturing k -> List.of(
                    filed(a, "a PNG or JPEG file", t -> picture(a.of(t), map -> new Value.Quoted(map.file()))),
                    Property.<T>numbers(k.repeat(), List.of(" u", " v"), Value.of(1, 1), -Limits.MAX_REPEAT, Limits.MAX_REPEAT,
                            "times, needs a " + a.name(), t -> picture(a.of(t), map -> Value.of(map.repeatU(), map.repeatV())))
                            .also(v -> new TextureMap("", ((Value.Numbers) v).all().get(0), ((Value.Numbers) v).all().get(1), null)));
        };
    }

    private static Value named(String name) {
        return name.isEmpty() ? new Value.Absent() : new Value.Name(name);
    }

    private static <T> Property<T> filed(Attribute<T, ?> a, String unit, Function<T, Value> get) {
        return quoted(a.name(), unit, v -> FileName.check(a.name(), ((Value.Quoted) v).file(), TextureFolder.NAME), get);
    }

    private static Value picture(Object map, Function<TextureMap, Value> get) {
        return ((Optional<?>) map).map(m -> get.apply((TextureMap) m)).orElse(new Value.Absent());
    }

    static <T> Property<T> number(String name, double initial, double min, double max, String unit,
            Function<T, Double> get) {
        return numbers(name, List.of(""), Value.of(initial), min, max, unit, t -> Value.of(get.apply(t)));
    }

    static <T> Property<T> numbers(String name, List<String> labels, Value initial, double min, double max,
            String unit, Function<T, Value> get) {
        return new Property<>(name, Form.NUMBERS, labels, min, max, List.of(), initial, unit, false, v -> {}, get);
    }

    static <T> Property<T> choice(String name, Value initial, List<String> choices, Function<T, Value> get) {
        return new Property<>(name, Form.WORD, List.of(), 0, 0, choices, initial, "", false, v -> {}, get);
    }

    /** The name of something. */
    static <T> Property<T> name(String name, Value initial, String unit, Function<T, Value> get) {
        return new Property<>(name, Form.NAME, List.of(), 0, 0, List.of(), initial, unit, false, v -> {}, get);
    }

    static <T> Property<T> quoted(String name, String unit, Consumer<Value> extra, Function<T, Value> get) {
        return new Property<>(name, Form.QUOTED, List.of(), 0, 0, List.of(), new Value.Absent(), unit, false, extra, get);
    }

    /** The same of what has such a record in it. */
    <S> Property<S> of(Function<S, T> record) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, whole, extra, record.andThen(get));
    }

    /** The same where only some records have it. */
    Property<T> where(Predicate<T> has) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, whole, extra,
                t -> has.test(t) ? get.apply(t) : new Value.Absent());
    }

    Property<T> inWholeNumbers() {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, true, extra, get);
    }

    Property<T> also(Consumer<Value> check) {
        return new Property<>(name, form, labels, min, max, choices, initial, unit, whole, check, get);
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
        boolean broken = whole && v != Math.rint(v);
        if (v >= min && v <= max && !broken) {
            return;
        }
        String what = name + labels.get(index);
        if (broken) {
            throw new IllegalArgumentException(what + " must be a whole number, was " + Limits.text(v));
        }
        Limits.range(what, v, min, max);
    }

    /** @throws IllegalArgumentException if {@code word} is none of the choices */
    void checkWord(String word) {
        if (!choices.contains(word)) {
            throw new IllegalArgumentException(name + " must be " + alternatives() + ", was " + Quote.of(word)
                    + Nearest.hint(word, choices));
        }
    }

    /** @throws IllegalArgumentException if the value, each number of which is right, is not right as a whole */
    void checkTogether(Value value) {
        extra.accept(value);
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
