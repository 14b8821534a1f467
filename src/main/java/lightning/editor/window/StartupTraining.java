package lightning.editor.window;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.stage.Window;
import javafx.util.Duration;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.ColorTheme;

/**
 * Training run that records which classes the editor uses: opens the first scene, then menus and panels one after the other, and closes.
 */
public final class StartupTraining extends LightningApp {
    /** Pause between two steps, in which an opened window is painted. */
    private static final Duration STEP_PAUSE = Duration.millis(300);

    /** Opens the editor if a window can be opened, and returns when it is closed. At most once per process. */
    public static void open() {
        open(StartupTraining.class, List.of());
    }

    @Override
    void editorOpened(Editor editor) {
        Iterator<Runnable> steps = steps(editor.model()).iterator();
        var stepTimer = new PauseTransition(STEP_PAUSE);
        stepTimer.setOnFinished(_ -> {
            if (steps.hasNext()) {
                steps.next().run();
                stepTimer.playFromStart();
            } else {
                Platform.exit();
            }
        });
        editor.model().picture().renderStateProperty().subscribe(state -> {
            if (state.frame() != null) {
                stepTimer.play();
            }
        });
    }

    private static List<Runnable> steps(EditorModel model) {
        List<Runnable> steps = new ArrayList<>();
        Stream.of(Command.MIXER, Command.CONTRIBUTIONS, Command.LOOKS, Command.SCOPES, Command.EFFECTS_PANEL, Command.ACCURACY_PANEL,
                Command.COMPARE_SETTINGS,
                Command.UPDATES_PANEL, Command.HISTORY_PANEL, Command.KEYS, Command.PALETTE, Command.ABOUT, Command.TIMELINE)
                .forEach(command -> steps.add(() -> model.commands().run(command)));
        steps.add(() -> model.commands().run(Command.NEW_SHOT));
        steps.add(() -> model.editor().materialShownProperty().set(true));
        steps.add(() -> model.editor().scene().placedShapes().stream().findFirst()
                .ifPresent(s -> model.editor().selection().selectNode(s.shape().name())));
        menus().forEach(menu -> {
            steps.add(menu::show);
            steps.add(menu::hide);
        });
        steps.add(ColorTheme.LIGHT::apply);
        return steps;
    }

    private static List<Menu> menus() {
        return Window.getWindows().stream().map(w -> w.getScene().lookup(".menu-bar")).filter(MenuBar.class::isInstance).findFirst()
                .map(bar -> List.copyOf(((MenuBar) bar).getMenus())).orElse(List.of());
    }
}
