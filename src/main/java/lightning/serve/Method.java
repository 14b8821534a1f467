package lightning.serve;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.format.jen.asset.NameSuggestion;

/** Methods of the protocol with the fields that each allows. */
enum Method {
    OPEN("file", "text", "folder", "output", "indirect", "light_units", "lighting", "subdivision", "variant", "camera", "frame", "keep"),
    REPLACE("scene", "file", "text", "folder", "output", "indirect", "light_units", "lighting", "subdivision", "variant", "camera",
            "frame"),
    DESCRIBE("scene"),
    SET("scene", "edits", "gesture"),
    ADD("scene", "light"),
    DELETE("scene", "light"),
    GET("scene", "properties"),
    FRAME("scene", "frame"),
    UNDO("scene", "steps"),
    REDO("scene", "steps"),
    RENDER("scene", "region", "light", "file", "bits", "layers", "memory", "coarse", "progress"),
    EXPLAIN("scene", "pixel", "progress"),
    MATCH("scene", "reference", "lights", "change", "exposure", "white", "region", "progress"),
    REVIEW("scene", "allow_edits", "end"),
    SAVE("scene", "file", "overwrite"),
    CLOSE("scene"),
    LIST(),
    CANCEL("request"),
    SHUTDOWN();

    /** Number of the scene, in requests and answers. */
    static final String SCENE = "scene";

    private final Set<String> fields;

    Method(String... fields) {
        this.fields = new HashSet<>(Set.of(fields));
        this.fields.addAll(Set.of("id", "method"));
    }

    /** Returns whether it needs an open scene. */
    boolean hasScene() {
        return fields.contains(SCENE);
    }

    /** Returns the fields that a request may have. */
    Set<String> fields() {
        return Set.copyOf(fields);
    }

    String text() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Method of(String text) {
        return Arrays.stream(values()).filter(method -> method.text().equals(text)).findFirst()
                .orElseThrow(() -> Fields.bad("method", "unknown method " + Quote.of(text) + "; expected one of "
                        + Arrays.stream(values()).map(Method::text).collect(Collectors.joining(", "))
                        + NameSuggestion.hint(text, Arrays.stream(values()).map(Method::text).toList())));
    }
}
