package lightning.editor.document;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Texts;

/**
 * Everything that an artist can ask for: its words, its key, and why it has nothing to do now (paper §3.2 to §3.7). All
 * menus, and the buttons that do the same, are made of these; what one does says whoever can do it.
 */
public enum Command {
    NEW_SCENE(Texts.key("New Scene…"), Texts.key("Begin a scene: a ball on a floor, three lights, 1280 × 720 with smooth edges"),
            "mdi2f-file-plus-outline",
            "Shortcut+N", Obstacles.alone()),
    LOAD_FILE(Texts.key("Load File…"), Texts.key("Open a scene, or make one of a glTF, OBJ, PLY or NFF file"), "mdi2f-folder-open-outline",
            "Shortcut+O",
            Obstacles.alone()),
    LOAD_RECENT(Texts.key("Load Recent"), Texts.key("Open a scene that was open before"), "mdi2h-history", "", Obstacles.alone()),
    RELOAD(Texts.key("Reload"), Texts.key("Start over with the file as it is on disk"), "mdi2r-reload", "Shortcut+R",
            Obstacles.alone(Obstacles::asOnDisk)),
    SAVE_SCENE(Texts.key("Save Scene"), Texts.key("Write the scene to its file"), "mdi2c-content-save-outline", "Shortcut+S",
            Obstacles.alone(Obstacles::saved)),
    SAVE_SCENE_AS(Texts.key("Save Scene As…"), Texts.key("Write the scene to another file"), "mdi2c-content-save-edit-outline",
            "Shortcut+Shift+S",
            Obstacles.alone()),
    SAVE_IMAGE(Texts.key("Save Image…"), Texts.key("Write the traced picture to a file"), "mdi2i-image-outline", "Shortcut+E",
            Obstacles::noPicture),
    EXPORT(Texts.key("Export"), Texts.key("Write the picture for other programs: layers, floats, 16 bits"), "mdi2e-export-variant", "",
            Obstacles::noPicture),
    QUIT(Texts.key("Quit"), Texts.key("Close the window; it asks about edits that are not saved"), "mdi2e-exit-to-app", "Shortcut+Q",
            Obstacles.NONE),

    UNDO(Texts.key("Undo"), Texts.key("Take the last edit back"), "mdi2u-undo", "Shortcut+Z", Obstacles.alone(Obstacles::nothingToUndo),
            Situation::undo),
    REDO(Texts.key("Redo"), Texts.key("Do again what was undone"), "mdi2r-redo", "Shortcut+Shift+Z",
            Obstacles.alone(Obstacles::nothingToRedo), Situation::redo),
    UNDO_LIGHT(Texts.key("Undo Light"), Texts.key("Take back the last edit of the selected light alone"), "mdi2u-undo-variant",
            "Shortcut+Alt+Z",
            Obstacles.alone(Obstacles::nothingToUndoOfLight), Situation::undoLight),
    REDO_LIGHT(Texts.key("Redo Light"), Texts.key("Do again what was undone of the selected light alone"), "mdi2r-redo-variant",
            "Shortcut+Alt+Shift+Z",
            Obstacles.alone(Obstacles::nothingToRedoOfLight), Situation::redoLight),
    HISTORY_PANEL(Texts.key("Undo History…"),
            Texts.key("All edits as a list; a click goes there, for the document or for the selected light alone"),
            "mdi2h-history", "Shortcut+Alt+H", Obstacles.NONE),
    COPY_SETTINGS(Texts.key("Copy Settings"), Texts.key("Remember the selected light's settings"), "mdi2c-content-copy", "Shortcut+Shift+C",
            Obstacles::noLight),
    PASTE_SETTINGS(Texts.key("Paste Settings"), Texts.key("Give the selected light the settings that were copied"), "mdi2c-content-paste",
            "Shortcut+Shift+V",
            Obstacles.alone(Obstacles::nothingCopied)),
    COPY_PROPERTY(Texts.key("Copy Property"),
            Texts.key("Remember one property of a light, a material or a shape, as the scene file writes it"),
            "mdi2c-content-copy", "",
            Obstacles.NONE),
    PASTE_PROPERTY(Texts.key("Paste Property"),
            Texts.key("Give a light, a material or a shape the property that was copied, from wherever or from a text"),
            "mdi2c-content-paste", "", Obstacles.alone()),
    RESET_PROPERTY(Texts.key("Reset Property"), Texts.key("Give a property of a light, a material or a shape the value that a new one has"),
            "mdi2r-restore", "",
            Obstacles.alone()),
    PICK_MATERIAL(Texts.key("Edit Material…"),
            Texts.key("Pick a shape in the traced picture and edit its material; a right click on a shape offers it too"),
            "mdi2e-eyedropper", "Shortcut+Shift+M", Obstacles::noPicture),
    EDIT_MATERIAL(Texts.key("Edit Material of Shape"), Texts.key("Edit the material of the shape under the mouse"), "mdi2p-palette-outline",
            "", Obstacles.NONE),
    CHOOSE_TEXTURE(Texts.key("Choose Texture"), Texts.key("Give the material a picture that lies beside the scene"), "mdi2i-image-plus", "",
            Obstacles.NONE),

