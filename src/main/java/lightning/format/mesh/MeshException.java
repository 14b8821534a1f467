package lightning.format.mesh;

import java.nio.file.Path;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.base.text.UserFacingException;

/** A file of meshes cannot be used; the message says in one line which file, the place in it, what was expected and what was found. */
public final class MeshException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    /**
     * @param location   where in the file, as in {@code line 7} or {@code accessors[3].count}; empty for the file as a whole
     * @param message what was expected and what was found
     */
    public MeshException(Path file, String location, String message) {
        super(Quote.path(file) + ": " + PrintableText.escape(location.isEmpty() ? message : location + ": " + message));
    }
}
