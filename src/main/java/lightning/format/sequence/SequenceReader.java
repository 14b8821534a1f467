package lightning.format.sequence;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.Set;
import java.util.regex.Pattern;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.format.json.CheckedJson;
import lightning.scene.shot.Shot;
import tools.jackson.databind.JsonNode;

/** Reader of sequence files. */
public final class SequenceReader {
    private static final int MAX_BYTES = 16 << 20;
    private static final int MAX_TEXT = 10_000;
    /** Names that every file system can have as a part of a file name. */
    private static final Pattern NAME = Pattern.compile("[^/\\\\:*?\"<>|\\p{Cntrl}. ][^/\\\\:*?\"<>|\\p{Cntrl}]{0,99}");
    private static final Set<String> ROOT_KEYS = Set.of(Sequence.KEY, "rig", "world", "shots", "notes");
    private static final Set<String> SHOT_KEYS = Set.of("name", "scene", "frames", "set", "note");

    private final CheckedJson json;

    private SequenceReader(String name) {
        json = new CheckedJson(name);
    }

    /** Returns whether a file has the extension of sequences. */
    public static boolean isSequence(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(Sequence.EXTENSION);
    }

    /**
     * Reads a sequence; the scenes that it names are not read.
     *
     * @throws IOException if it cannot be read, or is no sequence; the message is a sentence for the user with file and place
     */
    public static Sequence read(Path file) throws IOException {
        var reader = new SequenceReader(Quote.path(file));
        byte[] bytes = RegularFile.readBytes(file, "a sequence", MAX_BYTES);
        return reader.sequence(reader.json.parse(bytes, "a sequence"));
    }

    private Sequence sequence(JsonNode root) throws IOException {
        JsonNode version = root.path(Sequence.KEY);
        if (!version.isInt() || version.asInt() != Sequence.VERSION) {
            throw json.failure("expected \"" + Sequence.KEY + "\": " + Sequence.VERSION);
        }
        checkKeys(root, "", ROOT_KEYS);
        List<Sequence.Entry> shots = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (JsonNode node : json.array(root, "shots")) {
            Sequence.Entry shot = shot(node, "shots[" + shots.size() + "].");
            // File systems may not tell upper case from lower case.
            if (!names.add(shot.name().toLowerCase(Locale.ROOT))) {
                throw json.failure("shots[" + shots.size() + "].name: another shot has the name " + Quote.of(shot.name()));
            }
            shots.add(shot);
        }
        if (shots.isEmpty()) {
            throw json.failure("shots: expected at least one shot");
        }
        SequencedMap<String, String> notes = new LinkedHashMap<>();
        for (Map.Entry<String, JsonNode> note : root.path("notes").properties()) {
            notes.put(note.getKey(), json.text(root.path("notes"), "notes.", note.getKey(), MAX_TEXT));
        }
        return new Sequence(json.text(root, "", "rig", MAX_TEXT), root.has("world") && json.flag(root, "", "world"), List.copyOf(shots),
                notes);
    }

    private Sequence.Entry shot(JsonNode node, String at) throws IOException {
        if (!node.isObject()) {
            throw json.failure(at.substring(0, at.length() - 1) + ": expected an object with name and scene");
        }
        checkKeys(node, at, SHOT_KEYS);
        String name = json.text(node, at, "name", MAX_TEXT);
        if (!NAME.matcher(name).matches() || name.endsWith(" ")) {
            throw json.failure(at + "name: expected a part of a file name with at most 100 characters, found " + Quote.of(name));
        }
        List<String> edits = new ArrayList<>();
        if (node.has("set")) {
            for (JsonNode edit : json.array(node, at, "set")) {
                if (!edit.isString()) {
                    throw json.failure(at + "set[" + edits.size() + "]: expected an edit such as \"key.intensity=2\"");
                }
                edits.add(edit.asString());
            }
        }
        return new Sequence.Entry(name, json.text(node, at, "scene", MAX_TEXT), span(node, at), List.copyOf(edits),
                node.has("note") ? json.text(node, at, "note", MAX_TEXT) : "");
    }

    private Optional<Sequence.Span> span(JsonNode node, String at) throws IOException {
        if (!node.has("frames")) {
            return Optional.empty();
        }
        JsonNode frames = node.get("frames");
        boolean isRange = frames.isArray() && frames.size() == 2 && frames.get(0).isInt() && frames.get(1).isInt()
                && 0 <= frames.get(0).asInt() && frames.get(0).asInt() <= frames.get(1).asInt() && frames.get(1).asInt() <= Shot.MAX_FRAME;
        if (!isRange) {
            throw json.failure(at + "frames: expected the first and the last frame, such as [1, 48]");
        }
        return Optional.of(new Sequence.Span(frames.get(0).asInt(), frames.get(1).asInt()));
    }

    /** Refuses keys that would be lost when the sequence is written. */
    private void checkKeys(JsonNode node, String at, Set<String> known) throws IOException {
        for (Map.Entry<String, JsonNode> property : node.properties()) {
            if (!known.contains(property.getKey())) {
                throw json.failure(
                        at + property.getKey() + ": unknown key, expected one of " + String.join(", ", known.stream().sorted().toList()));
            }
        }
    }
}