    CHOOSE_GOBO(Texts.key("Choose Gobo"), Texts.key("Let the light project a picture that lies beside the scene"), "mdi2p-projector", "",
            Obstacles.NONE),

    CHOOSE_ENVIRONMENT(Texts.key("Choose Environment"),
            Texts.key("Surround the scene with a picture that lies beside it, and light it by that"),
            "mdi2i-image-filter-hdr", "", Obstacles.NONE),

    SELECT_SHAPE(Texts.key("Select Shape"), Texts.key("Select the shape under the mouse, to place it"),
            "mdi2c-cursor-default-click-outline", "", Obstacles.NONE),
    SHOW_SHAPE(Texts.key("Hide or Show Shape"), Texts.key("Take the selected shape or group out of the picture, or bring it back"),
            "mdi2e-eye-off-outline", "",
            Obstacles.alone(Obstacles::noShape)),
    DUPLICATE_SHAPE(Texts.key("Duplicate Shape"), Texts.key("Add a shape or a group like the selected one beside it"),
            "mdi2c-content-duplicate", "",
            Obstacles.alone(Obstacles::noShapeOrNoRoom)),
    DELETE_SHAPE(Texts.key("Delete Shape"), Texts.key("Take the selected shape or group out of the scene"), "mdi2t-trash-can-outline", "",
            Obstacles.alone(Obstacles::noShape)),
    RENAME_SHAPE(Texts.key("Rename Shape"), Texts.key("Give the selected shape or group another name"), "mdi2r-rename-box", "",
            Obstacles.alone(Obstacles::noShape)),
    CHOOSE_PROFILE(Texts.key("Choose Profile"), Texts.key("Let the light shine as an IES file tells that lies beside the scene"),
            "mdi2c-chart-bell-curve", "",
            Obstacles.NONE),

    LINK(Texts.key("Link Light and Shapes"),
            Texts.key("Choose which shapes and groups the light shines on, and which throw shadows in its light"),
            "mdi2l-link-variant", "", Obstacles::noLight),

