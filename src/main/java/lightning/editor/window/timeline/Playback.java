package lightning.editor.window.timeline;

import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Messages;
import lightning.document.ShotFrame;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.FramePlayer;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.scene.shot.AnimatedScene;
import org.jspecify.annotations.Nullable;

/**
 * Plays the shot in real time, in a loop. When a frame's picture is ready, the frame that is due is rendered next and the frames between
 * are dropped. Any edit stops it.
 */
public final class Playback {
    private static final double NS_PER_SECOND = 1e9;

    private final SceneEditor editor;
    private final FramePlayer player;
    private final ReadOnlyStringWrapper frameRate = new ReadOnlyStringWrapper("");
    private @Nullable AnimatedScene content;
    private int firstFrame;
    private long startNs;
    private long countStartNs;
    private int shownFrames;

    /** Registers Play Shot. */
    public Playback(SceneEditor editor, TracedPicture picture, CommandRegistry commands) {
        this.editor = editor;
        player = new FramePlayer(editor, picture, () -> editor.document().content() != content, this::showDue);
        player.playingProperty().subscribe(_ -> frameRate.set(""));
        commands.setToggle(Command.PLAY_SHOT, player.playingProperty(), this::toggle);
    }

    private void toggle() {
        if (player.isPlaying()) {
            player.stop();
        } else {
            start();
        }
    }

    /** Returns the achieved frame rate as text; empty while playback is stopped. */
    ReadOnlyStringProperty frameRateProperty() {
        return frameRate.getReadOnlyProperty();
    }

    private void start() {
        ShotFrame now = editor.document().shotFrame().orElseThrow();
        content = editor.document().content();
        editor.go();
        firstFrame = now.frame() < now.shot().last() ? now.frame() : now.shot().first();
        startNs = -1;
        player.play();
    }

    private boolean showDue(long now) {
        if (startNs < 0) {
            startNs = now;
            countStartNs = now;
            shownFrames = 0;
        }
        ShotFrame moment = editor.document().shotFrame().orElseThrow();
        int frames = moment.shot().last() - moment.shot().first() + 1;
        long elapsedFrames = (long) ((now - startNs) / NS_PER_SECOND * moment.shot().rate());
        int dueFrame = moment.shot().first() + (int) ((firstFrame - moment.shot().first() + elapsedFrames) % frames);
        boolean isDue = dueFrame != moment.frame();
        if (isDue) {
            editor.showFrame(dueFrame);
            shownFrames++;
        }
        if (now - countStartNs > NS_PER_SECOND) {
            frameRate.set(Messages.tr("{0} of {1} fps",
                    DecimalNumber.format(Math.rint(shownFrames * NS_PER_SECOND / (now - countStartNs))),
                    DecimalNumber.format(moment.shot().rate())));
            countStartNs = now;
            shownFrames = 0;
        }
        return isDue;
    }
}
