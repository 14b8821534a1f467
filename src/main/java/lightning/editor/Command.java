package lightning.editor;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Messages;

/**
 * Commands of the editor, with titles, tooltips, shortcuts and reasons for being disabled (paper §3.2 to §3.7). All menus and their buttons
 * use them; the actions are implemented elsewhere.
 */
public enum Command {
    NEW_SCENE(Messages.key("New Scene"), Messages.key("New studio with a cyclorama, soft key, fill and rim lights, and a sky"),
            "mdi2f-file-plus-outline", "Shortcut+N"),
    WELCOME(Messages.key("Welcome"), Messages.key("Show scenes, recent files and lessons next to the picture"), "mdi2h-home-outline"),
    LOAD_FILE(Messages.key("Open…"), Messages.key("Open a scene, or import a glTF, USD, OBJ, PLY, NFF, FBX or other file"),
            "mdi2f-folder-open-outline",
            "Shortcut+O"),
    LOAD_RECENT(Messages.key("Open Recent"), Messages.key("Open a recent scene"), "mdi2h-history"),
    RELOAD(Messages.key("Reload"), Messages.key("Revert to the saved file"), "mdi2r-reload", "Shortcut+R",
            DisabledReasons::sameAsOnDisk),
    RECOVER(Messages.key("Recover…"), Messages.key("Open unsaved changes of an editor that closed unexpectedly"), "mdi2b-backup-restore"),
    SAVE_SCENE(Messages.key("Save Scene"), Messages.key("Save the scene to its file"), "mdi2c-content-save-outline", "Shortcut+S",
            DisabledReasons::nothingToSave),
    SAVE_SCENE_AS(Messages.key("Save Scene As…"), Messages.key("Save the scene to another file"), "mdi2c-content-save-edit-outline",
            "Shortcut+Shift+S"),
    SAVE_IMAGE(Messages.key("Save Image…"), Messages.key("Save the rendered image to a file"), "mdi2i-image-outline", "Shortcut+E",
            DisabledReasons::noPicture),
    EXPORT(Messages.key("Export"), Messages.key("Export the image with layers, as floats or with 16 bits"), "mdi2e-export-variant", "",
            DisabledReasons::noPicture),
    OPEN_REVIEW(Messages.key("Open Review…"), Messages.key("Light the scene as a reviewer did in its page, and show the notes"),
            "mdi2c-comment-text-outline"),
    LIVE_REVIEW(Messages.key("Live Review…"),
            Messages.key("Show the picture in browsers while you work, with a fader for each light"), "mdi2c-cast", ""),
    QUIT(Messages.key("Quit"), Messages.key("Close Lightning, after a prompt for unsaved changes"), "mdi2e-exit-to-app", "Shortcut+Q"),

