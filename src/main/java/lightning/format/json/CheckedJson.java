package lightning.format.json;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Reader of values that come from others. Each method throws an {@link IOException} if the value is missing or out of its range; its message
 * is a sentence for the user with the source, the place and what is expected.
 *
 * @param source name of the file or the sender
 */
public record CheckedJson(String source) {
    private static final int MAX_ENTRIES = 10_000;

    /**
     * Parses a text.
     *
     * @param expected what it should be, such as {@code a review}
     * @throws IOException if it is no JSON; the message names line and column
     */
    public JsonNode parse(byte[] bytes, String expected) throws IOException {
        try {
            return new JsonMapper().readTree(bytes);
        } catch (JacksonException e) {
            var at = e.getLocation();
            throw new IOException(
                    source + (at == null ? "" : ":" + at.getLineNr() + ":" + at.getColumnNr()) + ": expected " + expected + ": "
                            + e.getOriginalMessage(),
                    e);
        }
    }

    /** Returns an exception with the source before the message. */
    public IOException failure(String message) {
        return new IOException(source + ": " + message);
    }

    /** Returns an array of at most 10 000 entries. */
    public JsonNode array(JsonNode node, String field) throws IOException {
        return array(node, "", field);
    }

    /**
     * Returns an array of at most 10 000 entries.
     *
     * @param at place of {@code node}, with a point at its end
     */
    public JsonNode array(JsonNode node, String at, String field) throws IOException {
        JsonNode value = node.path(field);
        if (!value.isArray() || value.size() > MAX_ENTRIES) {
            throw failure(at + field + ": expected an array of at most " + MAX_ENTRIES + " entries");
        }
        return value;
    }

    /** Returns three numbers of a range. */
    public List<Double> numbers(JsonNode node, String at, String field, double min, double max) throws IOException {
        JsonNode value = node.path(field);
        List<Double> numbers = new ArrayList<>();
        for (JsonNode channel : value) {
            numbers.add(channel.isNumber() ? channel.asDouble() : Double.NaN);
        }
        if (!value.isArray() || numbers.size() != 3 || !numbers.stream().allMatch(v -> v >= min && v <= max)) {
            throw failure(at + field + ": expected three numbers from " + min + " to " + max);
        }
        return List.copyOf(numbers);
    }

    /** Returns a number of a range, both ends included. */
    public double number(JsonNode node, String at, String field, double min, double max) throws IOException {
        JsonNode value = node.path(field);
        double number = value.isNumber() ? value.asDouble() : Double.NaN;
        if (!(number >= min && number <= max)) {
            throw failure(at + field + ": expected a number from " + min + " to " + max);
        }
        return number;
    }

    /** Returns a text of at most {@code maxLength} characters. */
    public String text(JsonNode node, String at, String field, int maxLength) throws IOException {
        JsonNode value = node.path(field);
        if (!value.isString() || value.asString().length() > maxLength) {
            throw failure(at + field + ": expected a text of at most " + maxLength + " characters");
        }
        return value.asString();
    }

    /** Returns true or false. */
    public boolean flag(JsonNode node, String at, String field) throws IOException {
        if (!node.path(field).isBoolean()) {
            throw failure(at + field + ": expected true or false");
        }
        return node.get(field).asBoolean();
    }
}
