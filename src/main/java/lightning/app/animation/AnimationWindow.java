package lightning.app.animation;

import javafx.animation.AnimationTimer;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.app.command.CommandKeys;
import lightning.app.command.PathAsk;
import lightning.app.model.EditorModel;
import lightning.app.widget.Looks;
import lightning.app.widget.OnScreen;
import lightning.text.Texts;

/** Records and plays the way of the light that is selected when it opens (paper §3.7). */
public final class AnimationWindow extends Stage {
    /** From the corner of the editor's window, pixels. */
    private static final double MARGIN = 16;

    /** Begins the animation; closing the window ends it. A light must be selected. */
    public AnimationWindow(EditorModel model, Window owner) {
        this(model, owner, PathAsk.inWindows(owner, model.document().file().toAbsolutePath().getParent()));
    }

    AnimationWindow(EditorModel model, Window owner, PathAsk ask) {
        initOwner(owner);
        Motion motion = new Motion(model);
        setTitle(Texts.of("Animation of {0}", motion.light()));
        String name = model.document().name().replaceFirst("\\.[^.]*$", "") + "-" + motion.light();
        AnimationPane pane = new AnimationPane(motion, name, ask, this::close);
        Scene content = new Scene(pane);
        content.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
                event.consume();
            }
        });
        CommandKeys.take(content, model);
        Looks.dress(content);
        setScene(content);
        setResizable(false);
        AnimationTimer timer = new AnimationTimer() {
            @Override
            public void handle(long now) {
                motion.pulse();
            }
        };
        setOnShown(_ -> {
            // Over the properties, so that both pictures can be seen.
            setX(Math.max(owner.getX(), owner.getX() + owner.getWidth() - getWidth() - MARGIN));
            setY(Math.max(owner.getY(), owner.getY() + owner.getHeight() - getHeight() - MARGIN));
            OnScreen.fit(this);
            timer.start();
        });
        setOnHidden(_ -> {
            timer.stop();
            pane.stopExport();
            motion.close();
        });
    }
}
