package lightning.edit;

import java.util.Optional;
import lightning.scene.Limits;
import lightning.scene.VisiblePart;

/** What the buttons and menus do, and why one of them has nothing to do (paper §3.2 to §3.7). */
public enum Command {
    GO, UPDATE_REFLECTIONS, VERIFY, CANCEL,
    UNDO, REDO, UNDO_LIGHT, REDO_LIGHT,
    LOAD_FILE, RELOAD, SAVE_SCENE, SAVE_SCENE_AS, SAVE_IMAGE,
    ADD_LIGHT, DELETE_LIGHT, DUPLICATE_LIGHT, RENAME_LIGHT, CHANGE_TYPE, SWITCH_ON, SOLO,
    COPY_SETTINGS, PASTE_SETTINGS, AIM, LOOK_THROUGH_LIGHT, PICK_MATERIAL,
    MAKE_ANIMATION;

    private static final String NO_PICTURE = "there is no picture yet";

    /** Whether the command has something to do. */
    public boolean isEnabled(Situation s) {
        return obstacle(s).isEmpty();
    }

    /** Why the command is disabled: a clause without a full stop; empty if it is enabled. */
    public Optional<String> obstacle(Situation s) {
        if (s.animating() && !runsBesideAnimation()) {
            return Optional.of("an animation is open; close it first");
        }
        return switch (this) {
            case GO -> go(s);
            case UPDATE_REFLECTIONS -> reflections(s);
            case VERIFY, PICK_MATERIAL -> s.rendered().isEmpty() ? Optional.of(NO_PICTURE) : Optional.empty();
            case CANCEL -> unless(s.inWork().isPresent() || s.verifying(), "nothing is running");
            case UNDO -> unless(s.undo().isPresent(), "there is nothing to undo");
            case REDO -> unless(s.redo().isPresent(), "there is nothing to redo");
            case UNDO_LIGHT -> ofLight(s, s.undoLight().isPresent(), "there is nothing to undo of this light");
            case REDO_LIGHT -> ofLight(s, s.redoLight().isPresent(), "there is nothing to redo of this light");
            case LOAD_FILE, SAVE_SCENE_AS -> Optional.empty();
            case RELOAD -> unless(s.dirty() || s.changedOnDisk(), "the scene is as it is on disk");
            case SAVE_SCENE -> unless(s.dirty(), "there is nothing to save");
            case SAVE_IMAGE -> unless(s.rendered().isPresent(), NO_PICTURE);
            case ADD_LIGHT -> room(s);
            case DUPLICATE_LIGHT -> s.selected().isEmpty() ? noLight() : room(s);
            case DELETE_LIGHT, RENAME_LIGHT, CHANGE_TYPE, SWITCH_ON, SOLO, COPY_SETTINGS, LOOK_THROUGH_LIGHT ->
                    ofLight(s, true, "");
            case PASTE_SETTINGS -> ofLight(s, s.copied().isPresent(), "no settings were copied");
            case AIM -> s.type().map(Attribute.DIRECTION::obstacle).orElseGet(Command::noLight);
            case MAKE_ANIMATION -> ofLight(s, !s.isPending(),
                    s.rendered().isEmpty() ? NO_PICTURE : "the picture does not show the last edits; press Go first");
        };
    }

    /** Whether it neither changes the document nor writes what an animation has changed for a while. */
    private boolean runsBesideAnimation() {
        return switch (this) {
            case GO, UPDATE_REFLECTIONS, VERIFY, CANCEL, SAVE_IMAGE, COPY_SETTINGS, LOOK_THROUGH_LIGHT, PICK_MATERIAL -> true;
            case UNDO, REDO, UNDO_LIGHT, REDO_LIGHT, LOAD_FILE, RELOAD, SAVE_SCENE, SAVE_SCENE_AS, ADD_LIGHT, DELETE_LIGHT,
                    DUPLICATE_LIGHT, RENAME_LIGHT, CHANGE_TYPE, SWITCH_ON, SOLO, PASTE_SETTINGS, AIM, MAKE_ANIMATION -> false;
        };
    }

    private static Optional<String> go(Situation s) {
        if (!s.isPending()) {
            return Optional.of("nothing was edited since the last Go");
        }
        boolean comes = s.inWork().filter(scene -> VisiblePart.same(scene, s.scene())).isPresent();
        return comes ? Optional.of("the scene is being rendered") : Optional.empty();
    }

    private static Optional<String> reflections(Situation s) {
        if (s.rendered().isEmpty() || s.mirrored().isEmpty()) {
            return Optional.of(NO_PICTURE);
        }
        if (VisiblePart.same(s.rendered().get(), s.mirrored().get())) {
            return Optional.of("the mirrors show the picture's lights already");
        }
        return unless(s.mirrorsRemark().isPresent(), "nothing in the picture mirrors");
    }

    private static Optional<String> room(Situation s) {
        return unless(s.scene().lights().size() < Limits.MAX_LIGHTS,
                "a scene has at most " + Limits.MAX_LIGHTS + " lights");
    }

    private static Optional<String> ofLight(Situation s, boolean possible, String obstacle) {
        return s.selected().isEmpty() ? noLight() : unless(possible, obstacle);
    }

    private static Optional<String> noLight() {
        return Optional.of("no light is selected");
    }

    private static Optional<String> unless(boolean possible, String obstacle) {
        return possible ? Optional.empty() : Optional.of(obstacle);
    }
}
