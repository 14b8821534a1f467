package lightning.format.mesh;

import java.nio.file.Path;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.base.text.UserFacingException;

/** Invalid mesh file; the one-line message contains the file, the position, and expected and found content. */
public class MeshException extends Exception implements UserFacingException {
    private static final long serialVersionUID = 1;

    /**
     * Creates an exception.
     *
     * @param location position in the file, such as {@code line 7} or {@code accessors[3].count}; empty for the whole file
     * @param message expected and found content
     */
    public MeshException(Path file, String location, String message) {
        super(Quote.path(file) + ": " + PrintableText.escape(location.isEmpty() ? message : location + ": " + message));
    }
}
