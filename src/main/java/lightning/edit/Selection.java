package lightning.edit;

import java.util.Optional;
import lightning.scene.Light;

/**
 * What the artist works on. It follows a light through renames. Where the light is gone, its neighbour stands in for it
 * until undo brings it back.
 */
public sealed interface Selection {
    Selection NONE = new None();

    record None() implements Selection {}

    /** @param id the light's number in the {@link History} */
    record OfLight(long id) implements Selection {}

    record OfShape(String name) implements Selection {}

    /** The light of that name, or nothing if there is none. */
    static Selection light(History history, String name) {
        long id = history.id(name);
        return id < 0 ? NONE : new OfLight(id);
    }

    /** The selected light as it is now, or its neighbour where it is gone; empty if none is selected or there are no lights. */
    default Optional<Light> light(History history) {
        return switch (this) {
            case None _ -> Optional.empty();
            case OfShape _ -> Optional.empty();
            case OfLight selected -> history.light(selected.id()).or(() -> history.neighbour(selected.id()));
        };
    }
}
