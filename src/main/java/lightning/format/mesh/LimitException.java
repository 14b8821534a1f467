package lightning.format.mesh;

import java.nio.file.Path;

/** Content of a file that would take more memory than allowed. It is never skipped: other content may be just as large. */
public final class LimitException extends MeshException {
    private static final long serialVersionUID = 1;

    /** Creates an exception; parameters as those of {@link MeshException}. */
    public LimitException(Path file, String location, String message) {
        super(file, location, message);
    }
}
