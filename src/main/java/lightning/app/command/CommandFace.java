package lightning.app.command;

import java.util.EnumMap;
import java.util.Map;
import javafx.scene.input.KeyCombination;
import lightning.edit.Command;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignE;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignI;
import org.kordamp.ikonli.materialdesign2.MaterialDesignL;
import org.kordamp.ikonli.materialdesign2.MaterialDesignM;
import org.kordamp.ikonli.materialdesign2.MaterialDesignP;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;
import org.kordamp.ikonli.materialdesign2.MaterialDesignU;

/**
 * How a command looks in menus and on buttons.
 *
 * @param title    as the paper has it
 * @param help     what it does, a sentence without a full stop
 * @param shortcut as {@link KeyCombination#valueOf} reads it; empty where there is none
 */
public record CommandFace(String title, String help, Ikon icon, String shortcut) {
    private static final Map<Command, CommandFace> ALL = new EnumMap<>(Command.class);

    static {
        put(Command.GO, "Go", "Render the edits into the traced picture", MaterialDesignP.PLAY, "F5");
        put(Command.UPDATE_REFLECTIONS, "Update Reflections", "Make the mirrors show the lights that the picture shows",
                MaterialDesignM.MIRROR, "F6");
        put(Command.VERIFY, "Verify", "Trace the picture in full in the background and compare", MaterialDesignC.CHECK_DECAGRAM_OUTLINE,
                "F7");
        put(Command.CANCEL, "Cancel", "Stop what is being rendered or verified", MaterialDesignS.STOP, "Esc");
        put(Command.UNDO, "Undo", "Take the last edit back", MaterialDesignU.UNDO, "Shortcut+Z");
        put(Command.REDO, "Redo", "Do again what was undone", MaterialDesignR.REDO, "Shortcut+Shift+Z");
        put(Command.UNDO_LIGHT, "Undo Light", "Take back the last edit of the selected light alone",
                MaterialDesignU.UNDO_VARIANT, "Shortcut+Alt+Z");
        put(Command.REDO_LIGHT, "Redo Light", "Do again what was undone of the selected light alone",
                MaterialDesignR.REDO_VARIANT, "Shortcut+Alt+Shift+Z");
        put(Command.LOAD_FILE, "Load File…", "Open a scene", MaterialDesignF.FOLDER_OPEN_OUTLINE, "Shortcut+O");
        put(Command.RELOAD, "Reload", "Start over with the file as it is on disk", MaterialDesignR.RELOAD, "Shortcut+R");
        put(Command.SAVE_SCENE, "Save Scene", "Write the scene to its file", MaterialDesignC.CONTENT_SAVE_OUTLINE, "Shortcut+S");
        put(Command.SAVE_SCENE_AS, "Save Scene As…", "Write the scene to another file",
                MaterialDesignC.CONTENT_SAVE_EDIT_OUTLINE, "Shortcut+Shift+S");
        put(Command.SAVE_IMAGE, "Save Image…", "Write the traced picture to a file", MaterialDesignI.IMAGE_OUTLINE, "Shortcut+E");
        put(Command.ADD_LIGHT, "Add Light", "Add a light to the scene", MaterialDesignL.LIGHTBULB_ON_OUTLINE, "Shortcut+L");
        put(Command.DELETE_LIGHT, "Delete Light", "Take the selected light out of the scene", MaterialDesignT.TRASH_CAN_OUTLINE,
                "Shortcut+Delete");
        put(Command.DUPLICATE_LIGHT, "Duplicate Light", "Add a light like the selected one",
                MaterialDesignC.CONTENT_DUPLICATE, "Shortcut+D");
        put(Command.RENAME_LIGHT, "Rename Light", "Give the selected light another name", MaterialDesignR.RENAME_BOX, "F2");
        put(Command.CHANGE_TYPE, "Change Type", "Make the selected light a point, spot or directional light",
                MaterialDesignS.SHAPE_OUTLINE, "");
        put(Command.SWITCH_ON, "Light On or Off", "Switch the selected light", MaterialDesignP.POWER, "Shortcut+Shift+H");
        put(Command.SOLO, "Solo", "Let the selected light shine alone", MaterialDesignA.ALPHA_S_BOX_OUTLINE, "Shortcut+Shift+L");
        put(Command.COPY_SETTINGS, "Copy Settings", "Remember the selected light's settings", MaterialDesignC.CONTENT_COPY,
                "Shortcut+Shift+C");
        put(Command.PASTE_SETTINGS, "Paste Settings", "Give the selected light the settings that were copied",
                MaterialDesignC.CONTENT_PASTE, "Shortcut+Shift+V");
        put(Command.AIM, "Aim…", "Turn the selected light to a point picked in the traced picture",
                MaterialDesignC.CROSSHAIRS_GPS, "Shortcut+T");
        put(Command.LOOK_THROUGH_LIGHT, "Look Through Light", "See the preview as the selected light does, and again as before",
                MaterialDesignE.EYE_OUTLINE, "Shortcut+Shift+T");
        put(Command.PICK_MATERIAL, "Edit Material…",
                "Pick a shape in the traced picture and edit its material; a right click on a shape offers it too",
                MaterialDesignE.EYEDROPPER, "Shortcut+Shift+M");
        put(Command.MAKE_ANIMATION, "Make Animation…", "Record and play the way of the selected light",
                MaterialDesignM.MOVIE_OPEN_OUTLINE, "Shortcut+M");
    }

    private static void put(Command command, String title, String help, Ikon icon, String shortcut) {
        ALL.put(command, new CommandFace(title, help, icon, shortcut));
    }

    public static CommandFace of(Command command) {
        return ALL.get(command);
    }

    /** Null where there is none. */
    public KeyCombination keys() {
        return shortcut.isEmpty() ? null : KeyCombination.valueOf(shortcut);
    }

    /**
     * What the tooltip says.
     *
     * @param obstacle why the command is disabled; empty if it is enabled
     */
    String tooltip(String obstacle) {
        String keys = shortcut.isEmpty() ? "" : "  (" + keys().getDisplayText() + ")";
        String does = title.replace("…", "") + keys + "\n" + help + ".";
        return obstacle.isEmpty() ? does : does + "\nNot now: " + obstacle + ".";
    }
}