    ADD_LIGHT(Texts.key("Add Light"), Texts.key("Add a light to the scene"), "mdi2l-lightbulb-on-outline", "Shortcut+L",
            Obstacles.alone(Obstacles::noRoom)),
    DUPLICATE_LIGHT(Texts.key("Duplicate Light"), Texts.key("Add a light like the selected one"), "mdi2c-content-duplicate", "Shortcut+D",
            Obstacles.alone(Obstacles::noLightOrNoRoom)),
    DELETE_LIGHT(Texts.key("Delete Light"), Texts.key("Take the selected light out of the scene"), "mdi2t-trash-can-outline",
            "Shortcut+Delete",
            Obstacles.alone(Obstacles::noLight)),
    RENAME_LIGHT(Texts.key("Rename Light"), Texts.key("Give the selected light another name"), "mdi2r-rename-box", "F2",
            Obstacles.alone(Obstacles::noLight)),
    CHANGE_TYPE(Texts.key("Change Type"), Texts.key("Make the selected light a point, spot or directional light"), "mdi2s-shape-outline",
            "",
            Obstacles.alone(Obstacles::noLight)),
    SWITCH_ON(Texts.key("Light On or Off"), Texts.key("Switch the selected light"), "mdi2p-power", "Shortcut+Shift+H",
            Obstacles.alone(Obstacles::noLight)),
    SOLO(Texts.key("Solo"), Texts.key("Let the selected light shine alone"), "mdi2a-alpha-s-box-outline", "Shortcut+Shift+L",
            Obstacles.alone(Obstacles::noLight)),
    NEW_BANK(Texts.key("New Bank"),
            Texts.key("Put the selected light into a bank of its own, whose master and gel act on all lights in it"),
            "mdi2t-tune-vertical", "", Obstacles.alone(Obstacles::noLightOrNoBankMore)),
    DELETE_BANK(Texts.key("Delete Bank"), Texts.key("Take the selected light's bank away; its lights stay"), "mdi2t-trash-can-outline", "",
            Obstacles.alone(Obstacles::noBank)),
    LOOK_THROUGH_LIGHT(Texts.key("Look Through Light"), Texts.key("See the preview as the selected light does, and again as before"),
            "mdi2e-eye-outline",
            "Shortcut+Shift+T", Obstacles::noLight),
    AIM(Texts.key("Aim…"), Texts.key("Turn the selected light to a point of the traced picture, by a click or a drag of its pool"),
            "mdi2c-crosshairs-gps",
            "Shortcut+T",
            Obstacles.alone(Obstacles::noDirection)),
    PLACE_HIGHLIGHT(Texts.key("Place Highlight…"), Texts.key("Move the selected light so that its highlight lies where you click or drag"),
            "mdi2f-flare",
            "Shortcut+Shift+G", Obstacles.alone(Obstacles::noLight)),
    PLACE_DIFFUSE(Texts.key("Place Diffuse…"), Texts.key("Move the selected light so that it shines straight onto where you click or drag"),
            "mdi2c-circle-half-full", "Shortcut+Shift+F", Obstacles.alone(Obstacles::noLight)),
    PLACE_RIM(Texts.key("Place Rim…"),
            Texts.key("Move the selected light behind a shape, so that a rim of light begins where you click or drag"),
            "mdi2w-weather-night", "Shortcut+Shift+R", Obstacles.alone(Obstacles::noLight)),
    PLACE_SHADOW(Texts.key("Place Shadow…"),
            Texts.key("Move the selected light so that the shadow of a point falls where you click, or drag a shadow"),
            "mdi2b-box-shadow", "Shortcut+Shift+D", Obstacles.alone(Obstacles::noLight)),
    MAKE_ANIMATION(Texts.key("Make Animation…"), Texts.key("Record and play the way of the selected light"), "mdi2m-movie-open-outline",
            "Shortcut+M",
            Obstacles.alone(Obstacles::nothingToAnimate)),

    WAY_TO_KEYS(Texts.key("Way into Keys"),
            Texts.key("Let the selected light go the way of the open animation in the shot, from this frame on"),
            "mdi2m-movie-plus-outline", "", Obstacles::noWay),
    KEYS_TO_WAY(Texts.key("Keys into Way…"),
            Texts.key("Make an animation of the keys that the selected light has of its place and direction"),
            "mdi2m-movie-cog-outline", "", Obstacles.alone(Obstacles::noWayInKeys)),

    MIXER(Texts.key("Light Mixer…"), Texts.key("A strip for each light and bank: what it gives to the picture, fader, colour, solo, mute"),
            "mdi2t-tune-vertical", "F4", Obstacles.NONE),

