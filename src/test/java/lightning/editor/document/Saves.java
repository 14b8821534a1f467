package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import lightning.format.jen.JenException;

/** Saves and reads documents as the editor does, but at once. */
public final class Saves {
    private Saves() {}

    public static void save(OpenDocument document, Consent... allowed) throws IOException {
        saveAs(document, document.file(), allowed);
    }

    public static void saveAs(OpenDocument document, Path file, Consent... allowed) throws IOException {
        document.written(document.writing(file, Set.of(allowed)).write());
    }

    public static void reload(OpenDocument document) throws IOException, JenException {
        document.reloaded(SavedScene.read(document.file()));
    }
}
