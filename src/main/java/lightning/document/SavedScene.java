package lightning.document;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.file.FileState;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;

/** Content of a scene file when it was last read or written. */
public record SavedScene(Path file, FileState state, JenDocument document) {
    /**
     * Reads a scene file.
     *
     * @throws IOException  if the file cannot be read
     * @throws JenException if its content is invalid; holds all problems
     */
    static SavedScene read(Path file) throws IOException, JenException {
        // Taken before reading, so that a concurrent change counts as external and is not lost.
        FileState state = FileState.of(file);
        return new SavedScene(file, state, JenReader.read(file));
    }
}
