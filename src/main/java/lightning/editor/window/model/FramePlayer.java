package lightning.editor.window.model;

import static java.util.Objects.requireNonNull;

import java.util.function.BooleanSupplier;
import java.util.function.LongPredicate;
import javafx.animation.AnimationTimer;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import lightning.document.loop.Frame;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Plays frames: shows the next frame once the traced picture of the current one is finished. Stops if a picture fails. */
public final class FramePlayer {
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final BooleanSupplier stopCondition;
    private final LongPredicate showNextFrame;
    private final ReadOnlyBooleanWrapper playing = new ReadOnlyBooleanWrapper();
    private final AnimationTimer timer = new AnimationTimer() {
        @Override
        public void handle(long now) {
            pulse(now);
        }
    };
    private @Nullable Scene awaitedScene;

    /**
     * @param stopCondition  returns true to stop playing
     * @param showNextFrame  shows the next frame if it is due at a time in nanoseconds; returns true if it did
     */
    public FramePlayer(SceneEditor editor, TracedPicture picture, BooleanSupplier stopCondition, LongPredicate showNextFrame) {
        this.editor = editor;
        this.picture = picture;
        this.stopCondition = stopCondition;
        this.showNextFrame = showNextFrame;
    }

    public ReadOnlyBooleanProperty playingProperty() {
        return playing.getReadOnlyProperty();
    }

    public boolean isPlaying() {
        return playing.get();
    }

    /** Starts playing once the picture of the current scene is finished. */
    public void play() {
        awaitedScene = editor.scene();
        playing.set(true);
        timer.start();
    }

    /** Stops playing at the current frame. */
    public void stop() {
        timer.stop();
        playing.set(false);
    }

    private void pulse(long now) {
        Frame frame = picture.frame();
        if (stopCondition.getAsBoolean() || picture.renderStateProperty().get().problem() != null) {
            stop();
        } else if (frame != null && frame.scene().hasSameImage(requireNonNull(awaitedScene)) && showNextFrame.test(now)) {
            awaitedScene = editor.scene();
        }
    }
}