    UNDO(Messages.key("Undo"), Messages.key("Undo the last edit"), "mdi2u-undo", "Shortcut+Z",
            DisabledReasons::nothingToUndo, EditorState::undoLabel),
    REDO(Messages.key("Redo"), Messages.key("Redo the last undone edit"), "mdi2r-redo", "Shortcut+Shift+Z",
            DisabledReasons::nothingToRedo, EditorState::redoLabel),
    UNDO_LIGHT(Messages.key("Undo Light"), Messages.key("Undo the last edit of the selected light only"), "mdi2u-undo-variant",
            "Shortcut+Alt+Z", DisabledReasons::nothingToUndoOfLight, EditorState::undoLightLabel),
    REDO_LIGHT(Messages.key("Redo Light"), Messages.key("Redo the last undone edit of the selected light only"), "mdi2r-redo-variant",
            "Shortcut+Alt+Shift+Z", DisabledReasons::nothingToRedoOfLight, EditorState::redoLightLabel),
    HISTORY_PANEL(Messages.key("Undo History…"), Messages.key("List all edits of the scene or the selected light, and jump to one"),
            "mdi2h-history", "Shortcut+Alt+H"),
    COPY_SETTINGS(Messages.key("Copy Settings"), Messages.key("Copy the settings of the selected light"), "mdi2c-content-copy",
            "Shortcut+Shift+C", DisabledReasons::noLight),
    PASTE_SETTINGS(Messages.key("Paste Settings"), Messages.key("Apply the copied settings to the selected light"), "mdi2c-content-paste",
            "Shortcut+Shift+V", DisabledReasons::nothingCopied),
    COPY_PROPERTY(Messages.key("Copy Property"), Messages.key("Copy a property of a light, material or object as text"),
            "mdi2c-content-copy"),
    PASTE_PROPERTY(Messages.key("Paste Property"), Messages.key("Paste a copied property to a light, material or object"),
            "mdi2c-content-paste"),
    RESET_PROPERTY(Messages.key("Reset Property"), Messages.key("Reset a property of a light, material or object to its default"),
            "mdi2r-restore"),
    PICK_MATERIAL(Messages.key("Edit Material…"), Messages.key("Pick an object in the render and edit its material"), "mdi2e-eyedropper",
            "Shortcut+Shift+M", DisabledReasons::noPicture),
    EDIT_MATERIAL(Messages.key("Edit Material of Object"), Messages.key("Edit the material of the object under the cursor"),
            "mdi2p-palette-outline"),
    CHOOSE_TEXTURE(Messages.key("Choose Texture"), Messages.key("Apply an image from the scene's folder to the material"),
            "mdi2i-image-plus"),

    CHOOSE_GOBO(Messages.key("Choose Gobo"), Messages.key("Project an image from the scene's folder with the light (gobo)"),
            "mdi2p-projector"),

    CHOOSE_LIGHT_TEXTURE(Messages.key("Choose Light Texture"), Messages.key("Show an image from the scene's folder on the light's face"),
            "mdi2t-television"),

    CHOOSE_ENVIRONMENT(Messages.key("Choose Environment"), Messages.key("Light the scene with an environment image from its folder"),
            "mdi2i-image-filter-hdr"),

    EDIT_WORLD(Messages.key("Edit World"), Messages.key("Show environment, ambient and indirect light, background and view"), "mdi2e-earth",
            "Shift+F2"),

    SELECT_SHAPE(Messages.key("Select Object"), Messages.key("Select the object under the cursor"), "mdi2c-cursor-default-click-outline"),
    HIDE_SHAPE(Messages.key("Hide Object"), Messages.key("Hide the object under the cursor"), "mdi2e-eye-off-outline"),
    SHOW_SHAPE(Messages.key("Show/Hide Object"), Messages.key("Show or hide the selected object or group"), "mdi2e-eye-off-outline", "",
            DisabledReasons::noShape),
    DUPLICATE_SHAPE(Messages.key("Duplicate Object"), Messages.key("Duplicate the selected object or group"), "mdi2c-content-duplicate", "",
            DisabledReasons::noShapeOrTooManyShapes),
    DELETE_SHAPE(Messages.key("Delete Object"), Messages.key("Delete the selected object or group"), "mdi2t-trash-can-outline", "",
            DisabledReasons::noShape),
    MAKE_LIGHT(Messages.key("Make It a Light"), Messages.key("Make the selected object a light, as bright as its glow"),
            "mdi2l-lightbulb-on-outline", "", DisabledReasons::noShape),
    LIGHTS_OF_GLOW(Messages.key("Make Glowing Objects Lights"), Messages.key("Make every object that glows a light, as bright as its glow"),
            "mdi2l-lightbulb-group-outline", "", DisabledReasons::nothingGlows),
    RENAME_SHAPE(Messages.key("Rename Object"), Messages.key("Rename the selected object or group"), "mdi2r-rename-box", "",
            DisabledReasons::noShape),
    CHOOSE_PROFILE(Messages.key("Choose IES Profile"), Messages.key("Apply an IES profile from the scene's folder to the light"),
            "mdi2c-chart-bell-curve"),

    LINK(Messages.key("Edit Light Linking"), Messages.key("Choose which objects the light illuminates and which cast its shadows"),
            "mdi2l-link-variant", "", DisabledReasons::noLight),

