package lightning.serve;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.stream.Stream;
import lightning.base.file.AtomicFile;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ParentFolder;
import lightning.base.file.ShippedFile;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.document.EditHistory;
import lightning.document.EditOutcome;
import lightning.document.OpenDocument;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.jen.PropertyEdit;
import lightning.format.jen.PropertyQuery;
import lightning.scene.Scene;
import lightning.scene.SceneWarnings;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Requests that read and change a scene without rendering it. All edits of one request are one step of the history, or none of them. */
final class SceneEditing {
    /** Steps after which the history starts again, so that edits never fill the memory. */
    static final int MAX_STEPS = 10_000;

    private final SceneSource source = new SceneSource();
    private @Nullable OpenDocument document;
    /** Files as this scene was opened from them, or saved to them. */
    private final Map<Path, FileState> known = new HashMap<>();
    private String gestureName = "";
    private @Nullable Object gesture;

    OpenDocument document() {
        return requireNonNull(document);
    }

    /** Opens a file or a text, in place of the open one if there is one; returns what the scene has. */
    ObjectNode open(Fields fields, Progress progress) throws IOException, JenException {
        document = source.open(fields, progress);
        if (!fields.has("text")) {
            Path file = document().file();
            known.put(key(file), document().isUntitled() ? FileState.of(file) : document().knownState());
        }
        gesture = null;
        ObjectNode content = describe();
        addAll(content.putArray("notes"),
                Stream.of(source.notes().stream(), document().notes().stream().map(Object::toString),
                        SceneWarnings.of(document().scene()).stream())
                        .flatMap(notes -> notes).toList());
        return content;
    }

    /** Returns what the scene has now. */
    private ObjectNode describe() {
        Scene scene = document().scene();
        ObjectNode content = JsonLines.JSON.createObjectNode();
        content.putArray("size").add(scene.picture().width()).add(scene.picture().height());
        addAll(content.putArray("lights"), scene.lights().stream().map(Light::name).toList());
        addAll(content.putArray("materials"), scene.materials().stream().map(Material::name).toList());
        content.put("indirect", scene.picture().indirect().isPresent());
        document().content().shot().ifPresent(shot -> content.putArray("frames").add(shot.first()).add(shot.last()));
        return content;
    }

    /** Runs a request that neither renders nor closes the scene. */
    ObjectNode run(Method method, Fields fields) throws IOException {
        return switch (method) {
            case SET -> set(fields);
            case ADD -> change(apply("light", fields.string("light"), document().scene(), PropertyEdit::add), null);
            case DELETE -> change(apply("light", fields.string("light"), document().scene(), PropertyEdit::delete), null);
            case GET -> get(fields);
            case DESCRIBE -> describe().setAll(describeHistory());
            case FRAME -> showFrame(fields);
            case UNDO -> step(fields, EditHistory::undo);
            case REDO -> step(fields, EditHistory::redo);
            case SAVE -> save(fields);
            default -> throw new IllegalArgumentException(method.text());
        };
    }

    private ObjectNode set(Fields fields) {
        List<String> edits = fields.strings("edits");
        Optional<String> name = fields.optionalString("gesture");
        Path folder = ParentFolder.of(document().file());
        Scene edited = document().scene();
        for (int i = 0; i < edits.size(); i++) {
            edited = apply("edits[" + i + "]", edits.get(i), edited, (scene, edit) -> PropertyEdit.apply(scene, edit, folder));
        }
        Scene after = edited;
        ObjectNode result = change(edited, name.map(this::gesture).orElse(null));
        addAll(result.putArray("notes"),
                edits.stream().flatMap(edit -> PropertyEdit.ineffectiveReason(after, edit).stream()).distinct().toList());
        return result;
    }

    private static <T> T apply(String place, String text, Scene scene, BiFunction<Scene, String, T> edit) {
        try {
            return edit.apply(scene, text);
        } catch (RefusalException e) {
            throw new RequestException(ErrorCode.BAD_EDIT, place, e.getMessage());
        }
    }

    /** Returns the object of a gesture: the same one for requests that follow each other with its name. */
    private Object gesture(String name) {
        if (gesture == null || !name.equals(gestureName)) {
            gestureName = name;
            gesture = new Object();
        }
        return gesture;
    }

