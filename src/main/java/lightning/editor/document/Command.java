package lightning.editor.document;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Messages;

/**
 * Everything that an artist can ask for: its words, its key, and why it has nothing to do now (paper §3.2 to §3.7). All
 * menus, and the buttons that do the same, are made of these; what one does says whoever can do it.
 */
public enum Command {
    NEW_SCENE(Messages.key("New Scene…"), Messages.key("Begin a scene: a ball on a floor, three lights, 1280 × 720 with smooth edges"),
            "mdi2f-file-plus-outline",
            "Shortcut+N", DisabledReasons.unlessAnimating()),
    LOAD_FILE(Messages.key("Load File…"), Messages.key("Open a scene, or make one of a glTF, OBJ, PLY or NFF file"),
            "mdi2f-folder-open-outline",
            "Shortcut+O",
            DisabledReasons.unlessAnimating()),
    LOAD_RECENT(Messages.key("Load Recent"), Messages.key("Open a scene that was open before"), "mdi2h-history", "",
            DisabledReasons.unlessAnimating()),
    RELOAD(Messages.key("Reload"), Messages.key("Start over with the file as it is on disk"), "mdi2r-reload", "Shortcut+R",
            DisabledReasons.unlessAnimating(DisabledReasons::sameAsOnDisk)),
    SAVE_SCENE(Messages.key("Save Scene"), Messages.key("Write the scene to its file"), "mdi2c-content-save-outline", "Shortcut+S",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingToSave)),
    SAVE_SCENE_AS(Messages.key("Save Scene As…"), Messages.key("Write the scene to another file"), "mdi2c-content-save-edit-outline",
            "Shortcut+Shift+S",
            DisabledReasons.unlessAnimating()),
    SAVE_IMAGE(Messages.key("Save Image…"), Messages.key("Write the traced picture to a file"), "mdi2i-image-outline", "Shortcut+E",
            DisabledReasons::noPicture),
    EXPORT(Messages.key("Export"), Messages.key("Write the picture for other programs: layers, floats, 16 bits"), "mdi2e-export-variant",
            "",
            DisabledReasons::noPicture),
    QUIT(Messages.key("Quit"), Messages.key("Close the window; it asks about edits that are not saved"), "mdi2e-exit-to-app", "Shortcut+Q",
            DisabledReasons.NONE),

    UNDO(Messages.key("Undo"), Messages.key("Take the last edit back"), "mdi2u-undo", "Shortcut+Z",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingToUndo),
            EditorState::undoLabel),
    REDO(Messages.key("Redo"), Messages.key("Do again what was undone"), "mdi2r-redo", "Shortcut+Shift+Z",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingToRedo), EditorState::redoLabel),
    UNDO_LIGHT(Messages.key("Undo Light"), Messages.key("Take back the last edit of the selected light alone"), "mdi2u-undo-variant",
            "Shortcut+Alt+Z",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingToUndoOfLight), EditorState::undoLightLabel),
    REDO_LIGHT(Messages.key("Redo Light"), Messages.key("Do again what was undone of the selected light alone"), "mdi2r-redo-variant",
            "Shortcut+Alt+Shift+Z",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingToRedoOfLight), EditorState::redoLightLabel),
    HISTORY_PANEL(Messages.key("Undo History…"),
            Messages.key("All edits as a list; a click goes there, for the document or for the selected light alone"),
            "mdi2h-history", "Shortcut+Alt+H", DisabledReasons.NONE),
    COPY_SETTINGS(Messages.key("Copy Settings"), Messages.key("Remember the selected light's settings"), "mdi2c-content-copy",
            "Shortcut+Shift+C",
            DisabledReasons::noLight),
    PASTE_SETTINGS(Messages.key("Paste Settings"), Messages.key("Give the selected light the settings that were copied"),
            "mdi2c-content-paste",
            "Shortcut+Shift+V",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingCopied)),
    COPY_PROPERTY(Messages.key("Copy Property"),
            Messages.key("Remember one property of a light, a material or a shape, as the scene file writes it"),
            "mdi2c-content-copy", "",
            DisabledReasons.NONE),
    PASTE_PROPERTY(Messages.key("Paste Property"),
            Messages.key("Give a light, a material or a shape the property that was copied, from wherever or from a text"),
            "mdi2c-content-paste", "", DisabledReasons.unlessAnimating()),
    RESET_PROPERTY(Messages.key("Reset Property"),
            Messages.key("Give a property of a light, a material or a shape the value that a new one has"),
            "mdi2r-restore", "",
            DisabledReasons.unlessAnimating()),
    PICK_MATERIAL(Messages.key("Edit Material…"),
            Messages.key("Pick a shape in the traced picture and edit its material; a right click on a shape offers it too"),
            "mdi2e-eyedropper", "Shortcut+Shift+M", DisabledReasons::noPicture),
    EDIT_MATERIAL(Messages.key("Edit Material of Shape"), Messages.key("Edit the material of the shape under the mouse"),
            "mdi2p-palette-outline",
            "", DisabledReasons.NONE),
    CHOOSE_TEXTURE(Messages.key("Choose Texture"), Messages.key("Give the material a picture that lies beside the scene"),
            "mdi2i-image-plus", "",
            DisabledReasons.NONE),

    CHOOSE_GOBO(Messages.key("Choose Gobo"), Messages.key("Let the light project a picture that lies beside the scene"), "mdi2p-projector",
            "",
            DisabledReasons.NONE),

    CHOOSE_ENVIRONMENT(Messages.key("Choose Environment"),
            Messages.key("Surround the scene with a picture that lies beside it, and light it by that"),
            "mdi2i-image-filter-hdr", "", DisabledReasons.NONE),

    SELECT_SHAPE(Messages.key("Select Shape"), Messages.key("Select the shape under the mouse, to place it"),
            "mdi2c-cursor-default-click-outline", "", DisabledReasons.NONE),
    SHOW_SHAPE(Messages.key("Hide or Show Shape"), Messages.key("Take the selected shape or group out of the picture, or bring it back"),
            "mdi2e-eye-off-outline", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noShape)),
    DUPLICATE_SHAPE(Messages.key("Duplicate Shape"), Messages.key("Add a shape or a group like the selected one beside it"),
            "mdi2c-content-duplicate", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noShapeOrTooManyShapes)),
    DELETE_SHAPE(Messages.key("Delete Shape"), Messages.key("Take the selected shape or group out of the scene"), "mdi2t-trash-can-outline",
            "",
            DisabledReasons.unlessAnimating(DisabledReasons::noShape)),
    RENAME_SHAPE(Messages.key("Rename Shape"), Messages.key("Give the selected shape or group another name"), "mdi2r-rename-box", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noShape)),
    CHOOSE_PROFILE(Messages.key("Choose Profile"), Messages.key("Let the light shine as an IES file tells that lies beside the scene"),
            "mdi2c-chart-bell-curve", "",
            DisabledReasons.NONE),

    LINK(Messages.key("Link Light and Shapes"),
            Messages.key("Choose which shapes and groups the light shines on, and which throw shadows in its light"),
            "mdi2l-link-variant", "", DisabledReasons::noLight),

    ADD_LIGHT(Messages.key("Add Light"), Messages.key("Add a light to the scene"), "mdi2l-lightbulb-on-outline", "Shortcut+L",
            DisabledReasons.unlessAnimating(DisabledReasons::tooManyLights)),
    DUPLICATE_LIGHT(Messages.key("Duplicate Light"), Messages.key("Add a light like the selected one"), "mdi2c-content-duplicate",
            "Shortcut+D",
            DisabledReasons.unlessAnimating(DisabledReasons::noLightOrTooManyLights)),
    DELETE_LIGHT(Messages.key("Delete Light"), Messages.key("Take the selected light out of the scene"), "mdi2t-trash-can-outline",
            "Shortcut+Delete",
            DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    RENAME_LIGHT(Messages.key("Rename Light"), Messages.key("Give the selected light another name"), "mdi2r-rename-box", "F2",
            DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    CHANGE_TYPE(Messages.key("Change Type"), Messages.key("Make the selected light a point, spot or directional light"),
            "mdi2s-shape-outline",
            "",
            DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    SWITCH_ON(Messages.key("Light On or Off"), Messages.key("Switch the selected light"), "mdi2p-power", "Shortcut+Shift+H",
            DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    SOLO(Messages.key("Solo"), Messages.key("Let the selected light shine alone"), "mdi2a-alpha-s-box-outline", "Shortcut+Shift+L",
            DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    NEW_BANK(Messages.key("New Bank"),
            Messages.key("Put the selected light into a bank of its own, whose master and gel act on all lights in it"),
            "mdi2t-tune-vertical", "", DisabledReasons.unlessAnimating(DisabledReasons::noLightOrTooManyGroups)),
    DELETE_BANK(Messages.key("Delete Bank"), Messages.key("Take the selected light's bank away; its lights stay"),
            "mdi2t-trash-can-outline", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noLightGroup)),
    LOOK_THROUGH_LIGHT(Messages.key("Look Through Light"), Messages.key("See the preview as the selected light does, and again as before"),
            "mdi2e-eye-outline",
            "Shortcut+Shift+T", DisabledReasons::noLight),
    AIM(Messages.key("Aim…"), Messages.key("Turn the selected light to a point of the traced picture, by a click or a drag of its pool"),
            "mdi2c-crosshairs-gps",
            "Shortcut+T",
            DisabledReasons.unlessAnimating(DisabledReasons::noDirection)),
    PLACE_HIGHLIGHT(Messages.key("Place Highlight…"),
            Messages.key("Move the selected light so that its highlight lies where you click or drag"),
            "mdi2f-flare",
            "Shortcut+Shift+G", DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    PLACE_DIFFUSE(Messages.key("Place Diffuse…"),
            Messages.key("Move the selected light so that it shines straight onto where you click or drag"),
            "mdi2c-circle-half-full", "Shortcut+Shift+F", DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    PLACE_RIM(Messages.key("Place Rim…"),
            Messages.key("Move the selected light behind a shape, so that a rim of light begins where you click or drag"),
            "mdi2w-weather-night", "Shortcut+Shift+R", DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    PLACE_SHADOW(Messages.key("Place Shadow…"),
            Messages.key("Move the selected light so that the shadow of a point falls where you click, or drag a shadow"),
            "mdi2b-box-shadow", "Shortcut+Shift+D", DisabledReasons.unlessAnimating(DisabledReasons::noLight)),
    MAKE_ANIMATION(Messages.key("Make Animation…"), Messages.key("Record and play the way of the selected light"),
            "mdi2m-movie-open-outline",
            "Shortcut+M",
            DisabledReasons.unlessAnimating(DisabledReasons::nothingToAnimate)),

    WAY_TO_KEYS(Messages.key("Way into Keys"),
            Messages.key("Let the selected light go the way of the open animation in the shot, from this frame on"),
            "mdi2m-movie-plus-outline", "", DisabledReasons::noMotionPath),
    KEYS_TO_WAY(Messages.key("Keys into Way…"),
            Messages.key("Make an animation of the keys that the selected light has of its place and direction"),
            "mdi2m-movie-cog-outline", "", DisabledReasons.unlessAnimating(DisabledReasons::noPositionKeys)),

    MIXER(Messages.key("Light Mixer…"),
            Messages.key("A strip for each light and bank: what it gives to the picture, fader, color, solo, mute"),
            "mdi2t-tune-vertical", "F4", DisabledReasons.NONE),

    CONTRIBUTIONS(Messages.key("Which Lights Matter…"),
            Messages.key("Each light's share of the picture, of a part and of a pixel; switch off what nobody sees"),
            "mdi2c-chart-bar", "Shortcut+F9", DisabledReasons.NONE),
    CUES(Messages.key("Cues…"), Messages.key("Keep how the scene is lit with its picture; restore, compare and blend"),
            "mdi2v-view-gallery-outline", "Shift+F4",
            DisabledReasons.NONE),
    LOAD_RIG(Messages.key("Load Light Rig…"), Messages.key("Let the lights and banks of a file take the place of the scene's"),
            "mdi2f-file-import-outline", "",
            DisabledReasons.unlessAnimating()),
    ADD_RIG(Messages.key("Add Light Rig…"), Messages.key("Add the lights and banks of a file to the scene's"), "mdi2f-file-plus-outline",
            "",
            DisabledReasons.unlessAnimating()),
    SAVE_RIG(Messages.key("Save Light Rig…"), Messages.key("Write the scene's lights, banks and world to a file of their own"),
            "mdi2f-file-export-outline", "",
            DisabledReasons.unlessAnimating()),

    TIMELINE(Messages.key("Timeline"), Messages.key("The shot's keys over its frames, below the pictures"), "mdi2c-chart-timeline", "F3",
            DisabledReasons.NONE),
    FILM_STRIP(Messages.key("Film Strip"), Messages.key("Small pictures of the frames below the keys, which follow every edit"),
            "mdi2f-filmstrip-box-multiple", "Shift+F3",
            DisabledReasons.NONE),
    NEW_SHOT(Messages.key("New Shot"), Messages.key("Give the scene frames, over which lights, camera and shapes can have keys"),
            "mdi2m-movie-open-plus-outline", "", DisabledReasons.unlessAnimating(DisabledReasons::hasShot)),
    DELETE_SHOT(Messages.key("Delete Shot"), Messages.key("Take all keys away; the scene stays as this frame shows it"),
            "mdi2t-trash-can-outline", "", DisabledReasons.unlessAnimating(DisabledReasons::noShot)),
    PLAY_SHOT(Messages.key("Play Shot"), Messages.key("Show the frames in real time, without those that there is no time for"),
            "mdi2p-play-outline", "Shortcut+P", DisabledReasons.unlessAnimating(DisabledReasons::noShot)),
    FIRST_FRAME(Messages.key("First Frame"), Messages.key("Show the first frame of the shot"), "mdi2s-skip-previous-outline",
            "Shortcut+Home",
            DisabledReasons.unlessAnimating(DisabledReasons::atFirstFrame)),
    PREVIOUS_FRAME(Messages.key("Previous Frame"), Messages.key("Show the frame before"), "mdi2s-step-backward", "Shortcut+Alt+LEFT",
            DisabledReasons.unlessAnimating(DisabledReasons::atFirstFrame)),
    NEXT_FRAME(Messages.key("Next Frame"), Messages.key("Show the frame behind"), "mdi2s-step-forward", "Shortcut+Alt+RIGHT",
            DisabledReasons.unlessAnimating(DisabledReasons::atLastFrame)),
    LAST_FRAME(Messages.key("Last Frame"), Messages.key("Show the last frame of the shot"), "mdi2s-skip-next-outline", "Shortcut+End",
            DisabledReasons.unlessAnimating(DisabledReasons::atLastFrame)),
    PREVIOUS_KEY(Messages.key("Previous Key"), Messages.key("Show the frame of the nearest key before"),
            "mdi2c-chevron-left-circle-outline",
            "Shortcut+Alt+DOWN", DisabledReasons.unlessAnimating(DisabledReasons::noKeyBefore)),
    NEXT_KEY(Messages.key("Next Key"), Messages.key("Show the frame of the nearest key behind"), "mdi2c-chevron-right-circle-outline",
            "Shortcut+Alt+UP", DisabledReasons.unlessAnimating(DisabledReasons::noKeyAfter)),
    SET_KEY(Messages.key("Set Key"), Messages.key("Give all that has keys of the selected light, shape or camera a key at this frame"),
            "mdi2k-key-plus", "Shortcut+K", DisabledReasons.unlessAnimating(DisabledReasons::nothingWithKeys)),
    KEY_PROPERTY(Messages.key("Key Property"), Messages.key("Give a property a key at this frame, its first one too"), "mdi2k-key-outline",
            "",
            DisabledReasons.unlessAnimating()),
    UNKEY_PROPERTY(Messages.key("Remove Keys of Property"),
            Messages.key("Take all keys of a property away; it stays as this frame shows it"),
            "mdi2k-key-remove", "", DisabledReasons.unlessAnimating()),
    DELETE_KEYS(Messages.key("Delete Keys"), Messages.key("Take the chosen keys of the timeline away"), "mdi2k-key-minus", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noKeySelected)),
    LINEAR_KEYS(Messages.key("Linear"), Messages.key("Go evenly from the chosen keys to the next ones"), "mdi2v-vector-line", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noKeySelected)),
    SMOOTH_KEYS(Messages.key("Smooth"), Messages.key("Go without a corner from the chosen keys to the next ones"), "mdi2v-vector-curve", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noKeySelected)),
    STEPPED_KEYS(Messages.key("Stepped"), Messages.key("Stay as the chosen keys say until the next ones"), "mdi2s-stairs", "",
            DisabledReasons.unlessAnimating(DisabledReasons::noKeySelected)),

    EXPORT_SHOT(Messages.key("Export Shot…"),
            Messages.key("Render the frames as numbered pictures, or as a film where ffmpeg is installed"),
            "mdi2f-filmstrip", "", DisabledReasons.unlessAnimating(DisabledReasons::noShot)),

    GO(Messages.key("Go"), Messages.key("Render the edits into the traced picture"), "mdi2p-play", "F5", DisabledReasons::nothingToRender),
    LIVE(Messages.key("Live"), Messages.key("Render edits while they are made, without Go"), "mdi2f-flash", "F8", DisabledReasons.NONE),
    UPDATE_REFLECTIONS(Messages.key("Update Reflections"),
            Messages.key("Make mirrors and clear materials show the lights that the picture shows"),
            "mdi2m-mirror", "F6",
            DisabledReasons::mirrorsAreCurrent),
    VERIFY(Messages.key("Verify"), Messages.key("Trace the picture in full in the background and compare"), "mdi2c-check-decagram-outline",
            "F7",
            DisabledReasons::noPicture),
    CANCEL(Messages.key("Cancel"), Messages.key("Stop what is being rendered, verified or read"), "mdi2s-stop", "Esc",
            DisabledReasons::nothingRuns),
    ACCURACY_PANEL(Messages.key("What Accuracy Costs…"), Messages.key("Each grade's time and error for the edit made last"),
            "mdi2c-chart-scatter-plot", "F9",
            DisabledReasons.NONE),
    UPDATES_PANEL(Messages.key("What This Update Did…"), Messages.key("The last updates of the picture: plan, rows, rays, time"),
            "mdi2t-timer-outline", "Shift+F7",
            DisabledReasons.NONE),
    EFFECTS_PANEL(Messages.key("Effects…"), Messages.key("What the scene calls for, and who calls for it; hide an effect from the view"),
            "mdi2l-layers-outline",
            "Shift+F9", DisabledReasons.NONE),
    ACCURACY(Messages.key("Accuracy"), Messages.key("How exact the picture is after an edit"), "mdi2t-target", "", DisabledReasons.NONE),
    PICTURE_SIZE(Messages.key("Size of the Picture"), Messages.key("How many pixels are traced; another size traces the picture anew"),
            "mdi2r-resize", "",
            DisabledReasons.NONE),
    ANTIALIAS(Messages.key("Anti-Aliasing"), Messages.key("Which pixels are the mean of several samples"), "mdi2b-blur", "",
            DisabledReasons.NONE),
    SAMPLES(Messages.key("Samples in a Pixel"), Messages.key("How many samples such a pixel has"), "mdi2g-grid", "",
            DisabledReasons::singleSample),

    ONLY_SELECTED(Messages.key("Only the Selected Light"),
            Messages.key("Show what it gives to the picture, in mirrors too: no ambience, no background"),
            "mdi2f-filter-outline", "Shortcut+I", DisabledReasons.NONE),
    SCOPES(Messages.key("Scopes…"), Messages.key("Histogram and waveform of the traced picture as it is shown"), "mdi2c-chart-histogram",
            "",
            DisabledReasons.NONE),
    CURVE(Messages.key("Display Curve"), Messages.key("How light becomes brightness on the screen"), "mdi2c-chart-bell-curve", "",
            DisabledReasons.NONE),
    COLOR_TABLE(Messages.key("Color Table…"),
            Messages.key("Let what the display's curve gives pass a table of a .cube file; again takes it away"),
            "mdi2c-cube-outline", "", DisabledReasons.NONE),
    MARK_CLIPPING(Messages.key("Mark What Is Cut Off"), Messages.key("Mark pixels that are brighter than white or black"),
            "mdi2c-circle-off-outline",
            "Shortcut+Shift+K", DisabledReasons.NONE),
    SHADOWS(Messages.key("Shadows"), Messages.key("Show shadows in the traced picture"), "mdi2b-box-shadow", "", DisabledReasons.NONE),
    REFLECTIONS(Messages.key("Reflections"), Messages.key("Show mirrors in the traced picture"), "mdi2m-mirror", "", DisabledReasons.NONE),
    LIT_TEXTURES(Messages.key("Light on Textures"), Messages.key("Let lights fall on textures; else they glow, as in 1998"),
            "mdi2t-texture", "",
            DisabledReasons.NONE),
    TRACED_FIT(Messages.key("Fit Picture"), Messages.key("The whole picture. The wheel zooms, the middle button moves"),
            "mdi2f-fit-to-page-outline", "Shortcut+0",
            DisabledReasons.NONE),
    TRACED_ONE_TO_ONE(Messages.key("Actual Pixels"), Messages.key("One pixel of the picture is one of the screen's"),
            "mdi2n-numeric-1-box-outline", "Shortcut+1",
            DisabledReasons.NONE),
    TRACED_ZOOM_IN(Messages.key("Zoom In"), Messages.key("Show the picture larger"), "mdi2m-magnify-plus-outline", "Shortcut+EQUALS",
            DisabledReasons.NONE),
    TRACED_ZOOM_OUT(Messages.key("Zoom Out"), Messages.key("Show the picture smaller"), "mdi2m-magnify-minus-outline", "Shortcut+MINUS",
            DisabledReasons.NONE),
    REGION(Messages.key("Trace a Region"), Messages.key("Drag a frame in the picture; that part shows the edits that are not rendered yet"),
            "mdi2s-selection-drag",
            "Shortcut+B", DisabledReasons::notFullPicture),
    VIEW_X(Messages.key("Preview Along X"), Messages.key("Along the x axis (X)"), "mdi2a-axis-x-arrow", "Shortcut+F2",
            DisabledReasons.NONE),
    VIEW_Y(Messages.key("Preview from Above"), Messages.key("From above, along the negative y axis (Y)"), "mdi2a-axis-y-arrow",
            "Shortcut+F3",
            DisabledReasons.NONE),
    VIEW_Z(Messages.key("Reset the Preview"), Messages.key("Reset: the scene's own camera (Z)"), "mdi2a-axis-z-arrow", "Shortcut+F4",
            DisabledReasons.NONE),
    VIEW_ALL(Messages.key("Show All Lights"), Messages.key("Go back until all lights are in view (A)"), "mdi2a-arrow-expand-all",
            "Shortcut+F5",
            DisabledReasons.NONE),
    PREVIEW_SIZE(Messages.key("Size of the Preview"), Messages.key("How large the preview is drawn"), "mdi2r-resize", "",
            DisabledReasons.NONE),
    HIDE_GIZMOS(Messages.key("Hide the Gizmos"), Messages.key("While the lights' gizmos are hidden (G), the mouse takes no light"),
            "mdi2c-cone-off", "Shortcut+G",
            DisabledReasons.NONE),
    GIZMO_SIZE(Messages.key("Size of the Gizmos"), Messages.key("How large the lights' wireframes are drawn"), "mdi2c-cone", "",
            DisabledReasons.NONE),
    GLOWING_TEXTURES(Messages.key("Glowing Textures in the Preview, as in 1998"),
            Messages.key("Let textures glow in the preview, without light on them"),
            "mdi2t-texture", "", DisabledReasons.NONE),
    ARRANGEMENT(Messages.key("Arrange the Pictures"),
            Messages.key("Traced picture and preview side by side, one of them large, or one alone"),
            "mdi2v-view-split-vertical",
            "", DisabledReasons.NONE),
    HIDE_PANELS(Messages.key("Hide the Panels"), Messages.key("Pictures and menu alone; Tab over a picture does it too"),
            "mdi2f-fit-to-screen-outline", "Shift+F11",
            DisabledReasons.NONE),
    FULL_SCREEN(Messages.key("Full Screen"), Messages.key("The window on the whole screen"), "mdi2f-fullscreen", "F11",
            DisabledReasons.NONE),
    LIGHT_THEME(Messages.key("Light Theme"), Messages.key("Windows for bright rooms"), "mdi2w-white-balance-sunny", "",
            DisabledReasons.NONE),

    LANGUAGE(Messages.key("Language"), Messages.key("The language of menus and panels, from the next start on"), "mdi2t-translate", "",
            DisabledReasons.NONE),

    PALETTE(Messages.key("Find Command…"), Messages.key("All commands by a few letters of their names, with their keys"),
            "mdi2c-console-line",
            "Shortcut+Shift+P",
            DisabledReasons.NONE),
    KEYS(Messages.key("Mouse and Keyboard"), Messages.key("What mouse and keyboard do; give commands other keys"), "mdi2k-keyboard-outline",
            "F1",
            DisabledReasons.NONE),
    ABOUT(Messages.key("About Lightning"), Messages.key("What the program is"), "mdi2i-information-outline", "", DisabledReasons.NONE);

    private final String title;
    private final String help;
    private final String icon;
    private final String shortcut;
    private final Function<EditorState, Optional<String>> disabledReason;
    private final Function<EditorState, Optional<String>> subject;

    Command(String title, String help, String icon, String shortcut, Function<EditorState, Optional<String>> disabledReason) {
        this(title, help, icon, shortcut, disabledReason, _ -> Optional.empty());
    }

    Command(String title, String help, String icon, String shortcut, Function<EditorState, Optional<String>> disabledReason,
            Function<EditorState, Optional<String>> subject) {
        this.title = title;
        this.help = help;
        this.icon = icon;
        this.shortcut = shortcut;
        this.disabledReason = disabledReason;
        this.subject = subject;
    }

    /** As menus have it; it ends in … where something is asked first. */
    public String title() {
        return Messages.tr(title);
    }

    /** The title, and what it would act on where that changes: {@code Undo (intensity of key)}. */
    public String title(EditorState s) {
        return title() + subject.apply(s).map(what -> " (" + what + ")").orElse("");
    }

    /** The title as buttons and tables have it, without the dots. */
    public String plainTitle() {
        return title().replace("…", "");
    }

    /** What it does, a sentence without a full stop. */
    public String help() {
        return Messages.tr(help);
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
    public boolean isEnabled(EditorState s) {
        return disabledReason(s).isEmpty();
    }

    /** Why the command is disabled: a clause without a full stop; empty if it is enabled. */
    public Optional<String> disabledReason(EditorState s) {
        return disabledReason.apply(s);
    }
}
