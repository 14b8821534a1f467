package lightning.editor.window.preview;

import java.util.List;
import javafx.beans.property.ObjectProperty;
import javafx.scene.input.KeyEvent;
import lightning.document.LightEdits;
import lightning.document.manipulation.CameraDrag;
import lightning.document.manipulation.DragRounding;
import lightning.document.manipulation.LightManipulation;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.command.ShapeKeys;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.light.Light;

/**
 * Keyboard handler of the preview. Arrows rotate the selected light; with Control they move it in the view plane, and Page Up and Down move
 * it along the view axis. With Shift, arrows zoom and pan the camera; with Shift and Control they rotate it. Square brackets select the
 * previous and next light. X, Y and Z set the three views, A frames all lights, and G toggles the light handles.
 */
final class PreviewKeys {
    /** Drag distance that corresponds to one key press, pixels. */
    private static final double STEP = 8;

    private final SceneEditor editor;
    private final CommandRegistry commands;
    private final ObjectProperty<PreviewCamera> camera;
    private final PreviewMouse mouse;
    private Object gesture = new Object();

    PreviewKeys(SceneEditor editor, CommandRegistry commands, ObjectProperty<PreviewCamera> camera, PreviewMouse mouse) {
        this.editor = editor;
        this.commands = commands;
        this.camera = camera;
        this.mouse = mouse;
    }

    /** Ends the current undo step: a held key is one step. */
    void handleRelease() {
        gesture = new Object();
    }

    void handlePress(KeyEvent e) {
        if (handle(e) || ShapeKeys.handle(commands, e)) {
            e.consume();
        }
    }

    private boolean handle(KeyEvent e) {
        if (e.isAltDown() || e.isMetaDown()) {
            return false;
        }
        boolean plain = !e.isShiftDown() && !e.isControlDown();
        return switch (e.getCode()) {
            case LEFT -> handleArrow(e, -STEP, 0);
            case RIGHT -> handleArrow(e, STEP, 0);
            case UP -> handleArrow(e, 0, STEP);
            case DOWN -> handleArrow(e, 0, -STEP);
            case PAGE_UP -> plain && dolly(STEP);
            case PAGE_DOWN -> plain && dolly(-STEP);
            case X -> plain && run(Command.VIEW_X);
            case Y -> plain && run(Command.VIEW_Y);
            case Z -> plain && run(Command.VIEW_Z);
            case L -> plain && run(Command.LOOK_THROUGH_LIGHT);
            case G -> plain && run(Command.HIDE_GIZMOS);
            case HOME, A -> plain && run(Command.VIEW_ALL);
            case OPEN_BRACKET -> select(-1);
            case CLOSE_BRACKET -> select(1);
            default -> false;
        };
    }

    private boolean handleArrow(KeyEvent e, double right, double up) {
        PreviewCamera view = camera.get();
        Viewport canvas = mouse.canvas();
        if (e.isShiftDown()) {
            CameraDrag drag = e.isControlDown() ? CameraDrag.TRACKBALL : up == 0 ? CameraDrag.PAN : CameraDrag.ZOOM;
            return setView(drag.apply(view, canvas, right, -up));
        }
        Light light = editor.selection().light();
        return light != null && edit(light, e.isControlDown()
                ? LightManipulation.translate(light, view, canvas, right, up)
                : LightManipulation.rotate(light, view, canvas, right, up));
    }

    private boolean dolly(double away) {
        Light light = editor.selection().light();
        return light != null
                && edit(light, LightManipulation.dolly(light, camera.get(), mouse.canvas(), away));
    }

    private boolean edit(Light light, Light moved) {
        Light newLight = DragRounding.round(light, moved, camera.get(), mouse.canvas());
        editor.editOrReport(scene -> LightEdits.edit(scene, newLight.name(), _ -> newLight), gesture);
        return true;
    }

    private boolean setView(PreviewCamera newView) {
        camera.set(newView);
        return true;
    }

    private boolean run(Command command) {
        commands.run(command);
        return true;
    }

    private boolean select(int step) {
        List<Light> lights = editor.scene().lights();
        if (!lights.isEmpty()) {
            int index = lights.indexOf(editor.selection().light());
            editor.selection().selectLight(lights.get(Math.floorMod(index < 0 ? 0 : index + step, lights.size())).name());
        }
        return true;
    }
}
