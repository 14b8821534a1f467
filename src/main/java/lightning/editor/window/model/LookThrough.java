package lightning.editor.window.model;

import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import lightning.editor.document.Command;
import lightning.editor.document.PreviewCamera;
import lightning.scene.Light;

/**
 * Whether the preview's camera is the selected light's. It follows the light and the selection as long as it is; any other
 * camera ends it.
 */
public final class LookThrough {
    private final EditorModel model;
    private final ReadOnlyBooleanWrapper on = new ReadOnlyBooleanWrapper();
    private PreviewCamera before;
    private boolean following;

    LookThrough(EditorModel model) {
        this.model = model;
        model.commands().setSwitch(Command.LOOK_THROUGH_LIGHT, on, this::toggle);
        model.previewCameraProperty().addListener((_, _, _) -> {
            if (!following) {
                on.set(false);
            }
        });
        model.selectedLightProperty().addListener((_, _, light) -> {
            if (on.get()) {
                follow(light);
            }
        });
    }

    public ReadOnlyBooleanProperty onProperty() {
        return on.getReadOnlyProperty();
    }

    /** Looks through the selected light, or again as before. */
    private void toggle() {
        if (on.get()) {
            model.previewCameraProperty().set(before);
            on.set(false);
        } else {
            before = model.previewCameraProperty().get();
            on.set(true);
            follow(model.selectedLight());
        }
    }

    private void follow(Light light) {
        if (light == null) {
            on.set(false);
            return;
        }
        following = true;
        model.previewCameraProperty().set(PreviewCamera.through(light, model.scene()));
        following = false;
    }
}
