package lightning.document;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import lightning.format.jen.JenException;

/** Synchronous saves and reloads of documents, with the editor's code. */
public final class TestSaves {
    private TestSaves() {}

    public static void save(OpenDocument document, OverwriteConfirmation... allowed) throws IOException {
        saveAs(document, document.file(), allowed);
    }

    public static void saveAs(OpenDocument document, Path file, OverwriteConfirmation... allowed) throws IOException {
        document.onSaved(document.prepareSave(file, Set.of(allowed)).write());
    }

    public static void reload(OpenDocument document) throws IOException, JenException {
        document.onReloaded(SavedScene.read(document.file()));
    }
}