    CONTRIBUTIONS(Texts.key("Which Lights Matter…"),
            Texts.key("Each light's share of the picture, of a part and of a pixel; switch off what nobody sees"),
            "mdi2c-chart-bar", "Shortcut+F9", Obstacles.NONE),
    CUES(Texts.key("Cues…"), Texts.key("Keep how the scene is lit with its picture; restore, compare and blend"),
            "mdi2v-view-gallery-outline", "Shift+F4",
            Obstacles.NONE),
    LOAD_RIG(Texts.key("Load Light Rig…"), Texts.key("Let the lights and banks of a file take the place of the scene's"),
            "mdi2f-file-import-outline", "",
            Obstacles.alone()),
    ADD_RIG(Texts.key("Add Light Rig…"), Texts.key("Add the lights and banks of a file to the scene's"), "mdi2f-file-plus-outline", "",
            Obstacles.alone()),
    SAVE_RIG(Texts.key("Save Light Rig…"), Texts.key("Write the scene's lights, banks and world to a file of their own"),
            "mdi2f-file-export-outline", "",
            Obstacles.alone()),

    TIMELINE(Texts.key("Timeline"), Texts.key("The shot's keys over its frames, below the pictures"), "mdi2c-chart-timeline", "F3",
            Obstacles.NONE),
    FILM_STRIP(Texts.key("Film Strip"), Texts.key("Small pictures of the frames below the keys, which follow every edit"),
            "mdi2f-filmstrip-box-multiple", "Shift+F3",
            Obstacles.NONE),
    NEW_SHOT(Texts.key("New Shot"), Texts.key("Give the scene frames, over which lights, camera and shapes can have keys"),
            "mdi2m-movie-open-plus-outline", "", Obstacles.alone(Obstacles::hasShot)),
    DELETE_SHOT(Texts.key("Delete Shot"), Texts.key("Take all keys away; the scene stays as this frame shows it"),
            "mdi2t-trash-can-outline", "", Obstacles.alone(Obstacles::noShot)),
    PLAY_SHOT(Texts.key("Play Shot"), Texts.key("Show the frames in real time, without those that there is no time for"),
            "mdi2p-play-outline", "Shortcut+P", Obstacles.alone(Obstacles::noShot)),
    FIRST_FRAME(Texts.key("First Frame"), Texts.key("Show the first frame of the shot"), "mdi2s-skip-previous-outline", "Shortcut+Home",
            Obstacles.alone(Obstacles::atFirstFrame)),
    PREVIOUS_FRAME(Texts.key("Previous Frame"), Texts.key("Show the frame before"), "mdi2s-step-backward", "Shortcut+Alt+LEFT",
            Obstacles.alone(Obstacles::atFirstFrame)),
    NEXT_FRAME(Texts.key("Next Frame"), Texts.key("Show the frame behind"), "mdi2s-step-forward", "Shortcut+Alt+RIGHT",
            Obstacles.alone(Obstacles::atLastFrame)),
    LAST_FRAME(Texts.key("Last Frame"), Texts.key("Show the last frame of the shot"), "mdi2s-skip-next-outline", "Shortcut+End",
            Obstacles.alone(Obstacles::atLastFrame)),
    PREVIOUS_KEY(Texts.key("Previous Key"), Texts.key("Show the frame of the nearest key before"), "mdi2c-chevron-left-circle-outline",
            "Shortcut+Alt+DOWN", Obstacles.alone(Obstacles::noKeyBefore)),
    NEXT_KEY(Texts.key("Next Key"), Texts.key("Show the frame of the nearest key behind"), "mdi2c-chevron-right-circle-outline",
            "Shortcut+Alt+UP", Obstacles.alone(Obstacles::noKeyBehind)),
    SET_KEY(Texts.key("Set Key"), Texts.key("Give all that has keys of the selected light, shape or camera a key at this frame"),
            "mdi2k-key-plus", "Shortcut+K", Obstacles.alone(Obstacles::nothingWithKeys)),
    KEY_PROPERTY(Texts.key("Key Property"), Texts.key("Give a property a key at this frame, its first one too"), "mdi2k-key-outline", "",
            Obstacles.alone()),
    UNKEY_PROPERTY(Texts.key("Remove Keys of Property"), Texts.key("Take all keys of a property away; it stays as this frame shows it"),
            "mdi2k-key-remove", "", Obstacles.alone()),
    DELETE_KEYS(Texts.key("Delete Keys"), Texts.key("Take the chosen keys of the timeline away"), "mdi2k-key-minus", "",
            Obstacles.alone(Obstacles::noKeyChosen)),
    LINEAR_KEYS(Texts.key("Linear"), Texts.key("Go evenly from the chosen keys to the next ones"), "mdi2v-vector-line", "",
            Obstacles.alone(Obstacles::noKeyChosen)),
    SMOOTH_KEYS(Texts.key("Smooth"), Texts.key("Go without a corner from the chosen keys to the next ones"), "mdi2v-vector-curve", "",
            Obstacles.alone(Obstacles::noKeyChosen)),
    STEPPED_KEYS(Texts.key("Stepped"), Texts.key("Stay as the chosen keys say until the next ones"), "mdi2s-stairs", "",
            Obstacles.alone(Obstacles::noKeyChosen)),