    SELECT_LIGHT(Messages.key("Select Light"), Messages.key("Select a light by its share of the light under the cursor"),
            "mdi2l-lightbulb-on-outline"),
    ADD_LIGHT(Messages.key("Add Light"), Messages.key("Add a light to the scene"), "mdi2l-lightbulb-on-outline", "Shortcut+L",
            DisabledReasons::tooManyLights),
    ADD_BLOCKER(Messages.key("Add Blocker"), Messages.key("Add a card that blocks light and is not seen, between the light and the scene"),
            "mdi2c-card-outline", "", DisabledReasons::tooManyShapes),
    DUPLICATE_LIGHT(Messages.key("Duplicate Light"), Messages.key("Duplicate the selected light"), "mdi2c-content-duplicate", "Shortcut+D",
            DisabledReasons::noLightOrTooManyLights),
    DELETE_LIGHT(Messages.key("Delete Light"), Messages.key("Delete the selected light"), "mdi2t-trash-can-outline", "Shortcut+Delete",
            DisabledReasons::noLight),
    RENAME_LIGHT(Messages.key("Rename Light"), Messages.key("Rename the selected light"), "mdi2r-rename-box", "F2",
            DisabledReasons::noLight),
    CHANGE_TYPE(Messages.key("Change Light Type"), Messages.key("Change the type of the selected light"), "mdi2s-shape-outline", "",
            DisabledReasons::noLight),
    SWITCH_ON(Messages.key("Toggle Light"), Messages.key("Switch the light on or off"), "mdi2p-power", "Shortcut+Shift+H",
            DisabledReasons::noLight),
    SOLO(Messages.key("Solo"), Messages.key("Mute all lights that are not solo"), "mdi2a-alpha-s-box-outline", "Shortcut+Shift+L",
            DisabledReasons::noLight),
    NEW_LIGHT_GROUP(Messages.key("New Light Group"),
            Messages.key("Put the selected light into a new light group with its own master and gel"),
            "mdi2t-tune-vertical", "", DisabledReasons::noLightOrTooManyGroups),
    DELETE_LIGHT_GROUP(Messages.key("Delete Light Group"), Messages.key("Delete the selected light's group and keep its lights"),
            "mdi2t-trash-can-outline", "", DisabledReasons::noLightGroup),
    LOOK_THROUGH_LIGHT(Messages.key("Look Through Light"),
            Messages.key("Show the preview from the selected light, or from the camera again"), "mdi2e-eye-outline", "Shortcut+Shift+T",
            DisabledReasons::noPlacedLight),
    AIM(Messages.key("Aim Light…"), Messages.key("Click a point in the render to aim at, or drag the spot"), "mdi2c-crosshairs-gps",
            "Shortcut+T", DisabledReasons::noDirection),
    PLACE_HIGHLIGHT(Messages.key("Place Highlight…"), Messages.key("Click or drag where the highlight should be"), "mdi2f-flare",
            "Shortcut+Shift+G", DisabledReasons::noPlacedLight),
    PLACE_DIFFUSE(Messages.key("Point at Surface…"), Messages.key("Click or drag where the light should hit the surface head-on"),
            "mdi2c-circle-half-full", "Shortcut+Shift+F", DisabledReasons::noPlacedLight),
    PLACE_RIM(Messages.key("Place Rim Light…"), Messages.key("Click or drag where the rim light should start"), "mdi2w-weather-night",
            "Shortcut+Shift+R", DisabledReasons::noPlacedLight),
    PLACE_SHADOW(Messages.key("Place Shadow…"), Messages.key("Click an object and where its shadow should fall, or drag a shadow"),
            "mdi2b-box-shadow", "Shortcut+Shift+D", DisabledReasons::noPlacedLight),
    PLACE_FLAG(Messages.key("Place Flag…"), Messages.key("Click or drag where the light's flag should block it"),
            "mdi2f-flag-outline", "", DisabledReasons::noPlacedLight),
    FOCUS(Messages.key("Focus"), Messages.key("Focus the camera on the point under the cursor; a pinhole is opened"),
            "mdi2i-image-filter-center-focus"),
    MAKE_ANIMATION(Messages.key("Make Animation"), Messages.key("Record the selected light's movement into the shot; again to stop"),
            "mdi2r-record-circle-outline", "Shortcut+M", DisabledReasons::noPlacedLight),

