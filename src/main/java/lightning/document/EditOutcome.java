package lightning.document;

import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.SceneElement;

/** Result of an edit: a new scene or a refusal. */
public sealed interface EditOutcome {
    /**
     * Edited scene, which may equal the previous one.
     *
     * @param label name of the undo step; empty to describe the difference
     */
    record Applied(Scene scene, String label) implements EditOutcome {
        public Applied(Scene scene) {
            this(scene, "");
        }
    }

    /** Refusal of an edit, which changes nothing; the reason is a clause without a period. */
    record Refused(String reason) implements EditOutcome {}

    /** Returns the result of an edit, or its refusal if it violates a limit of the scene. */
    static EditOutcome of(Supplier<Scene> edit) {
        try {
            return new Applied(edit.get());
        } catch (RefusalException e) {
            return new Refused(e.getMessage());
        }
    }

    /** Returns the result of an edit of one element, which is refused if the scene does not have it. */
    static <T> EditOutcome edit(Scene scene, SceneElement<T> element, UnaryOperator<T> change) {
        return of(() -> element.edit(scene, change));
    }

    /** Returns this outcome with a name for its undo step. */
    default EditOutcome named(String label) {
        return switch (this) {
            case Applied to -> new Applied(to.scene(), label);
            case Refused refused -> refused;
        };
    }

    /** Returns the reason for the refusal; empty if applied. */
    default Optional<String> refusal() {
        return switch (this) {
            case Applied _ -> Optional.empty();
            case Refused refused -> Optional.of(refused.reason());
        };
    }

    /** Returns the edited scene, or {@code before} if the edit was refused. */
    default Scene sceneOr(Scene before) {
        return switch (this) {
            case Applied to -> to.scene();
            case Refused _ -> before;
        };
    }
}
