package lightning.format.mesh;

import java.nio.file.Path;
import lightning.base.text.Quote;
import lightning.base.text.Told;
import lightning.base.text.Visible;

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