    WAY_TO_KEYS(Messages.key("Convert Path to Keyframes…"),
            Messages.key("Add a motion path file to the shot as keyframes of the selected light, from this frame"),
            "mdi2m-movie-plus-outline",
            "", DisabledReasons::noPlacedLight),
    KEYS_TO_WAY(Messages.key("Convert Keyframes to Path…"),
            Messages.key("Save the selected light's position and direction keyframes as a motion path file"), "mdi2m-movie-cog-outline", "",
            DisabledReasons::noPositionKeys),

    MIXER(Messages.key("Light Mixer…"), Messages.key("Mix lights and light groups with faders, color, solo and mute"),
            "mdi2t-tune-vertical", "F4"),

    CONTRIBUTIONS(Messages.key("Light Contributions…"), Messages.key("Show each light's share of the image, a region or a pixel"),
            "mdi2c-chart-bar", "Shift+F5"),
    MATCH_REFERENCE(Messages.key("Match Reference…"),
            Messages.key("Set the lights so that the picture resembles an image, or a painted wish"),
            "mdi2i-image-search-outline", "Shift+F6"),
    LIGHT_LINKS(Messages.key("Light Links…"), Messages.key("Choose which lights illuminate which objects, and with which gain"),
            "mdi2g-grid", "Shift+F8"),
    LOOKS(Messages.key("Looks…"), Messages.key("Save, apply, compare and blend looks of the scene"), "mdi2v-view-gallery-outline",
            "Shift+F4"),
    LOAD_RIG(Messages.key("Import Light Rig…"), Messages.key("Replace the scene's lights and light groups with those of a file"),
            "mdi2f-file-import-outline"),
    ADD_RIG(Messages.key("Add Light Rig…"), Messages.key("Add the lights and light groups of a file to the scene"),
            "mdi2f-file-plus-outline"),
    SAVE_RIG(Messages.key("Export Light Rig…"), Messages.key("Export the scene's lights, light groups and environment to a file"),
            "mdi2f-file-export-outline"),

