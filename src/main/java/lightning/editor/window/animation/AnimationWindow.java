package lightning.editor.window.animation;

import java.util.function.Supplier;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.WindowPlacement;

/** Window that records and plays the motion path of the light that is selected when it opens (paper §3.7). */
public final class AnimationWindow extends Stage {
    /** Distance from the edge of the editor's window, pixels. */
    private static final double MARGIN = 16;

    private final LightAnimation animation;

    /** Starts the animation; closing the window ends it. A light must be selected. */
    public AnimationWindow(EditorModel model, Window owner) {
        this(model, owner, PathPrompt.ofSystem(owner, model.fileImporter().folder()));
    }

    /** Registers the command that converts keyframes to a motion path. */
    public static void registerCommands(EditorModel model, Supplier<Window> owner) {
        model.commands().setAction(Command.MAKE_ANIMATION, () -> new AnimationWindow(model, owner.get()).show());
        model.commands().setAction(Command.KEYS_TO_WAY,
                () -> model.editor().document().shotFrame().flatMap(m -> RecordedShot.of(m.shot(), model.editor().selection().lightName()))
                        .ifPresentOrElse(path -> {
                            var window = new AnimationWindow(model, owner.get());
                            window.show();
                            window.animation.setRecorded(path);
                        }, () -> model.editor().message()
                                .show(Messages
                                        .tr("Expected linear keyframes of position and direction at the same, evenly spaced frames"))));
    }

    AnimationWindow(EditorModel model, Window owner, PathPrompt pathPrompt) {
        initOwner(owner);
        animation = new LightAnimation(model);
        model.commands().setAction(Command.WAY_TO_KEYS, () -> {
            animation.convertToKeys();
            close();
        });
        setTitle(Messages.tr("Make Animation: {0}", animation.light()));
        String name = model.editor().document().name().replaceFirst("\\.[^.]*$", "") + "-" + animation.light();
        AnimationPane pane = new AnimationPane(animation, name, pathPrompt, this::close,
                CommandButton.titledButton(model.commands(), Command.WAY_TO_KEYS));
        Scene content = ColorTheme.scene(pane);
        content.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
                event.consume();
            }
        });
        CommandKeys.install(content, model.commands());
        setScene(content);
        setResizable(false);
        setOnShown(_ -> {
            // Covers the properties, so that both pictures stay visible.
            setX(Math.max(owner.getX(), owner.getX() + owner.getWidth() - getWidth() - MARGIN));
            setY(Math.max(owner.getY(), owner.getY() + owner.getHeight() - getHeight() - MARGIN));
            WindowPlacement.fit(this);
        });
        setOnHidden(_ -> {
            pane.stopExport();
            animation.close();
        });
    }
}