    EXPORT_SHOT(Texts.key("Export Shot…"), Texts.key("Render the frames as numbered pictures, or as a film where ffmpeg is installed"),
            "mdi2f-filmstrip", "", Obstacles.alone(Obstacles::noShot)),

    GO(Texts.key("Go"), Texts.key("Render the edits into the traced picture"), "mdi2p-play", "F5", Obstacles::nothingToRender),
    LIVE(Texts.key("Live"), Texts.key("Render edits while they are made, without Go"), "mdi2f-flash", "F8", Obstacles.NONE),
    UPDATE_REFLECTIONS(Texts.key("Update Reflections"),
            Texts.key("Make mirrors and clear materials show the lights that the picture shows"),
            "mdi2m-mirror", "F6",
            Obstacles::mirrorsAreCurrent),
    VERIFY(Texts.key("Verify"), Texts.key("Trace the picture in full in the background and compare"), "mdi2c-check-decagram-outline", "F7",
            Obstacles::noPicture),
    CANCEL(Texts.key("Cancel"), Texts.key("Stop what is being rendered, verified or read"), "mdi2s-stop", "Esc", Obstacles::nothingRuns),
    ACCURACY_PANEL(Texts.key("What Accuracy Costs…"), Texts.key("Each grade's time and error for the edit made last"),
            "mdi2c-chart-scatter-plot", "F9",
            Obstacles.NONE),
    UPDATES_PANEL(Texts.key("What This Update Did…"), Texts.key("The last updates of the picture: plan, rows, rays, time"),
            "mdi2t-timer-outline", "Shift+F7",
            Obstacles.NONE),
    EFFECTS_PANEL(Texts.key("Effects…"), Texts.key("What the scene calls for, and who calls for it; hide an effect from the view"),
            "mdi2l-layers-outline",
            "Shift+F9", Obstacles.NONE),
    ACCURACY(Texts.key("Accuracy"), Texts.key("How exact the picture is after an edit"), "mdi2t-target", "", Obstacles.NONE),
    PICTURE_SIZE(Texts.key("Size of the Picture"), Texts.key("How many pixels are traced; another size traces the picture anew"),
            "mdi2r-resize", "",
            Obstacles.NONE),
    ANTIALIAS(Texts.key("Anti-Aliasing"), Texts.key("Which pixels are the mean of several samples"), "mdi2b-blur", "", Obstacles.NONE),
    SAMPLES(Texts.key("Samples in a Pixel"), Texts.key("How many samples such a pixel has"), "mdi2g-grid", "", Obstacles::oneSample),

