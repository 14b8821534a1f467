package lightning.editor.window.model;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import lightning.editor.document.Command;
import lightning.editor.document.PreviewCamera;
import lightning.scene.Light;

/**
 * Whether the preview's camera is the selected light's. It follows the light and the selection as long as it is; any other
 * camera ends it.
 */
final class LightCameraToggle {
    private final SceneEditor editor;
    private final ObjectProperty<PreviewCamera> camera;
    private final BooleanProperty isOn = new SimpleBooleanProperty();
    private PreviewCamera previousCamera;
    private boolean isFollowing;

    private LightCameraToggle(SceneEditor editor, ObjectProperty<PreviewCamera> camera) {
        this.editor = editor;
        this.camera = camera;
        camera.addListener((_, _, _) -> {
            if (!isFollowing) {
                isOn.set(false);
            }
        });
        editor.selection().lightProperty().addListener((_, _, light) -> {
            if (isOn.get()) {
                follow(light);
            }
        });
    }

    /** Does the command. */
    static void register(CommandRegistry commands, SceneEditor editor, ObjectProperty<PreviewCamera> camera) {
        var cameraToggle = new LightCameraToggle(editor, camera);
        commands.setToggle(Command.LOOK_THROUGH_LIGHT, cameraToggle.isOn, cameraToggle::toggle);
    }

    /** Looks through the selected light, or again as before. */
    private void toggle() {
        if (isOn.get()) {
            camera.set(previousCamera);
            isOn.set(false);
        } else {
            previousCamera = camera.get();
            isOn.set(true);
            follow(editor.selection().light());
        }
    }

    private void follow(Light light) {
        if (light == null) {
            isOn.set(false);
            return;
        }
        isFollowing = true;
        camera.set(PreviewCamera.throughLight(light, editor.scene()));
        isFollowing = false;
    }
}