    /** Makes an edit of a review page as a gesture of the page; returns whether the scene changed. */
    boolean changeByPage(Scene edited, String page) {
        return change(edited, gesture("review page " + page)).get("changed").booleanValue();
    }

    /** Makes an edit, which continues the last one with the same gesture; returns the history after it. */
    ObjectNode change(Scene edited, @Nullable Object asGesture) {
        if (asGesture == null) {
            gesture = null;
        }
        Scene before = document().scene();
        document().apply(new EditOutcome.Applied(edited), asGesture).ifPresent(refusal -> {
            throw new RequestException(ErrorCode.BAD_EDIT, "", refusal);
        });
        if (document().history().position() > MAX_STEPS) {
            document = document().withoutHistory();
        }
        return describeHistory().put("changed", !document().scene().equals(before));
    }

    private ObjectNode get(Fields fields) {
        List<String> properties = fields.strings("properties");
        ObjectNode result = JsonLines.JSON.createObjectNode();
        ObjectNode values = result.putObject("values");
        for (int i = 0; i < properties.size(); i++) {
            values.put(properties.get(i), apply("properties[" + i + "]", properties.get(i), document().scene(), PropertyQuery::get));
        }
        return result;
    }

    private ObjectNode showFrame(Fields fields) {
        Shot shot = document().content().shot()
                .orElseThrow(() -> new RequestException(ErrorCode.BAD_REQUEST, "frame", "the scene has no shot"));
        document().showFrame(fields.integer("frame", shot.first(), shot.last()));
        return JsonLines.JSON.createObjectNode();
    }

    private ObjectNode step(Fields fields, Consumer<EditHistory> step) {
        int steps = fields.integer("steps", 1, Integer.MAX_VALUE, 1);
        EditHistory history = document().history();
        Scene before = document().scene();
        int start = history.position();
        for (int i = 0; i < steps && (i == 0 || history.position() != start); i++) {
            start = history.position();
            step.accept(history);
        }
        gesture = null;
        return describeHistory().put("changed", !document().scene().equals(before));
    }

    /** Returns the number of steps that can be undone, and the names of the next steps. */
    private ObjectNode describeHistory() {
        EditHistory history = document().history();
        ObjectNode node = JsonLines.JSON.createObjectNode().put("steps", history.position());
        history.undoLabel().ifPresent(label -> node.put("undo", label));
        history.redoLabel().ifPresent(label -> node.put("redo", label));
        return node;
    }

    /** Writes the scene to a file, or returns its text. */
    private ObjectNode save(Fields fields) throws IOException {
        Optional<String> name = fields.optionalString("file");
        String text = document().text(document().content());
        if (name.isEmpty()) {
            return JsonLines.JSON.createObjectNode().put("text", text);
        }
        Path file = Path.of(name.get());
        if (!JenFile.isJenFileName(name.get())) {
            throw Fields.bad("file", "expected a name that ends in " + JenFile.EXTENSION + ", found " + Quote.of(name.get()));
        }
        if (ShippedFile.isShipped(file)) {
            throw new RequestException(ErrorCode.FILE, "file", Quote.path(file) + ": scenes of the program are not overwritten");
        }
        InputFiles.referencedBy(document().scene(), ParentFolder.of(document().file())).check(file);
        AtomicFile writer = AtomicFile.of(file);
        FileState state = known.get(key(file));
        if (state != null && !fields.flag("overwrite")) {
            writer = writer.ifUnchanged(state);
        }
        try {
            known.put(key(file), writer.write(text.getBytes(StandardCharsets.UTF_8)));
        } catch (ChangedFileException e) {
            throw new RequestException(ErrorCode.FILE, "file", e.getMessage() + "; \"overwrite\": true replaces it");
        }
        return JsonLines.JSON.createObjectNode().put("file", file.toAbsolutePath().toString());
    }

    /** Returns the path that all spellings of a file's name lead to. */
    private static Path key(Path file) throws IOException {
        Path absolute = file.toAbsolutePath().normalize();
        return Files.exists(absolute) ? absolute.toRealPath() : absolute;
    }

    private static void addAll(ArrayNode array, List<String> texts) {
        texts.forEach(array::add);
    }
}