    ONLY_SELECTED(Texts.key("Only the Selected Light"),
            Texts.key("Show what it gives to the picture, in mirrors too: no ambience, no background"),
            "mdi2f-filter-outline", "Shortcut+I", Obstacles.NONE),
    SCOPES(Texts.key("Scopes…"), Texts.key("Histogram and waveform of the traced picture as it is shown"), "mdi2c-chart-histogram", "",
            Obstacles.NONE),
    CURVE(Texts.key("Display Curve"), Texts.key("How light becomes brightness on the screen"), "mdi2c-chart-bell-curve", "",
            Obstacles.NONE),
    COLOR_TABLE(Texts.key("Colour Table…"),
            Texts.key("Let what the display's curve gives pass a table of a .cube file; again takes it away"),
            "mdi2c-cube-outline", "", Obstacles.NONE),
    MARK_CLIPPING(Texts.key("Mark What Is Cut Off"), Texts.key("Mark pixels that are brighter than white or black"),
            "mdi2c-circle-off-outline",
            "Shortcut+Shift+K", Obstacles.NONE),
    SHADOWS(Texts.key("Shadows"), Texts.key("Show shadows in the traced picture"), "mdi2b-box-shadow", "", Obstacles.NONE),
    REFLECTIONS(Texts.key("Reflections"), Texts.key("Show mirrors in the traced picture"), "mdi2m-mirror", "", Obstacles.NONE),
    LIT_TEXTURES(Texts.key("Light on Textures"), Texts.key("Let lights fall on textures; else they glow, as in 1998"), "mdi2t-texture", "",
            Obstacles.NONE),
    TRACED_FIT(Texts.key("Fit Picture"), Texts.key("The whole picture. The wheel zooms, the middle button moves"),
            "mdi2f-fit-to-page-outline", "Shortcut+0",
            Obstacles.NONE),
    TRACED_ONE_TO_ONE(Texts.key("Actual Pixels"), Texts.key("One pixel of the picture is one of the screen's"),
            "mdi2n-numeric-1-box-outline", "Shortcut+1",
            Obstacles.NONE),
    TRACED_ZOOM_IN(Texts.key("Zoom In"), Texts.key("Show the picture larger"), "mdi2m-magnify-plus-outline", "Shortcut+EQUALS",
            Obstacles.NONE),
    TRACED_ZOOM_OUT(Texts.key("Zoom Out"), Texts.key("Show the picture smaller"), "mdi2m-magnify-minus-outline", "Shortcut+MINUS",
            Obstacles.NONE),
    REGION(Texts.key("Trace a Region"), Texts.key("Drag a frame in the picture; that part shows the edits that are not rendered yet"),
            "mdi2s-selection-drag",
            "Shortcut+B", Obstacles::notPlain),
    VIEW_X(Texts.key("Preview Along X"), Texts.key("Along the x axis (X)"), "mdi2a-axis-x-arrow", "Shortcut+F2", Obstacles.NONE),
    VIEW_Y(Texts.key("Preview from Above"), Texts.key("From above, along the negative y axis (Y)"), "mdi2a-axis-y-arrow", "Shortcut+F3",
            Obstacles.NONE),
    VIEW_Z(Texts.key("Reset the Preview"), Texts.key("Reset: the scene's own camera (Z)"), "mdi2a-axis-z-arrow", "Shortcut+F4",
            Obstacles.NONE),
    VIEW_ALL(Texts.key("Show All Lights"), Texts.key("Go back until all lights are in view (A)"), "mdi2a-arrow-expand-all", "Shortcut+F5",
            Obstacles.NONE),
    PREVIEW_SIZE(Texts.key("Size of the Preview"), Texts.key("How large the preview is drawn"), "mdi2r-resize", "", Obstacles.NONE),
    HIDE_GIZMOS(Texts.key("Hide the Gizmos"), Texts.key("While the lights' gizmos are hidden (G), the mouse takes no light"),
            "mdi2c-cone-off", "Shortcut+G",
            Obstacles.NONE),
    GIZMO_SIZE(Texts.key("Size of the Gizmos"), Texts.key("How large the lights' wireframes are drawn"), "mdi2c-cone", "", Obstacles.NONE),
    GLOWING_TEXTURES(Texts.key("Glowing Textures in the Preview, as in 1998"),
            Texts.key("Let textures glow in the preview, without light on them"),
            "mdi2t-texture", "", Obstacles.NONE),
    ARRANGEMENT(Texts.key("Arrange the Pictures"), Texts.key("Traced picture and preview side by side, one of them large, or one alone"),
            "mdi2v-view-split-vertical",
            "", Obstacles.NONE),
    HIDE_PANELS(Texts.key("Hide the Panels"), Texts.key("Pictures and menu alone; Tab over a picture does it too"),
            "mdi2f-fit-to-screen-outline", "Shift+F11",
            Obstacles.NONE),
    FULL_SCREEN(Texts.key("Full Screen"), Texts.key("The window on the whole screen"), "mdi2f-fullscreen", "F11", Obstacles.NONE),
    LIGHT_THEME(Texts.key("Light Theme"), Texts.key("Windows for bright rooms"), "mdi2w-white-balance-sunny", "", Obstacles.NONE),

