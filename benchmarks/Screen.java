package lightning.editor.window;

import static lightning.editor.window.Window.await;
import static lightning.editor.window.Window.onWindow;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.image.PixelReader;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.robot.Robot;
import javafx.stage.Window;
import javax.imageio.ImageIO;

/** Mouse, keys and pictures of the real screen, for programs that go through the editor like a user. */
final class Screen {
    /** Time after which a pane is drawn, milliseconds. */
    static final long DRAW_MS = 400;

    final Robot robot;

    Screen() throws Exception {
        robot = onWindow(Robot::new);
    }

    void key(KeyCode key) throws Exception {
        onWindow(() -> {
            robot.keyType(key);
            return null;
        });
        Thread.sleep(DRAW_MS);
    }

    void move(double x, double y) throws Exception {
        onWindow(() -> {
            robot.mouseMove(x, y);
            return null;
        });
        Thread.sleep(DRAW_MS);
    }

    void click(Node node, MouseButton button) throws Exception {
        Bounds at = bounds(node);
        onWindow(() -> {
            robot.mouseMove(at.getCenterX(), at.getCenterY());
            robot.mouseClick(button);
            return null;
        });
    }

    /** Presses the first button with a text, also one of a dialog. */
    static void fire(String text) throws Exception {
        onWindow(() -> {
            Window.getWindows().stream().flatMap(window -> window.getScene().getRoot().lookupAll(".button").stream())
                    .filter(node -> node instanceof Button button && text.equals(button.getText())).findFirst()
                    .ifPresent(button -> Platform.runLater(((Button) button)::fire));
            return null;
        });
    }

    /** Waits for a node of any window. */
    static Node node(String selector) throws Exception {
        Callable<Optional<Node>> find = () -> Window.getWindows().stream()
                .flatMap(window -> Optional.ofNullable(window.getScene().getRoot().lookup(selector)).stream()).findFirst();
        await(() -> find.call().isPresent());
        return onWindow(find).orElseThrow();
    }

    /** Returns a node's place on the screen, logical pixels. */
    static Bounds bounds(Node node) throws Exception {
        return onWindow(() -> node.localToScreen(node.getBoundsInLocal()));
    }

    /** Stores a picture of a part of the screen, logical pixels. */
    void capture(Rectangle2D part, Path file) throws Exception {
        Thread.sleep(DRAW_MS);
        var captured = onWindow(() -> robot.getScreenCapture(null, part, false));
        PixelReader pixels = captured.getPixelReader();
        BufferedImage image = new BufferedImage((int) captured.getWidth(), (int) captured.getHeight(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, pixels.getArgb(x, y));
            }
        }
        if (!ImageIO.write(image, "png", file.toFile())) {
            throw new IOException(file + ": no writer of PNG images");
        }
    }
}
