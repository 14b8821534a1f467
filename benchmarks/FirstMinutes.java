package lightning.editor.window;

import static lightning.editor.window.Window.await;
import static lightning.editor.window.Window.onWindow;
import static lightning.editor.window.Window.print;

import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Button;
import javafx.scene.image.PixelReader;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.robot.Robot;
import javafx.stage.Screen;
import javafx.stage.Window;
import javax.imageio.ImageIO;
import lightning.editor.document.Command;

/**
 * An artist's first five minutes in the real window: from the start of the program to an own model, with mouse and keys, and with a picture
 * of the screen after each step.
 */
public final class FirstMinutes {
    private static final long START = Long.getLong("start");
    /** Time after which a pane is drawn, milliseconds. */
    private static final long DRAW_MS = 400;
    private static final int DRAG_STEPS = 10;

    private static Path folder;
    private static File model;
    private final Robot robot;
    private int pictures;

    private FirstMinutes(Robot robot) {
        this.robot = robot;
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
                    new FirstMinutes(onWindow(Robot::new)).run(editor);
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
        key(KeyCode.ESCAPE);
        command(editor, Command.ARRANGE_LIGHT);
        Thread.sleep(DRAW_MS);
        capture("arrangement for lighting");
        dragFader(editor);
        capture("first light of the mixer dimmed");
        command(editor, Command.ADD_LIGHT);
        await(editor::isIdle);
        capture("new light");
        click(node("#traced-picture"), MouseButton.SECONDARY);
        Thread.sleep(DRAW_MS);
        capture("menu of a pixel");
        key(KeyCode.ESCAPE);
        command(editor, Command.ARRANGE_COMPARE);
        Thread.sleep(DRAW_MS);
        capture("arrangement for comparing");
        // The choice waits for an answer.
        Platform.runLater(() -> editor.window().openDropped(List.of(model)));
        Thread.sleep(2 * DRAW_MS);
        capture("question about unsaved changes");
        fire("Don't Save");
        Thread.sleep(10 * DRAW_MS);
        capture("model with a choice of lighting");
    }

    /** Drags a fader down in small steps, and waits for the exact picture. */
    private void dragFader(Editor editor) throws Exception {
        Bounds thumb = screenBounds(((Parent) node("#fader-her_spot")).getChildrenUnmodifiable().getLast());
        double x = thumb.getCenterX();
        double y = thumb.getCenterY();
        onWindow(() -> {
            robot.mouseMove(x, y);
            robot.mousePress(MouseButton.PRIMARY);
            return null;
        });
        for (int i = 1; i <= DRAG_STEPS; i++) {
            int step = i;
            onWindow(() -> {
                robot.mouseMove(x, y + 2 * step);
                return null;
            });
            Thread.sleep(100);
        }
        long released = System.nanoTime();
        onWindow(() -> {
            robot.mouseRelease(MouseButton.PRIMARY);
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

    private void key(KeyCode key) throws Exception {
        onWindow(() -> {
            robot.keyType(key);
            return null;
        });
        Thread.sleep(DRAW_MS);
    }

    private void click(Node node, MouseButton button) throws Exception {
        Bounds at = screenBounds(node);
        onWindow(() -> {
            robot.mouseMove(at.getCenterX(), at.getCenterY());
            robot.mouseClick(button);
            return null;
        });
    }

    /** Presses a button of a dialog. */
    private static void fire(String text) throws Exception {
        onWindow(() -> {
            Window.getWindows().stream().flatMap(window -> window.getScene().getRoot().lookupAll(".button").stream())
                    .filter(node -> node instanceof Button button && text.equals(button.getText())).findFirst()
                    .ifPresent(button -> Platform.runLater(((Button) button)::fire));
            return null;
        });
    }

    private static Bounds screenBounds(Node node) throws Exception {
        return onWindow(() -> node.localToScreen(node.getBoundsInLocal()));
    }

    private static Node node(String selector) throws Exception {
        Callable<Node> find = () -> Window.getWindows().getFirst().getScene().getRoot().lookup(selector);
        await(() -> find.call() != null);
        return onWindow(find);
    }

    /** Stores a picture of the screen and prints the time since the start of the program. */
    private void capture(String step) throws Exception {
        long time = System.currentTimeMillis() - START;
        Thread.sleep(DRAW_MS);
        Rectangle2D screen = Screen.getPrimary().getBounds();
        PixelReader pixels = onWindow(() -> robot.getScreenCapture(null, screen, false)).getPixelReader();
        double scale = Screen.getPrimary().getOutputScaleX();
        BufferedImage image =
                new BufferedImage((int) (screen.getWidth() * scale), (int) (screen.getHeight() * scale), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, pixels.getArgb(x, y));
            }
        }
        File file = folder.resolve("%02d %s.png".formatted(++pictures, step)).toFile();
        ImageIO.write(image, "png", file);
        print("%6.1f s  %s", time / 1e3, step);
    }
}