    LANGUAGE(Texts.key("Language"), Texts.key("The language of menus and panels, from the next start on"), "mdi2t-translate", "",
            Obstacles.NONE),

    PALETTE(Texts.key("Find Command…"), Texts.key("All commands by a few letters of their names, with their keys"), "mdi2c-console-line",
            "Shortcut+Shift+P",
            Obstacles.NONE),
    KEYS(Texts.key("Mouse and Keyboard"), Texts.key("What mouse and keyboard do; give commands other keys"), "mdi2k-keyboard-outline", "F1",
            Obstacles.NONE),
    ABOUT(Texts.key("About Lightning"), Texts.key("What the program is"), "mdi2i-information-outline", "", Obstacles.NONE);

    private final String title;
    private final String help;
    private final String icon;
    private final String shortcut;
    private final Function<Situation, Optional<String>> obstacle;
    private final Function<Situation, Optional<String>> subject;

    Command(String title, String help, String icon, String shortcut, Function<Situation, Optional<String>> obstacle) {
        this(title, help, icon, shortcut, obstacle, _ -> Optional.empty());
    }

    Command(String title, String help, String icon, String shortcut, Function<Situation, Optional<String>> obstacle,
            Function<Situation, Optional<String>> subject) {
        this.title = title;
        this.help = help;
        this.icon = icon;
        this.shortcut = shortcut;
        this.obstacle = obstacle;
        this.subject = subject;
    }

    /** As menus have it; it ends in … where something is asked first. */
    public String title() {
        return Texts.of(title);
    }

    /** The title, and what it would act on where that changes: {@code Undo (intensity of key)}. */
    public String title(Situation s) {
        return title() + subject.apply(s).map(what -> " (" + what + ")").orElse("");
    }

    /** The title as buttons and tables have it, without the dots. */
    public String plainTitle() {
        return title().replace("…", "");
    }

    /** What it does, a sentence without a full stop. */
    public String help() {
        return Texts.of(help);
    }

    /** The icon's name in the set of Material Design. */
    public String icon() {
        return icon;
    }

    /** The key as the window toolkit reads it, {@code Shortcut+Shift+Z}; empty where there is none. */
    public String shortcut() {
        return shortcut;
    }

    /** How the parts of a window that show it are called: {@code go} for {@code GO}, {@code save-scene} for {@code SAVE_SCENE}. */
    public String id() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Whether the command has something to do. */
    public boolean isEnabled(Situation s) {
        return obstacle(s).isEmpty();
    }

    /** Why the command is disabled: a clause without a full stop; empty if it is enabled. */
    public Optional<String> obstacle(Situation s) {
        return obstacle.apply(s);
    }
}
