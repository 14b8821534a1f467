package lightning.editor.window;

import static lightning.editor.window.Window.await;
import static lightning.editor.window.Window.onWindow;
import static lightning.editor.window.Window.print;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.editor.Command;

/**
 * An artist's first five minutes in the real window: from the start of the program to an own model, with mouse and keys, and with a picture
 * of the screen after each step.
 */
public final class FirstMinutes {
    private static final long START = Long.getLong("start");
    private static final int DRAG_STEPS = 10;

    private static Path folder;
    private static File model;
    private final Screen screen;
    private int pictures;

    private FirstMinutes() throws Exception {
        screen = new Screen();
    }

    /** Arguments: folder of the pictures, model to import. */
    public static void main(String[] arguments) {
        folder = Path.of(arguments[0]);
        model = new File(arguments[1]);
        LightningApp.open(Session.class, List.of());
        System.exit(0);
    }

    /** The program, with its settings at a new folder. */
    public static final class Session extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    new FirstMinutes().run(editor);
                } catch (Throwable e) {
                    e.printStackTrace();
                }
                // A dialog still waits for an answer.
                Runtime.getRuntime().halt(0);
            });
        }
    }

    private void run(Editor editor) throws Exception {
        await(() -> editor.model().picture().frame() != null);
        capture("first picture");
        await(editor::isIdle);
        capture("finished picture beside the welcome page");
        screen.key(KeyCode.ESCAPE);
        command(editor, Command.ARRANGE_LIGHT);
        Thread.sleep(Screen.DRAW_MS);
        capture("arrangement for lighting");
        dragFader(editor);
        capture("first light of the mixer dimmed");
        command(editor, Command.ADD_LIGHT);
        await(editor::isIdle);
        capture("new light");
        screen.click(Screen.node("#traced-picture"), MouseButton.SECONDARY);
        Screen.node(".context-menu");
        // At scale 2 a menu is painted later than it exists.
        Thread.sleep(3 * Screen.DRAW_MS);
        capture("menu of a pixel");
        screen.key(KeyCode.ESCAPE);
        command(editor, Command.ARRANGE_COMPARE);
        Thread.sleep(Screen.DRAW_MS);
        capture("arrangement for comparing");
        // The choice waits for an answer.
        Platform.runLater(() -> editor.window().openDropped(List.of(model)));
        Thread.sleep(2 * Screen.DRAW_MS);
        capture("question about unsaved changes");
        Screen.fire("Don't Save");
        Node studio = Screen.node("#lighting-studio");
        capture("model with a choice of lighting");
        screen.click(studio, MouseButton.PRIMARY);
        await(() -> editor.model().editor().document().name().startsWith("lamp") && editor.model().picture().frame() != null);
        capture("model in a studio");
        await(editor::isIdle);
        capture("finished picture of the model");
    }

    /** Drags a fader down in small steps, and waits for the exact picture. */
    private void dragFader(Editor editor) throws Exception {
        Bounds thumb = Screen.bounds(((Parent) Screen.node("#fader-her_spot")).getChildrenUnmodifiable().getLast());
        double x = thumb.getCenterX();
        double y = thumb.getCenterY();
        onWindow(() -> {
            screen.robot.mouseMove(x, y);
            screen.robot.mousePress(MouseButton.PRIMARY);
            return null;
        });
        for (int i = 1; i <= DRAG_STEPS; i++) {
            int step = i;
            onWindow(() -> {
                screen.robot.mouseMove(x, y + 2 * step);
                return null;
            });
            Thread.sleep(100);
        }
        long released = System.nanoTime();
        onWindow(() -> {
            screen.robot.mouseRelease(MouseButton.PRIMARY);
            return null;
        });
        await(editor::isIdle);
        print("   %5.0f ms from the end of the drag to the exact picture", (System.nanoTime() - released) / 1e6);
    }

    private void command(Editor editor, Command command) throws Exception {
        onWindow(() -> {
            editor.model().commands().run(command);
            return null;
        });
    }

    /** Stores a picture of the screen and prints the time since the start of the program. */
    private void capture(String step) throws Exception {
        long time = System.currentTimeMillis() - START;
        screen.capture(javafx.stage.Screen.getPrimary().getBounds(), folder.resolve("%02d %s.png".formatted(++pictures, step)));
        print("%6.1f s  %s", time / 1e3, step);
    }
}
