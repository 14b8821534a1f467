package lightning.document;

import java.util.Optional;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.node.SceneNode;

/** Selection of the artist. It follows renamed lights. A neighbor substitutes a deleted light until undo restores it. */
public sealed interface Selection {
    Selection NONE = new None();

    record None() implements Selection {}

    /** @param id number of the light in the {@link EditHistory} */
    record OfLight(long id) implements Selection {}

    /** Selected shape or group by name; nothing while the name does not exist. */
    record OfNode(String name) implements Selection {}

    /** Returns the selected shape or group in a scene; empty if none is selected or it was deleted. */
    default Optional<SceneNode> node(Scene scene) {
        return switch (this) {
            case None _ -> Optional.empty();
            case OfLight _ -> Optional.empty();
            case OfNode(String name) -> scene.stage().node(name);
        };
    }

    /** Returns a selection of the light with that name, or nothing if it does not exist. */
    static Selection light(EditHistory history, String name) {
        long id = history.id(name);
        return id < 0 ? NONE : new OfLight(id);
    }

    /** Returns the selected light, or its neighbor if it was deleted; empty if none is selected or there are no lights. */
    default Optional<Light> light(EditHistory history) {
        return switch (this) {
            case None _ -> Optional.empty();
            case OfNode _ -> Optional.empty();
            case OfLight selected -> history.light(selected.id()).or(() -> history.neighbor(selected.id()));
        };
    }
}