    TIMELINE(Messages.key("Timeline"), Messages.key("Show the shot's keyframes below the views"), "mdi2c-chart-timeline", "F3"),
    SEQUENCE(Messages.key("Sequence…"), Messages.key("Light several shots with one rig, on a contact sheet"), "mdi2v-view-grid-outline",
            ""),
    FILM_STRIP(Messages.key("Filmstrip"), Messages.key("Show a thumbnail of each frame, updated with every edit"),
            "mdi2f-filmstrip-box-multiple", "Shift+F3"),
    NEW_SHOT(Messages.key("New Shot"), Messages.key("Add a shot with frames, to animate lights, camera and objects"),
            "mdi2m-movie-open-plus-outline", "", DisabledReasons::hasShot),
    DELETE_SHOT(Messages.key("Delete Shot"), Messages.key("Delete all keyframes and keep the scene of this frame"),
            "mdi2t-trash-can-outline", "", DisabledReasons::noShot),
    PLAY_SHOT(Messages.key("Play Shot"), Messages.key("Play the shot in real time, dropping frames if needed"), "mdi2p-play-outline",
            "Shortcut+P", DisabledReasons::noShot),
    FIRST_FRAME(Messages.key("First Frame"), Messages.key("Go to the first frame"), "mdi2s-skip-previous-outline", "Shortcut+Home",
            DisabledReasons::atFirstFrame),
    PREVIOUS_FRAME(Messages.key("Previous Frame"), Messages.key("Go to the previous frame"), "mdi2s-step-backward", "Shortcut+COMMA",
            DisabledReasons::atFirstFrame),
    NEXT_FRAME(Messages.key("Next Frame"), Messages.key("Go to the next frame"), "mdi2s-step-forward", "Shortcut+PERIOD",
            DisabledReasons::atLastFrame),
    LAST_FRAME(Messages.key("Last Frame"), Messages.key("Go to the last frame"), "mdi2s-skip-next-outline", "Shortcut+End",
            DisabledReasons::atLastFrame),
    PREVIOUS_KEY(Messages.key("Previous Keyframe"), Messages.key("Go to the previous keyframe"), "mdi2c-chevron-left-circle-outline",
            "Shortcut+Shift+COMMA", DisabledReasons::noKeyBefore),
    NEXT_KEY(Messages.key("Next Keyframe"), Messages.key("Go to the next keyframe"), "mdi2c-chevron-right-circle-outline",
            "Shortcut+Shift+PERIOD", DisabledReasons::noKeyAfter),
    SET_KEY(Messages.key("Set Keyframe"), Messages.key("Set keyframes at this frame for the animated properties of the selection"),
            "mdi2k-key-plus", "Shortcut+K", DisabledReasons::nothingWithKeys),
    KEY_PROPERTY(Messages.key("Set Keyframe of Property"), Messages.key("Set a keyframe of a property at this frame"), "mdi2k-key-outline"),
    UNKEY_PROPERTY(Messages.key("Clear Keyframes of Property"),
            Messages.key("Delete all keyframes of a property and keep its value at this frame"), "mdi2k-key-remove"),
    DELETE_KEYS(Messages.key("Delete Keyframes"), Messages.key("Delete the selected keyframes"), "mdi2k-key-minus", "",
            DisabledReasons::noKeySelected),
    LINEAR_KEYS(Messages.key("Linear"), Messages.key("Interpolate linearly from the selected keyframes"), "mdi2v-vector-line", "",
            DisabledReasons::noKeySelected),
    SMOOTH_KEYS(Messages.key("Smooth"), Messages.key("Interpolate smoothly from the selected keyframes"), "mdi2v-vector-curve", "",
            DisabledReasons::noKeySelected),
    STEPPED_KEYS(Messages.key("Hold"), Messages.key("Hold the value of the selected keyframes until the next ones"), "mdi2s-stairs", "",
            DisabledReasons::noKeySelected),

    EXPORT_SHOT(Messages.key("Export Shot…"), Messages.key("Render the shot to numbered images, or to a video (needs ffmpeg)"),
            "mdi2f-filmstrip", "", DisabledReasons::noShot),

