package lightning.editor.window.model;

import java.util.function.BooleanSupplier;
import java.util.function.LongPredicate;
import javafx.animation.AnimationTimer;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import lightning.scene.Scene;

/** Plays frames: shows the next one when the traced picture of the one before is finished. Stops where a picture fails. */
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
    private Scene awaitedScene;

    /**
     * @param stopCondition whether to stop playing
     * @param showNextFrame shows another frame if one is due at a time in nanoseconds; returns whether one was
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

    /** Starts when the picture of the scene that is shown now is finished. */
    public void play() {
        awaitedScene = editor.scene();
        playing.set(true);
        timer.start();
    }

    /** Stays at the frame that is shown. */
    public void stop() {
        timer.stop();
        playing.set(false);
    }

    private void pulse(long now) {
        if (stopCondition.getAsBoolean() || picture.renderStateProperty().get().problem() != null) {
            stop();
        } else if (picture.frame() != null && picture.frame().scene().equals(awaitedScene) && showNextFrame.test(now)) {
            awaitedScene = editor.scene();
        }
    }
}
