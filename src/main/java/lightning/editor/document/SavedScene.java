package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.file.FileState;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;

/** A scene as a file holds it, since it was read there or written there. */
record SavedScene(Path file, FileState state, JenDocument document) {
    /**
     * Reads it.
     *
     * @throws IOException  if it cannot be read at all
     * @throws JenException if its content is wrong; holds all problems
     */
    static SavedScene read(Path file) throws IOException, JenException {
        // Before it is read: what comes in between then counts as another's change, and is not lost.
        FileState state = FileState.of(file);
        return new SavedScene(file, state, JenReader.read(file));
    }
}
