package lightning.editor.window.timeline;

import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import lightning.base.text.Decimal;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.Moment;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FramePlayer;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.scene.shot.AnimatedScene;

/**
 * Plays the shot in real time, again and again: whenever the picture of a frame is there, the frame that is due is next, and those between
 * are left out. It ends when anything is edited.
 */
public final class Playback {
    private static final double SECOND = 1e9;

    private final SceneEditor editor;
    private final FramePlayer player;
    private final ReadOnlyStringWrapper pace = new ReadOnlyStringWrapper("");
    private AnimatedScene content;
    private int firstFrame;
    private long begun;
    private long counted;
    private int shown;

    /** Says what Play Shot does. */
    public Playback(SceneEditor editor, TracedPicture picture, Commands commands) {
        this.editor = editor;
        player = new FramePlayer(editor, picture, () -> editor.document().content() != content || editor.isAnimating(), this::showDue);
        player.playingProperty().subscribe(_ -> pace.set(""));
        commands.setSwitch(Command.PLAY_SHOT, player.playingProperty(), this::toggle);
    }

    private void toggle() {
        if (player.isPlaying()) {
            player.stop();
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
        editor.go();
        firstFrame = now.frame() < now.shot().last() ? now.frame() : now.shot().first();
        begun = -1;
        player.play();
    }

    private boolean showDue(long now) {
        if (begun < 0) {
            begun = now;
            counted = now;
            shown = 0;
        }
        Moment moment = editor.document().moment().orElseThrow();
        int frames = moment.shot().last() - moment.shot().first() + 1;
        long passed = (long) ((now - begun) / SECOND * moment.shot().rate());
        int due = moment.shot().first() + (int) ((firstFrame - moment.shot().first() + passed) % frames);
        boolean isDue = due != moment.frame();
        if (isDue) {
            editor.showFrame(due);
            shown++;
        }
        if (now - counted > SECOND) {
            pace.set(Texts.of("{0} of {1} frames a second", Decimal.text(Math.rint(shown * SECOND / (now - counted))),
                    Decimal.text(moment.shot().rate())));
            counted = now;
            shown = 0;
        }
        return isDue;
    }
}
