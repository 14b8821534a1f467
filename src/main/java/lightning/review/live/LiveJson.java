package lightning.review.live;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.format.json.CheckedJson;
import lightning.review.Review;
import lightning.review.ReviewPage;
import lightning.scene.value.SceneLimits;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Values of lights as JSON, in both directions. What pages send is checked, since anyone with the address can send something else. */
final class LiveJson {
    private static final double MAX_STOPS = 64;
    private static final int MAX_NAME = 1000;
    private static final int MAX_TEXT = 10_000;
    private static final int MAX_NOTES = 200;
    private static final int MAX_TEXTS = 100_000;
    private static final CheckedJson CHECKED = new CheckedJson("change");

    private LiveJson() {}

    static ObjectNode write(LiveState state) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        ArrayNode lights = node.putArray("lights");
        for (LiveState.LightValue light : state.lights()) {
            ObjectNode to = lights.addObject().put("name", light.name()).put("intensity", light.intensity()).put("mute", light.mute())
                    .put("solo", light.solo());
            ReviewPage.put(to, "color", light.color());
        }
        ArrayNode groups = node.putArray("groups");
        for (LiveState.GroupValue group : state.groups()) {
            groups.addObject().put("name", group.name()).put("intensity", group.intensity()).put("mute", group.mute())
                    .put("solo", group.solo());
        }
        state.exposure().ifPresent(stops -> node.put("exposure", stops));
        return node;
    }

    /**
     * Reads what a page sends.
     *
     * @throws IOException if it is no change; the message is one sentence with the place
     */
    static LiveChange read(byte[] bytes) throws IOException {
        JsonNode root = CHECKED.parse(bytes, "JSON");
        List<LiveState.LightValue> lights = new ArrayList<>();
        for (JsonNode node : CHECKED.array(root, "lights")) {
            String at = "lights[" + lights.size() + "].";
            List<Double> color = CHECKED.numbers(node, at, "color", 0, 1);
            lights.add(new LiveState.LightValue(CHECKED.text(node, at, "name", MAX_NAME),
                    CHECKED.number(node, at, "intensity", 0, SceneLimits.MAX_INTENSITY),
                    new Rgb(color.get(0), color.get(1), color.get(2)), CHECKED.flag(node, at, "mute"), CHECKED.flag(node, at, "solo")));
        }
        List<LiveState.GroupValue> groups = new ArrayList<>();
        for (JsonNode node : CHECKED.array(root, "groups")) {
            String at = "groups[" + groups.size() + "].";
            groups.add(new LiveState.GroupValue(CHECKED.text(node, at, "name", MAX_NAME),
                    CHECKED.number(node, at, "intensity", 0, SceneLimits.MAX_INTENSITY), CHECKED.flag(node, at, "mute"),
                    CHECKED.flag(node, at, "solo")));
        }
        List<Review.Note> notes = new ArrayList<>();
        for (JsonNode node : CHECKED.array(root, "notes")) {
            String at = "notes[" + notes.size() + "].";
            notes.add(new Review.Note(CHECKED.number(node, at, "x", 0, 1), CHECKED.number(node, at, "y", 0, 1),
                    CHECKED.text(node, at, "text", MAX_TEXT)));
        }
        int characters = notes.stream().mapToInt(note -> note.text().length()).sum();
        if (notes.size() > MAX_NOTES || characters > MAX_TEXTS) {
            throw CHECKED.failure("notes: expected at most " + MAX_NOTES + " notes with " + MAX_TEXTS + " characters in all, found "
                    + notes.size() + " with " + characters);
        }
        Optional<Double> exposure =
                root.has("exposure") ? Optional.of(CHECKED.number(root, "", "exposure", -MAX_STOPS, MAX_STOPS)) : Optional.empty();
        return new LiveChange(CHECKED.text(root, "", "page", MAX_NAME), CHECKED.text(root, "", "reviewer", MAX_NAME),
                new LiveState(lights, groups, exposure), notes);
    }
}
