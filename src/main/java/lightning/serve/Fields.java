package lightning.serve;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.format.jen.asset.NameSuggestion;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** Fields of a request with checked types. Each reader throws a {@link RequestException} with the field as its place. */
record Fields(ObjectNode message) {
    private static final int MAX_SHOWN = 40;

    /** Rejects fields other than these. */
    void requireKnown(Set<String> known) {
        for (String name : message.propertyNames()) {
            if (!known.contains(name)) {
                throw bad(name.length() > MAX_SHOWN ? name.substring(0, MAX_SHOWN) + "…" : name,
                        "unknown field; expected one of " + String.join(", ", new TreeSet<>(known)) + NameSuggestion.hint(name, known));
            }
        }
    }

    boolean has(String name) {
        return message.has(name);
    }

    String string(String name) {
        return optionalString(name).orElseThrow(() -> bad(name, "missing; expected a text"));
    }

    Optional<String> optionalString(String name) {
        return Optional.ofNullable(message.get(name)).map(node -> string(name, node));
    }

    private static String string(String place, JsonNode node) {
        if (!node.isString()) {
            throw bad(place, "expected a text, found " + describe(node));
        }
        return node.stringValue();
    }

    /** Returns the value that a text names in lower case; {@code fallback} without a text. */
    <E extends Enum<E>> E choice(String name, E fallback) {
        return optionalString(name).map(word -> choice(name, word, fallback.getDeclaringClass())).orElse(fallback);
    }

    /** Returns the value of a type that a word names in lower case. */
    static <E extends Enum<E>> E choice(String place, String word, Class<E> type) {
        List<E> choices = List.of(type.getEnumConstants());
        return choices.stream().filter(choice -> choice.name().toLowerCase(Locale.ROOT).equals(word)).findFirst()
                .orElseThrow(() -> bad(place, "expected one of "
                        + choices.stream().map(choice -> choice.name().toLowerCase(Locale.ROOT)).collect(Collectors.joining(", "))
                        + ", found " + Quote.of(word)));
    }

    /** Returns a text, or the texts of an array, at least one. */
    List<String> strings(String name) {
        JsonNode node = required(name, "a text or an array of texts");
        if (!node.isArray()) {
            return List.of(string(name, node));
        }
        List<String> all = new ArrayList<>();
        for (int i = 0; i < node.size(); i++) {
            all.add(string(name + "[" + i + "]", node.get(i)));
        }
        if (all.isEmpty()) {
            throw bad(name, "expected at least one text, found none");
        }
        return all;
    }

    boolean flag(String name) {
        JsonNode node = message.get(name);
        if (node != null && !node.isBoolean()) {
            throw bad(name, "expected true or false, found " + describe(node));
        }
        return node != null && node.booleanValue();
    }

    /** Returns the path that {@code memory} names; empty if it is {@code true} or missing. */
    Optional<Path> memoryPath() {
        JsonNode node = message.get("memory");
        return node != null && node.isBoolean() && node.booleanValue() ? Optional.empty() : optionalString("memory").map(Path::of);
    }

    int integer(String name, int min, int max) {
        return integer(name, required(name, "a whole number"), min, max);
    }

    int integer(String name, int min, int max, int fallback) {
        return has(name) ? integer(name, min, max) : fallback;
    }

    private static int integer(String place, JsonNode node, int min, int max) {
        if (!node.isIntegralNumber() || !node.canConvertToInt() || node.intValue() < min || node.intValue() > max) {
            throw bad(place, "expected a whole number from " + min + " to " + max + ", found " + describe(node));
        }
        return node.intValue();
    }

    /** Returns a number of a range; empty if there is none. */
    OptionalDouble number(String name, double min, double max) {
        JsonNode node = message.get(name);
        if (node == null) {
            return OptionalDouble.empty();
        }
        if (!node.isNumber() || !(node.doubleValue() >= min && node.doubleValue() <= max)) {
            throw bad(name, "expected a number from " + (long) min + " to " + (long) max + ", found " + describe(node));
        }
        return OptionalDouble.of(node.doubleValue());
    }

    /** Returns an array of whole numbers of a given length. */
    int[] integers(String name, int length, int min, int max) {
        JsonNode node = required(name, "an array of " + length + " whole numbers");
        if (!node.isArray() || node.size() != length) {
            throw bad(name, "expected an array of " + length + " whole numbers, found " + describe(node));
        }
        int[] all = new int[length];
        for (int i = 0; i < length; i++) {
            all[i] = integer(name + "[" + i + "]", node.get(i), min, max);
        }
        return all;
    }

    /** Returns the id of a request, a whole number or a short text; for answers it is written as it was sent. */
    JsonNode id(String name) {
        JsonNode node = required(name, "a whole number or a text");
        boolean isNumber = node.isIntegralNumber() && node.canConvertToLong();
        if (!isNumber && !(node.isString() && node.stringValue().length() <= MAX_SHOWN)) {
            throw bad(name, "expected a whole number or a text of at most " + MAX_SHOWN + " characters, found " + describe(node));
        }
        return node;
    }

    private JsonNode required(String name, String expected) {
        JsonNode node = message.get(name);
        if (node == null) {
            throw bad(name, "missing; expected " + expected);
        }
        return node;
    }

    static RequestException bad(String place, String text) {
        return new RequestException(ErrorCode.BAD_REQUEST, place, text);
    }

    private static String describe(JsonNode node) {
        return node.isArray() ? "an array of " + node.size() : node.isObject() ? "an object"
                : node.isString() ? "the text " + Quote.of(node.stringValue()) : Quote.shorten(node.toString());
    }
}
