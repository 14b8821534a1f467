package lightning.mesh;

import java.nio.file.Path;
import lightning.text.Quote;
import lightning.text.Told;
import lightning.text.Visible;

/** A file of meshes cannot be used; the message says in one line which file, the place in it, what was expected and what was found. */
public final class MeshException extends Exception implements Told {
    private static final long serialVersionUID = 1;

    /**
     * @param place   where in the file, as in {@code line 7} or {@code accessors[3].count}; empty for the file as a whole
     * @param message what was expected and what was found
     */
    public MeshException(Path file, String place, String message) {
        super(Quote.path(file) + ": " + Visible.escaped(place.isEmpty() ? message : place + ": " + message));
    }
}
