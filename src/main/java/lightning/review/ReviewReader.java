package lightning.review;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.format.json.CheckedJson;
import lightning.scene.Contribution;
import lightning.scene.SceneElement;
import lightning.scene.shot.Shot;
import tools.jackson.databind.JsonNode;

/** Reader for files that pages save. Others may have changed them, so every value is checked. */
public final class ReviewReader {
    private static final int MAX_BYTES = 4 << 20;
    private static final double MAX_STOPS = 64;

    private final CheckedJson json;

    private ReviewReader(String name) {
        json = new CheckedJson(name);
    }

    /**
     * Reads a review.
     *
     * @throws IOException if it cannot be read, or is no review; the message is a sentence for the user with file and place
     */
    public static Review read(Path file) throws IOException {
        var reader = new ReviewReader(Quote.path(file));
        byte[] bytes = RegularFile.readBytes(file, "a review", MAX_BYTES);
        return reader.review(reader.json.parse(bytes, "a review of 'lightning review'"));
    }

    private Review review(JsonNode root) throws IOException {
        JsonNode version = root.path("lightning_review");
        if (!version.isInt()) {
            throw json.failure("expected a review that a page of 'lightning review' saved");
        }
        if (version.asInt() < 1 || version.asInt() > ReviewPage.VERSION) {
            throw json.failure("lightning_review: expected version 1 or " + ReviewPage.VERSION + ", found " + version.asInt());
        }
        boolean areTogether = version.asInt() == 1;
        List<Review.LightChange> lights = new ArrayList<>();
        for (JsonNode node : json.array(root, "lights")) {
            String at = "lights[" + lights.size() + "].";
            List<Double> color = node.has("color") && !node.get("color").isNull() ? json.numbers(node, at, "color", 0, 1e6) : List.of();
            lights.add(
                    new Review.LightChange(light(node, at, areTogether), areTogether, stops(node, at),
                            json.numbers(node, at, "tint", 0, 1e6),
                            json.number(node, at, "intensity", 0, 1e30), color, json.flag(node, at, "mute"), json.flag(node, at, "solo")));
        }
        List<Review.GroupChange> groups = new ArrayList<>();
        for (JsonNode node : json.array(root, "groups")) {
            String at = "groups[" + groups.size() + "].";
            groups.add(
                    new Review.GroupChange(json.text(node, at, "name", 1000), stops(node, at), json.flag(node, at, "mute"),
                            json.flag(node, at, "solo")));
        }
        List<Review.Note> notes = new ArrayList<>();
        for (JsonNode node : json.array(root, "notes")) {
            String at = "notes[" + notes.size() + "].";
            notes.add(new Review.Note(frame(node, at), json.number(node, at, "x", 0, 1), json.number(node, at, "y", 0, 1),
                    json.text(node, at, "text", 10_000)));
        }
        return new Review(json.text(root, "", "scene", 10_000), json.text(root, "", "reviewer", 1000),
                json.number(root, "", "exposure", -MAX_STOPS, MAX_STOPS),
                lights, groups, notes);
    }

    private Contribution light(JsonNode node, String at, boolean areTogether) throws IOException {
        String name = json.text(node, at, "name", 1000);
        if (!node.has("environment") || areTogether && !json.flag(node, at, "environment")) {
            return new SceneElement.OfLight(name);
        }
        return switch (areTogether ? "world" : json.text(node, at, "environment", 1000)) {
            case "world" -> Contribution.ENVIRONMENT;
            case "dome" -> new SceneElement.OfDome(name);
            default -> throw json.failure(at + "environment: expected \"world\" or \"dome\", found " + node.get("environment"));
        };
    }

    private OptionalInt frame(JsonNode node, String at) throws IOException {
        if (!node.has("frame")) {
            return OptionalInt.empty();
        }
        double frame = json.number(node, at, "frame", 0, Shot.MAX_FRAME);
        if (frame != Math.rint(frame)) {
            throw json.failure(at + "frame: expected a whole number, found " + frame);
        }
        return OptionalInt.of((int) frame);
    }

    private Optional<Double> stops(JsonNode node, String at) throws IOException {
        return node.has("stops") && node.get("stops").isNull() ? Optional.empty()
                : Optional.of(json.number(node, at, "stops", -MAX_STOPS, MAX_STOPS));
    }
}
