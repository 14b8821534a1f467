package lightning.editor.window.model;

import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import lightning.document.manipulation.PreviewCamera;
import lightning.editor.Command;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Toggle that makes the preview look through the selected light. It follows the light and the selection; any other camera change switches
 * it off.
 */
final class LightCameraToggle {
    private final SceneEditor editor;
    private final ObjectProperty<PreviewCamera> camera;
    private final BooleanProperty isOn = new SimpleBooleanProperty();
    private @Nullable PreviewCamera previousCamera;
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

    /** Registers the toggle's command. */
    static void register(CommandRegistry commands, SceneEditor editor, ObjectProperty<PreviewCamera> camera) {
        var cameraToggle = new LightCameraToggle(editor, camera);
        commands.setToggle(Command.LOOK_THROUGH_LIGHT, cameraToggle.isOn, cameraToggle::toggle);
    }

    /** Looks through the selected light, or restores the previous camera. */
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

    private void follow(@Nullable Light light) {
        if (light == null) {
            isOn.set(false);
            return;
        }
        isFollowing = true;
        camera.set(PreviewCamera.throughLight(light, editor.scene()));
        isFollowing = false;
    }
}
