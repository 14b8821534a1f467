package lightning.editor.window.animation;

import java.util.function.Supplier;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.Looks;
import lightning.editor.window.widget.OnScreen;

/** Records and plays the way of the light that is selected when it opens (paper §3.7). */
public final class AnimationWindow extends Stage {
    /** From the corner of the editor's window, pixels. */
    private static final double MARGIN = 16;

    private final Motion motion;

    /** Begins the animation; closing the window ends it. A light must be selected. */
    public AnimationWindow(EditorModel model, Window owner) {
        this(model, owner, PathAsk.inWindows(owner, model.bringer().folder()));
    }

    /** Does the command that makes an animation of keys. */
    public static void addTo(EditorModel model, Supplier<Window> owner) {
        model.commands().setAction(Command.MAKE_ANIMATION, () -> new AnimationWindow(model, owner.get()).show());
        model.commands().setAction(Command.KEYS_TO_WAY,
                () -> model.editor().document().moment().flatMap(m -> RecordedShot.of(m.shot(), model.editor().selection().lightName()))
                        .ifPresentOrElse(way -> {
                            var window = new AnimationWindow(model, owner.get());
                            window.show();
                            window.motion.take(way);
                        }, () -> model.editor().message()
                                .show(Texts.of("A way has linear keys of place and direction at the same frames, evenly spaced"))));
    }

    AnimationWindow(EditorModel model, Window owner, PathAsk ask) {
        initOwner(owner);
        motion = new Motion(model);
        model.commands().setAction(Command.WAY_TO_KEYS, () -> {
            motion.toKeys();
            close();
        });
        setTitle(Texts.of("Animation of {0}", motion.light()));
        String name = model.editor().document().name().replaceFirst("\\.[^.]*$", "") + "-" + motion.light();
        AnimationPane pane = new AnimationPane(motion, name, ask, this::close, CommandButton.titled(model.commands(), Command.WAY_TO_KEYS));
        Scene content = Looks.scene(pane);
        content.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
                event.consume();
            }
        });
        CommandKeys.take(content, model.commands());
        setScene(content);
        setResizable(false);
        setOnShown(_ -> {
            // Over the properties, so that both pictures can be seen.
            setX(Math.max(owner.getX(), owner.getX() + owner.getWidth() - getWidth() - MARGIN));
            setY(Math.max(owner.getY(), owner.getY() + owner.getHeight() - getHeight() - MARGIN));
            OnScreen.fit(this);
        });
        setOnHidden(_ -> {
            pane.stopExport();
            motion.close();
        });
    }
}
