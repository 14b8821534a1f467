package lightning.format.sequence;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import java.util.function.UnaryOperator;
import lightning.base.file.AtomicFile;
import lightning.base.file.FileState;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Shots that share one light rig.
 *
 * @param rig        scene file with the lights and light groups of all shots, relative to the sequence's folder
 * @param sharesWorld true if the world of the rig's file, with environment and fog, replaces those of the shots
 * @param shots      at least one, with different names
 * @param lightNotes notes about lights, by their names
 */
public record Sequence(String rig, boolean sharesWorld, List<Entry> shots, SequencedMap<String, String> lightNotes) {
    /** Version of the files. */
    static final int VERSION = 1;
    /** Key of the version, by which files are recognized. */
    static final String KEY = "lightning_sequence";
    /** Extension of the files. */
    public static final String EXTENSION = ".json";

    /**
     * Shot of a sequence.
     *
     * @param name      part of file names
     * @param scene     scene file, relative to the sequence's folder
     * @param frames    frames of the scene's shot; empty for all
     * @param overrides edits in words that apply to this shot only, such as {@code key.intensity=2}
     * @param note      free text, may be empty
     */
    public record Entry(String name, String scene, Optional<Span> frames, List<String> overrides, String note) {
        public Entry withOverrides(List<String> v) {
            return new Entry(name, scene, frames, List.copyOf(v), note);
        }

        public Entry withNote(String v) {
            return new Entry(name, scene, frames, overrides, v);
        }
    }

    /**
     * Consecutive frames.
     *
     * @param last from {@code first} on
     */
    public record Span(int first, int last) {}

    /** Returns the shot of a name. */
    public Optional<Entry> shot(String name) {
        return shots.stream().filter(entry -> entry.name().equals(name)).findFirst();
    }

    /** Returns this sequence with the shot of a name changed. */
    public Sequence with(String name, UnaryOperator<Entry> change) {
        return new Sequence(rig, sharesWorld, shots.stream().map(entry -> entry.name().equals(name) ? change.apply(entry) : entry).toList(),
                lightNotes);
    }

    /** Returns this sequence with the note of a light; an empty note is removed. */
    public Sequence withLightNote(String light, String note) {
        SequencedMap<String, String> notes = new LinkedHashMap<>(lightNotes);
        if (note.isBlank()) {
            notes.remove(light);
        } else {
            notes.put(light, note);
        }
        return new Sequence(rig, sharesWorld, shots, notes);
    }

    /**
     * Writes it to a file, and returns the file's state.
     *
     * @throws IOException as {@link AtomicFile#write(byte[])}
     */
    public FileState write(AtomicFile file) throws IOException {
        JsonMapper json = new JsonMapper();
        ObjectNode root = json.createObjectNode().put(KEY, VERSION).put("rig", rig).put("world", sharesWorld);
        ArrayNode list = root.putArray("shots");
        for (Entry shot : shots) {
            ObjectNode node = list.addObject().put("name", shot.name()).put("scene", shot.scene());
            shot.frames().ifPresent(span -> node.putArray("frames").add(span.first()).add(span.last()));
            if (!shot.overrides().isEmpty()) {
                ArrayNode edits = node.putArray("set");
                shot.overrides().forEach(edits::add);
            }
            if (!shot.note().isEmpty()) {
                node.put("note", shot.note());
            }
        }
        if (!lightNotes.isEmpty()) {
            ObjectNode notes = root.putObject("notes");
            lightNotes.forEach(notes::put);
        }
        return file.write((json.writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n").getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the names of all shots. */
    public List<String> names() {
        return shots.stream().map(Entry::name).toList();
    }
}