    GO(Messages.key("Render"), Messages.key("Render pending edits"), "mdi2p-play", "F5", DisabledReasons::nothingToRender),
    LIVE(Messages.key("Live"), Messages.key("Update while you edit"), "mdi2f-flash", "F8"),
    UPDATE_REFLECTIONS(Messages.key("Update Reflections"),
            Messages.key("Update reflections and transparent materials to the current lights"), "mdi2m-mirror", "F6",
            DisabledReasons::mirrorsAreCurrent),
    VERIFY(Messages.key("Verify"), Messages.key("Compare the image with a full trace, in the background"), "mdi2c-check-decagram-outline",
            "F7", DisabledReasons::noPicture),
    CANCEL(Messages.key("Cancel"), Messages.key("Cancel the current render, verification or load"), "mdi2s-stop", "Esc",
            DisabledReasons::nothingRuns),
    ACCURACY_PANEL(Messages.key("Accuracy and Time…"), Messages.key("Show time and error of each accuracy setting for the last edit"),
            "mdi2c-chart-scatter-plot", "F9"),
    UPDATES_PANEL(Messages.key("Render Log…"), Messages.key("List the last updates with their changes, rays and times"),
            "mdi2t-timer-outline", "Shift+F7"),
    EFFECTS_PANEL(Messages.key("Effects…"), Messages.key("List the effects in use and hide them in the view"), "mdi2l-layers-outline",
            "Shift+F9"),
    ACCURACY(Messages.key("Accuracy"), Messages.key("Accuracy of the image after an edit"), "mdi2t-target"),
    WORKING_SIZE(Messages.key("Working Size"), Messages.key("Choose the size in which the image is traced while you work"),
            "mdi2f-fit-to-screen-outline"),
    PICTURE_SIZE(Messages.key("Resolution"), Messages.key("Set the render resolution"), "mdi2r-resize"),
    ANTIALIAS(Messages.key("Anti-Aliasing"), Messages.key("Choose which pixels are anti-aliased: off, edges or every"), "mdi2b-blur"),
    SAMPLES(Messages.key("Samples per Pixel"), Messages.key("Set the samples of an anti-aliased pixel"), "mdi2g-grid", "",
            DisabledReasons::singleSample),
    INDIRECT(Messages.key("Indirect Light"), Messages.key("Add the light that surfaces scatter onto each other"), "mdi2s-swap-horizontal"),
    INDIRECT_BOUNCES(Messages.key("Indirect Bounces"), Messages.key("Set how often light is scattered before it reaches a visible surface"),
            "mdi2c-chart-timeline-variant", "", DisabledReasons::noIndirectLight),
    INDIRECT_RAYS(Messages.key("Rays per Gather Point"),
            Messages.key("Set how many rays collect light at each gather point; more rays are smoother and slower"), "mdi2w-weather-sunny",
            "", DisabledReasons::noIndirectLight),
    INDIRECT_SPACING(Messages.key("Gather Point Spacing"),
            Messages.key("Set the distance of gather points in pixels; a smaller one shows finer detail and is slower"), "mdi2d-dots-grid",
            "", DisabledReasons::noIndirectLight),
    INDIRECT_BACKGROUND(Messages.key("Light from Background"),
            Messages.key("Choose whether the background lights the scene where a ray leaves it"), "mdi2i-image-outline", "",
            DisabledReasons::noIndirectLight),
    REFLECTION_RAYS(Messages.key("Blurred Reflections"),
            Messages.key("Set how many rays collect what a point of a rough surface reflects; more rays are smoother and slower"),
            "mdi2b-blur-linear"),
    COMPARE_SETTINGS(Messages.key("Compare Settings…"),
            Messages.key("Compare the time and accuracy of settings of indirect light, blurred reflections and soft shadows"),
            "mdi2c-chart-scatter-plot"),
    KEEP_PICTURES(Messages.key("Keep Pictures on Disk"),
            Messages.key("Keep finished pictures, so that scenes open with them; switched off, those on the disk are deleted"),
            "mdi2h-harddisk"),

