package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.Supplier;
import lightning.document.EditOutcome;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/**
 * Property of the selected element, in scene-file syntax.
 *
 * @param selected returns the selected element; empty if there is none with the property
 */
record SelectedProperty<T>(Supplier<Optional<SceneElement<T>>> selected, SceneAttribute<T, ?> attribute) {
    /** Returns the name in the scene file. */
    String name() {
        return attribute.name();
    }

    /** Returns the element. @throws java.util.NoSuchElementException if none is selected */
    SceneElement<T> element() {
        return selected.get().orElseThrow();
    }

    boolean isPresent() {
        return selected.get().isPresent();
    }

    /** Returns the value in scene-file syntax. */
    String text(Scene scene) {
        return PropertyEdit.text(scene, element(), name());
    }

    /** @param value  value in scene-file syntax; may refer only to loaded assets, since no file is read */
    EditOutcome set(Scene scene, String value) {
        return EditOutcome.of(() -> PropertyEdit.set(scene, element(), name(), value));
    }

    /** Resets the property to its initial value. */
    EditOutcome reset(Scene scene) {
        return EditOutcome.edit(scene, element(), attribute::reset);
    }

    /** Returns whether the property can be animated in the scene. */
    boolean canHaveKeys(Scene scene) {
        return selected.get().filter(element -> Track.canAnimate(element) && element.existsIn(scene)).isPresent()
                && attribute.kind().keyframeSupport() != KeyframeSupport.NONE;
    }

    /** Returns the keyframes of the property in a shot. */
    Optional<Track> track(Shot shot) {
        return selected.get().flatMap(element -> shot.track(element, name()));
    }
}
