package lightning.editor.document;

import java.util.Optional;
import java.util.function.Function;
import lightning.base.text.Texts;
import lightning.scene.LightAttribute;
import lightning.scene.Limits;
import lightning.scene.VisiblePart;
import lightning.scene.shot.Target;

/** Why commands have nothing to do: each a clause without a full stop, or empty where nothing is in the way. */
final class Obstacles {
    /** There is always something to do. */
    static final Function<Situation, Optional<String>> NONE = _ -> Optional.empty();

    private static final String NO_PICTURE = Texts.key("there is no picture yet");

    private Obstacles() {}

    /** Of a command that changes the document, or writes what an animation has changed for a while. */
    static Function<Situation, Optional<String>> alone() {
        return alone(NONE);
    }

    /** The same, with an obstacle of its own. */
    static Function<Situation, Optional<String>> alone(Function<Situation, Optional<String>> own) {
        return s -> s.animating() ? Optional.of(Texts.of("an animation is open; close it first")) : own.apply(s);
    }

    static Optional<String> noPicture(Situation s) {
        return unless(s.rendered().isPresent(), Texts.of(NO_PICTURE));
    }

    static Optional<String> notPlain(Situation s) {
        return unless(s.plain(), Texts.of("the view does not show the whole picture"));
    }

    static Optional<String> nothingRuns(Situation s) {
        return unless(s.inWork().isPresent() || s.verifying() || s.reading(), Texts.of("nothing is running"));
    }

    static Optional<String> asOnDisk(Situation s) {
        return unless(s.dirty() || s.changedOnDisk(), Texts.of("the scene is as it is on disk"));
    }

    static Optional<String> saved(Situation s) {
        return unless(s.dirty(), Texts.of("there is nothing to save"));
    }

    static Optional<String> nothingToUndo(Situation s) {
        return unless(s.undo().isPresent(), Texts.of("there is nothing to undo"));
    }

    static Optional<String> nothingToRedo(Situation s) {
        return unless(s.redo().isPresent(), Texts.of("there is nothing to redo"));
    }

    static Optional<String> nothingToUndoOfLight(Situation s) {
        return ofLight(s, s.undoLight().isPresent(), Texts.of("there is nothing to undo of this light"));
    }

    static Optional<String> nothingToRedoOfLight(Situation s) {
        return ofLight(s, s.redoLight().isPresent(), Texts.of("there is nothing to redo of this light"));
    }

    static Optional<String> noLight(Situation s) {
        return unless(s.selected().isPresent(), Texts.of("no light is selected"));
    }

    static Optional<String> noShape(Situation s) {
        return unless(s.node().isPresent(), Texts.of("no shape is selected"));
    }

    static Optional<String> noShapeOrNoRoom(Situation s) {
        return noShape(s).or(() -> unless(s.scene().stage().shapeCount() < Limits.MAX_SHAPES,
                Texts.of("a scene has at most {0} shapes", Limits.MAX_SHAPES)));
    }

    static Optional<String> nothingCopied(Situation s) {
        return ofLight(s, s.copied().isPresent(), Texts.of("no settings were copied"));
    }

    static Optional<String> noDirection(Situation s) {
        return s.type().map(LightAttribute.DIRECTION::obstacle).orElseGet(() -> noLight(s));
    }

    static Optional<String> noRoom(Situation s) {
        return unless(s.scene().lights().size() < Limits.MAX_LIGHTS, Texts.of("a scene has at most {0} lights", Limits.MAX_LIGHTS));
    }

    static Optional<String> noBank(Situation s) {
        return noLight(s).or(() -> unless(!s.selected().orElseThrow().bank().isEmpty(), Texts.of("the light is in no bank")));
    }

    static Optional<String> noLightOrNoBankMore(Situation s) {
        return noLight(s)
                .or(() -> unless(s.scene().rig().banks().size() < Limits.MAX_BANKS,
                        Texts.of("a scene has at most {0} banks", Limits.MAX_BANKS)));
    }