    ONLY_SELECTED(Messages.key("Isolate Selected Light"), Messages.key("Show only the selected light's contribution, reflections included"),
            "mdi2f-filter-outline", "Shortcut+I"),
    SCOPES(Messages.key("Scopes…"), Messages.key("Show histogram and waveform of the displayed render"), "mdi2c-chart-histogram"),
    CURVE(Messages.key("View Transform"), Messages.key("Choose the tone mapping of the display"), "mdi2c-chart-bell-curve"),
    COLOR_TABLE(Messages.key("Load LUT…"), Messages.key("Apply a .cube LUT after the view transform, or remove it"), "mdi2c-cube-outline"),
    OCIO_VIEW(Messages.key("OpenColorIO View…"), Messages.key("Choose a display and a view of an OpenColorIO configuration"),
            "mdi2p-palette-outline"),
    MARK_CLIPPING(Messages.key("Show Clipping"), Messages.key("Mark pixels that are clipped at white or black"), "mdi2c-circle-off-outline",
            "Shortcut+Shift+K"),
    SHADOWS(Messages.key("Shadows"), Messages.key("Show shadows in the render"), "mdi2b-box-shadow"),
    REFLECTIONS(Messages.key("Reflections"), Messages.key("Show reflections in the render"), "mdi2m-mirror"),
    LIT_TEXTURES(Messages.key("Shade Textures"), Messages.key("Light textures, or show them self-illuminated as in 1998"), "mdi2t-texture"),
    TRACED_FIT(Messages.key("Fit Image"), Messages.key("Show the whole image (wheel zooms, middle button pans)"),
            "mdi2f-fit-to-page-outline", "Shortcut+0"),
    TRACED_ONE_TO_ONE(Messages.key("Actual Pixels"), Messages.key("Show one image pixel per screen pixel"), "mdi2n-numeric-1-box-outline",
            "Shortcut+1"),
    TRACED_ZOOM_IN(Messages.key("Zoom In"), Messages.key("Zoom in on the render"), "mdi2m-magnify-plus-outline", "Shortcut+EQUALS"),
    TRACED_ZOOM_OUT(Messages.key("Zoom Out"), Messages.key("Zoom out of the render"), "mdi2m-magnify-minus-outline", "Shortcut+MINUS"),
    REGION(Messages.key("Render Region"), Messages.key("Drag a region in the image to render pending edits there"), "mdi2s-selection-drag",
            "Shortcut+B", DisabledReasons::notFullPicture),
    VIEW_X(Messages.key("Side View"), Messages.key("View along the x axis (X)"), "mdi2a-axis-x-arrow", "Shortcut+2"),
    VIEW_Y(Messages.key("Top View"), Messages.key("View from above, along the negative y axis (Y)"), "mdi2a-axis-y-arrow", "Shortcut+3"),
    VIEW_Z(Messages.key("Camera View"), Messages.key("View through the scene's camera (Z)"), "mdi2a-axis-z-arrow", "Shortcut+4"),
    VIEW_ALL(Messages.key("Frame All Lights"), Messages.key("Move the preview back to show all lights (A)"), "mdi2a-arrow-expand-all",
            "Shortcut+5"),
    USE_VIEW(Messages.key("Use This View as Camera"), Messages.key("Make the view of the preview the scene's camera"),
            "mdi2c-camera-plus-outline",
            "Shortcut+Alt+0"),
    CHOOSE_CAMERA(Messages.key("Named Camera"), Messages.key("View the picture from a named camera of the scene"),
            "mdi2c-camera-outline"),
    MOVE_CAMERA(Messages.key("Move Camera"), Messages.key("Move the scene's camera by drags in the render"), "mdi2c-camera-control",
            "Shortcut+Alt+9"),
    PREVIEW_SIZE(Messages.key("Preview Resolution"), Messages.key("Set the resolution of the preview"), "mdi2r-resize"),
    HIDE_GIZMOS(Messages.key("Hide Light Handles"), Messages.key("Hide the light handles and lock lights against the mouse (G)"),
            "mdi2c-cone-off", "Shortcut+G"),
    GIZMO_SIZE(Messages.key("Light Handle Size"), Messages.key("Set the size of the light handles"), "mdi2c-cone"),
    NAVIGATION(Messages.key("Camera Navigation"), Messages.key("Choose the mouse buttons that move the view"), "mdi2m-mouse"),
    PREVIEW_SHADOWS(Messages.key("Shadows of Selected Light in Preview"),
            Messages.key("Show hard shadows of the selected light in the preview"), "mdi2b-box-shadow"),
    GLOWING_TEXTURES(Messages.key("Self-Illuminated Textures in Preview (1998)"),
            Messages.key("Show textures in the preview without lighting"), "mdi2t-texture"),
    ARRANGEMENT(Messages.key("Layout"), Messages.key("Arrange render and preview: side by side, one large, or one only"),
            "mdi2v-view-split-vertical"),
    PREVIEW_INSET(Messages.key("Preview Inset"), Messages.key("Show the preview in a corner of the render, or hide it"),
            "mdi2p-picture-in-picture-top-right", "F12"),
    ARRANGE_LIGHT(Messages.key("Arrange for Lighting"), Messages.key("Show both pictures side by side with the light mixer below"),
            "mdi2l-lightbulb-group-outline", "Shortcut+Alt+1"),
    ARRANGE_COMPARE(Messages.key("Arrange for Comparing"), Messages.key("Show only the render, with looks, contributions and scopes"),
            "mdi2c-compare", "Shortcut+Alt+2"),
    ARRANGE_SHOT(Messages.key("Arrange for Shots"), Messages.key("Show a large render with timeline and filmstrip below"),
            "mdi2m-movie-open-outline", "Shortcut+Alt+3"),
    NEXT_PANEL(Messages.key("Next Panel"), Messages.key("Move the keyboard focus to the next picture, list or panel"),
            "mdi2p-page-next-outline", "Shortcut+Alt+P"),
    PREVIOUS_PANEL(Messages.key("Previous Panel"), Messages.key("Move the keyboard focus to the previous picture, list or panel"),
            "mdi2p-page-previous-outline", "Shortcut+Alt+Shift+P"),
    FLOAT_PANEL(Messages.key("Undock/Dock Panel"), Messages.key("Move the panel in use to a window of its own, or back"),
            "mdi2d-dock-window", "Shortcut+Shift+W"),
    MOVE_PANEL(Messages.key("Move Panel to Other Dock"), Messages.key("Move the panel in use below or left of the pictures"),
            "mdi2d-dock-left"),
    CLOSE_PANEL(Messages.key("Close Panel"), Messages.key("Close the panel in use"), "mdi2c-close-box-outline", "Shortcut+W"),
    HIDE_PANELS(Messages.key("Hide Panels"), Messages.key("Show only views and menu (Tab over a view)"), "mdi2f-fit-to-screen-outline",
            "Shift+F11"),
    FULL_SCREEN(Messages.key("Full Screen"), Messages.key("Show the window on the full screen"), "mdi2f-fullscreen", "F11"),
    LIGHT_THEME(Messages.key("Light Theme"), Messages.key("Use light windows for bright rooms"), "mdi2w-white-balance-sunny"),

