package lightning.format.review;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reader for files that pages save. Others may have changed them, so every value is checked. */
public final class ReviewReader {
    private static final int MAX_BYTES = 4 << 20;
    private static final int MAX_ENTRIES = 10_000;
    private static final double MAX_STOPS = 64;

    private final String name;

    private ReviewReader(String name) {
        this.name = name;
    }

    /**
     * Reads a review.
     *
     * @throws IOException if it cannot be read, or is no review; the message is a sentence for the user with file and place
     */
    public static Review read(Path file) throws IOException {
        var reader = new ReviewReader(Quote.path(file));
        byte[] bytes = RegularFile.readBytes(file, "a review", MAX_BYTES);
        try {
            return reader.review(new JsonMapper().readTree(bytes));
        } catch (JacksonException e) {
            var at = e.getLocation();
            throw new IOException(reader.name + (at == null ? "" : ":" + at.getLineNr() + ":" + at.getColumnNr())
                    + ": expected a review of 'lightning review': " + e.getOriginalMessage(), e);
        }
    }

    private Review review(JsonNode root) throws IOException {
        JsonNode version = root.path("lightning_review");
        if (!version.isInt()) {
            throw new IOException(name + ": expected a review that a page of 'lightning review' saved");
        }
        if (version.asInt() != ReviewPage.VERSION) {
            throw new IOException(name + ": lightning_review: expected version " + ReviewPage.VERSION + ", found " + version.asInt());
        }
        List<Review.LightChange> lights = new ArrayList<>();
        for (JsonNode node : array(root, "lights")) {
            String at = "lights[" + lights.size() + "].";
            List<Double> color = node.has("color") && !node.get("color").isNull() ? numbers(node, at, "color", 0, 1e6) : List.of();
            lights.add(new Review.LightChange(text(node, at, "name", 1000), stops(node, at), numbers(node, at, "tint", 0, 1e6),
                    number(node, at, "intensity", 0, 1e30), color, flag(node, at, "mute"), flag(node, at, "solo")));
        }
        List<Review.GroupChange> groups = new ArrayList<>();
        for (JsonNode node : array(root, "groups")) {
            String at = "groups[" + groups.size() + "].";
            groups.add(
                    new Review.GroupChange(text(node, at, "name", 1000), stops(node, at), flag(node, at, "mute"), flag(node, at, "solo")));
        }
        List<Review.Note> notes = new ArrayList<>();
        for (JsonNode node : array(root, "notes")) {
            String at = "notes[" + notes.size() + "].";
            notes.add(new Review.Note(number(node, at, "x", 0, 1), number(node, at, "y", 0, 1), text(node, at, "text", 10_000)));
        }
        return new Review(text(root, "", "scene", 10_000), text(root, "", "reviewer", 1000),
                number(root, "", "exposure", -MAX_STOPS, MAX_STOPS),
                lights, groups, notes);
    }

    private JsonNode array(JsonNode node, String field) throws IOException {
        JsonNode value = node.path(field);
        if (!value.isArray() || value.size() > MAX_ENTRIES) {
            throw new IOException(name + ": " + field + ": expected an array of at most " + MAX_ENTRIES + " entries");
        }
        return value;
    }

    private Optional<Double> stops(JsonNode node, String at) throws IOException {
        return node.has("stops") && node.get("stops").isNull() ? Optional.empty()
                : Optional.of(number(node, at, "stops", -MAX_STOPS, MAX_STOPS));
    }

    private List<Double> numbers(JsonNode node, String at, String field, double min, double max) throws IOException {
        JsonNode value = node.path(field);
        List<Double> numbers = new ArrayList<>();
        for (JsonNode channel : value) {
            numbers.add(channel.isNumber() ? channel.asDouble() : Double.NaN);
        }
        if (!value.isArray() || numbers.size() != 3 || !numbers.stream().allMatch(v -> v >= min && v <= max)) {
            throw new IOException(name + ": " + at + field + ": expected three numbers from " + min + " to " + max);
        }
        return List.copyOf(numbers);
    }

    private double number(JsonNode node, String at, String field, double min, double max) throws IOException {
        JsonNode value = node.path(field);
        double number = value.isNumber() ? value.asDouble() : Double.NaN;
        if (!(number >= min && number <= max)) {
            throw new IOException(name + ": " + at + field + ": expected a number from " + min + " to " + max);
        }
        return number;
    }

    private String text(JsonNode node, String at, String field, int maxLength) throws IOException {
        JsonNode value = node.path(field);
        if (!value.isString() || value.asString().length() > maxLength) {
            throw new IOException(name + ": " + at + field + ": expected a text of at most " + maxLength + " characters");
        }
        return value.asString();
    }

    private boolean flag(JsonNode node, String at, String field) throws IOException {
        if (!node.path(field).isBoolean()) {
            throw new IOException(name + ": " + at + field + ": expected true or false");
        }
        return node.get(field).asBoolean();
    }
}
