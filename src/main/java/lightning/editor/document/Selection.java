package lightning.editor.document;

import java.util.Optional;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.SceneNode;

/**
 * What the artist works on. It follows a light through renames. Where the light is gone, its neighbor stands in for it
 * until undo brings it back.
 */
public sealed interface Selection {
    Selection NONE = new None();

    record None() implements Selection {}

    /** @param id the light's number in the {@link EditHistory} */
    record OfLight(long id) implements Selection {}

    /** A shape or a group, by its name; nothing while there is none of that name. */
    record OfNode(String name) implements Selection {}

    /** The selected shape or group as it is in a scene; empty if none is selected, or it is gone. */
    default Optional<SceneNode> node(Scene scene) {
        return switch (this) {
            case None _ -> Optional.empty();
            case OfLight _ -> Optional.empty();
            case OfNode(String name) -> scene.stage().node(name);
        };
    }

    /** The light of that name, or nothing if there is none. */
    static Selection light(EditHistory history, String name) {
        long id = history.id(name);
        return id < 0 ? NONE : new OfLight(id);
    }

    /** The selected light as it is now, or its neighbor where it is gone; empty if none is selected or there are no lights. */
    default Optional<Light> light(EditHistory history) {
        return switch (this) {
            case None _ -> Optional.empty();
            case OfNode _ -> Optional.empty();
            case OfLight selected -> history.light(selected.id()).or(() -> history.neighbor(selected.id()));
        };
    }
}