    static Optional<String> noLightOrNoRoom(Situation s) {
        return noLight(s).or(() -> noRoom(s));
    }

    static Optional<String> nothingToAnimate(Situation s) {
        return ofLight(s, !s.isPending(),
                s.rendered().isEmpty() ? Texts.of(NO_PICTURE) : Texts.of("the picture does not show the last edits; press Go first"));
    }

    static Optional<String> hasShot(Situation s) {
        return unless(s.moment().isEmpty(), Texts.of("the scene has a shot"));
    }

    static Optional<String> noShot(Situation s) {
        return unless(s.moment().isPresent(), Texts.of("the scene has no shot"));
    }

    static Optional<String> atFirstFrame(Situation s) {
        return noShot(s).or(() -> unless(s.moment().get().frame() > s.moment().get().shot().first(),
                Texts.of("it is the first frame already")));
    }

    static Optional<String> atLastFrame(Situation s) {
        return noShot(s)
                .or(() -> unless(s.moment().get().frame() < s.moment().get().shot().last(), Texts.of("it is the last frame already")));
    }

    static Optional<String> noKeyBefore(Situation s) {
        return noShot(s).or(() -> unless(s.moment().get().nearestKey(true).isPresent(), Texts.of("there is no key before this frame")));
    }

    static Optional<String> noKeyBehind(Situation s) {
        return noShot(s).or(() -> unless(s.moment().get().nearestKey(false).isPresent(), Texts.of("there is no key behind this frame")));
    }

    static Optional<String> nothingWithKeys(Situation s) {
        return noShot(s).or(() -> unless(s.moment().get().shot().tracks().stream().anyMatch(t -> s.isSelected(t.target())),
                Texts.of("nothing of what is selected has keys; a right click on a property sets its first one")));
    }

    static Optional<String> noKeyChosen(Situation s) {
        return noShot(s).or(() -> unless(s.chosenKeys() > 0, Texts.of("no key is chosen in the timeline")));
    }

    static Optional<String> noWay(Situation s) {
        return unless(s.animating() && s.way(), Texts.of("no animation is open that has a way; Make Animation records one"));
    }

    static Optional<String> noWayInKeys(Situation s) {
        return nothingToAnimate(s).or(() -> unless(s.moment().flatMap(m -> m.shot().track(Target.light(s.selected().orElseThrow().name()),
                LightAttribute.POSITION.name())).isPresent(), Texts.of("the light has no keys of its place")));
    }

    static Optional<String> oneSample(Situation s) {
        return unless(s.scene().picture().sampling().isFine(), Texts.of("every pixel has one sample"));
    }

    static Optional<String> nothingToRender(Situation s) {
        if (!s.isPending() && !s.lacksSamples()) {
            return Optional.of(Texts.of("nothing was edited since the last Go"));
        }
        boolean comes = s.inWork().filter(scene -> VisiblePart.same(scene, s.scene())).isPresent();
        return unless(!comes, Texts.of("the scene is being rendered"));
    }

    static Optional<String> mirrorsAreCurrent(Situation s) {
        if (s.rendered().isEmpty() || s.mirrored().isEmpty()) {
            return Optional.of(Texts.of(NO_PICTURE));
        }
        if (VisiblePart.same(s.rendered().get(), s.mirrored().get())) {
            return Optional.of(Texts.of("the mirrors show the picture's lights already"));
        }
        return unless(s.mirrorsRemark().isPresent(), Texts.of("nothing in the picture mirrors or is clear"));
    }

    private static Optional<String> ofLight(Situation s, boolean possible, String obstacle) {
        return noLight(s).or(() -> unless(possible, obstacle));
    }

    private static Optional<String> unless(boolean possible, String obstacle) {
        return possible ? Optional.empty() : Optional.of(obstacle);
    }
}