    LANGUAGE(Messages.key("Language"), Messages.key("Interface language (takes effect after a restart)"), "mdi2t-translate"),

    PALETTE(Messages.key("Find Command…"), Messages.key("Find a command by a few letters of its name"), "mdi2c-console-line",
            "Shortcut+Shift+P"),
    KEYS(Messages.key("Mouse and Keyboard"), Messages.key("Show mouse actions and keyboard shortcuts, and change shortcuts"),
            "mdi2k-keyboard-outline", "F1"),
    ABOUT(Messages.key("About Lightning"), Messages.key("Show version and license"), "mdi2i-information-outline");

    private final String title;
    private final String help;
    private final String icon;
    private final String shortcut;
    private final Function<EditorState, Optional<String>> disabledReason;
    private final Function<EditorState, Optional<String>> subject;

    Command(String title, String help, String icon) {
        this(title, help, icon, "");
    }

    Command(String title, String help, String icon, String shortcut) {
        this(title, help, icon, shortcut, _ -> Optional.empty());
    }

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

    /** Returns the menu title; it ends in … if the command opens a dialog. */
    public String title() {
        return Messages.tr(title);
    }

    /** Returns the title with the command's current subject, if any: {@code Undo (intensity of key)}. */
    public String title(EditorState s) {
        return title() + subject.apply(s).map(what -> " (" + what + ")").orElse("");
    }

    /** Returns the title for buttons and tables, without the dots. */
    public String plainTitle() {
        return title().replace("…", "");
    }

    /** Returns the tooltip, one sentence without a period. */
    public String help() {
        return Messages.tr(help);
    }

    /** Returns the icon's name in the Material Design set. */
    public String icon() {
        return icon;
    }

    /** Returns the default shortcut in JavaFX notation, {@code Shortcut+Shift+Z}; empty if none. */
    public String shortcut() {
        return shortcut;
    }

    /** Returns the id of the command's controls: {@code go} for {@code GO}, {@code save-scene} for {@code SAVE_SCENE}. */
    public String id() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Returns whether the command is enabled. */
    public boolean isEnabled(EditorState s) {
        return disabledReason(s).isEmpty();
    }

    /** Returns the reason why the command is disabled, a clause without a period; empty if it is enabled. */
    public Optional<String> disabledReason(EditorState s) {
        return disabledReason.apply(s);
    }
}
