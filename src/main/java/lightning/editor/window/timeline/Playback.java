package lightning.editor.window.timeline;

import javafx.animation.AnimationTimer;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.text.Decimal;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.Moment;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;

/**
 * Plays the shot in real time, again and again: whenever the picture of a frame is there, the frame that is due is next, and those between
 * are left out. It ends when anything is edited.
 */
public final class Playback {
    private static final double SECOND = 1e9;

    private final SceneEditor editor;
    private final TracedPicture picture;
    private final ReadOnlyBooleanWrapper playing = new ReadOnlyBooleanWrapper();
    private final ReadOnlyStringWrapper pace = new ReadOnlyStringWrapper("");
    private final AnimationTimer timer = new AnimationTimer() {
        @Override
        public void handle(long now) {
            pulse(now);
        }
    };
    private AnimatedScene content;
    private Scene awaited;
    private int firstFrame;
    private long begun;
    private long counted;
    private int shown;

    /** Says what Play Shot does. */
    public Playback(SceneEditor editor, TracedPicture picture, Commands commands) {
        this.editor = editor;
        this.picture = picture;
        commands.setSwitch(Command.PLAY_SHOT, playing.getReadOnlyProperty(), this::toggle);
    }

    private void toggle() {
        if (playing.get()) {
            stop();
        } else {
            begin();
        }
    }

    /** How many frames of a second are shown; empty while nothing plays. */
    ReadOnlyStringProperty paceProperty() {
        return pace.getReadOnlyProperty();
    }

    private void begin() {
        Moment now = editor.document().moment().orElseThrow();
        content = editor.document().content();
        awaited = editor.scene();
        editor.go();
        firstFrame = now.frame() < now.shot().last() ? now.frame() : now.shot().first();
        begun = -1;
        playing.set(true);
        timer.start();
    }

    /** Stays at the frame that is shown. */
    public void stop() {
        timer.stop();
        playing.set(false);
        pace.set("");
    }

    private void pulse(long now) {
        if (editor.document().content() != content || editor.isAnimating() || picture.renderingProperty().get().problem() != null) {
            stop();
            return;
        }
        if (picture.frame() == null || !picture.frame().scene().equals(awaited)) {
            return;
        }
        if (begun < 0) {
            begun = now;
            counted = now;
            shown = 0;
        }
        Moment moment = editor.document().moment().orElseThrow();
        int frames = moment.shot().last() - moment.shot().first() + 1;
        long passed = (long) ((now - begun) / SECOND * moment.shot().rate());
        int due = moment.shot().first() + (int) ((firstFrame - moment.shot().first() + passed) % frames);
        if (due != moment.frame()) {
            editor.showFrame(due);
            awaited = editor.scene();
            shown++;
        }
        if (now - counted > SECOND) {
            pace.set(Texts.of("{0} of {1} frames a second", Decimal.text(Math.rint(shown * SECOND / (now - counted))),
                    Decimal.text(moment.shot().rate())));
            counted = now;
            shown = 0;
        }
    }
}
