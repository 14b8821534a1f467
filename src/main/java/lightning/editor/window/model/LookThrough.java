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
final class LookThrough {
    private final SceneEditor editor;
    private final ObjectProperty<PreviewCamera> camera;
    private final BooleanProperty on = new SimpleBooleanProperty();
    private PreviewCamera before;
    private boolean following;

    private LookThrough(SceneEditor editor, ObjectProperty<PreviewCamera> camera) {
        this.editor = editor;
        this.camera = camera;
        camera.addListener((_, _, _) -> {
            if (!following) {
                on.set(false);
            }
        });
        editor.selection().lightProperty().addListener((_, _, light) -> {
            if (on.get()) {
                follow(light);
            }
        });
    }

    /** Does the command. */
    static void addTo(Commands commands, SceneEditor editor, ObjectProperty<PreviewCamera> camera) {
        var look = new LookThrough(editor, camera);
        commands.setSwitch(Command.LOOK_THROUGH_LIGHT, look.on, look::toggle);
    }

    /** Looks through the selected light, or again as before. */
    private void toggle() {
        if (on.get()) {
            camera.set(before);
            on.set(false);
        } else {
            before = camera.get();
            on.set(true);
            follow(editor.selection().light());
        }
    }

    private void follow(Light light) {
        if (light == null) {
            on.set(false);
            return;
        }
        following = true;
        camera.set(PreviewCamera.through(light, editor.scene()));
        following = false;
    }
}
