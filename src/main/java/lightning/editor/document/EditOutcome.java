package lightning.editor.document;

import java.util.Optional;
import java.util.function.Supplier;
import lightning.scene.Scene;

/** What came of an edit. */
public sealed interface EditOutcome {
    /** The edited scene, which may equal the one before. */
    record Applied(Scene scene) implements EditOutcome {}

    /** The edit is not allowed and changes nothing; the reason is a clause without a full stop. */
    record Refused(String reason) implements EditOutcome {}

    /** The change that an edit makes, or its refusal where the scene's own limits forbid it. */
    static EditOutcome of(Supplier<Scene> edit) {
        try {
            return new Applied(edit.get());
        } catch (IllegalArgumentException e) {
            return new Refused(e.getMessage());
        }
    }

    /** Why the edit was refused; empty if it was not. */
    default Optional<String> refusal() {
        return switch (this) {
            case Applied _ -> Optional.empty();
            case Refused refused -> Optional.of(refused.reason());
        };
    }

    /** The edited scene, or {@code before} where the edit was refused. */
    default Scene sceneOr(Scene before) {
        return switch (this) {
            case Applied to -> to.scene();
            case Refused _ -> before;
        };
    }
}
