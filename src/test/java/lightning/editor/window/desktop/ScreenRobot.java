package lightning.editor.window.desktop;

import java.awt.GraphicsEnvironment;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;

/**
 * Operates the packaged program through the screen: reads only pixels, uses only mouse and keyboard. Opens a scene, finds its picture on
 * the screen, moves a light, presses Go, saves, and finds the picture of the saved scene. The program's own command line renders the
 * expected pictures. Exits with 0 on success.
 */
final class ScreenRobot {
    private static final String PROGRAM = "target/lightning/bin/lightning";
    private static final long TIMEOUT_NS = TimeUnit.SECONDS.toNanos(90);
    private static final int PAUSE_MS = 100;

    private final Robot robot;
    private final Path folder;
    private final Path scene;

    private ScreenRobot(Path folder) throws Exception {
        this.folder = folder;
        scene = folder.resolve("scene.jen");
        robot = new Robot();
        robot.setAutoDelay(20);
    }

    public static void main(String[] args) throws Exception {
        System.exit(new ScreenRobot(Path.of(args[0])).run() ? 0 : 1);
    }

    private boolean run() throws Exception {
        Files.copy(Path.of("scenes/balls.jen"), scene);
        copyTextures();
        // The picture has the size of those that the command line renders.
        Files.writeString(Files.createDirectories(folder.resolve("data")).resolve("preferences.properties"), "working-size=SCENE\n");
        BufferedImage before = rendered("before.png");
        Process editor = startProgram("editor", scene.toString());
        try {
            // The window opens before it receives keys.
            return waitFor("a window", () -> !isBlank(screen())) && waitFor("the picture of the scene", () -> zoom() && shows(before))
                    && edit() && waitFor("the picture of the edited scene", this::showsEdited) && quit(editor);
        } finally {
            if (editor.isAlive()) {
                ImageIO.write(screen(), "png", new File("target/window.png"));
                editor.descendants().forEach(ProcessHandle::destroyForcibly);
                editor.destroyForcibly();
            }
        }
    }

    private interface ScreenCheck {
        boolean isThere() throws Exception;
    }

    /** Polls until a check succeeds. */
    private boolean waitFor(String description, ScreenCheck check) throws Exception {
        long end = System.nanoTime() + TIMEOUT_NS;
        while (System.nanoTime() < end) {
            if (check.isThere()) {
                return true;
            }
            robot.delay(PAUSE_MS);
        }
        System.out.println("did not see " + description);
        return false;
    }

    /** Zooms to actual pixels with the keyboard. Without a window manager, keys go to the window under the mouse. */
    private boolean zoom() {
        BufferedImage screen = screen();
        robot.mouseMove(screen.getWidth() / 2, screen.getHeight() / 2);
        type(KeyEvent.VK_CONTROL, KeyEvent.VK_1);
        return true;
    }

    /** Moves the selected light, renders and saves. */
    private boolean edit() throws Exception {
        String text = Files.readString(scene);
        for (int i = 0; i < 5; i++) {
            type(KeyEvent.VK_CONTROL, KeyEvent.VK_RIGHT);
        }
        type(KeyEvent.VK_F5);
        type(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
        return waitFor("the saved scene", () -> !Files.readString(scene).equals(text));
    }

    /** Requests reflections repeatedly, because the request has no effect until Go is done. */
    private boolean showsEdited() throws Exception {
        type(KeyEvent.VK_F6);
        return shows(rendered("after.png"));
    }

    private boolean quit(Process editor) throws Exception {
        type(KeyEvent.VK_CONTROL, KeyEvent.VK_Q);
        boolean ended = editor.waitFor(30, TimeUnit.SECONDS) && editor.exitValue() == 0;
        if (!ended) {
            System.out.println("did not see the program end well");
        }
        return ended;
    }

    private void type(int... keys) {
        for (int key : keys) {
            robot.keyPress(key);
        }
        for (int i = keys.length; i-- > 0;) {
            robot.keyRelease(keys[i]);
        }
    }

    private BufferedImage screen() {
        return robot.createScreenCapture(GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice()
                .getDefaultConfiguration().getBounds());
    }

    private static boolean isBlank(BufferedImage image) {
        int[] pixels = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        for (int pixel : pixels) {
            if (pixel != pixels[0]) {
                return false;
            }
        }
        return true;
    }

    /** Returns whether every pixel of a picture appears somewhere on the screen. */
    private boolean shows(BufferedImage picture) {
        BufferedImage screen = screen();
        for (int y = 0; y + picture.getHeight() <= screen.getHeight(); y++) {
            for (int x = 0; x + picture.getWidth() <= screen.getWidth(); x++) {
                if (isAt(screen, picture, x, y)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean isAt(BufferedImage screen, BufferedImage picture, int left, int top) {
        for (int y = picture.getHeight() / 2, seen = 0; seen < picture.getHeight(); y = (y + 1) % picture.getHeight(), seen++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                if ((screen.getRGB(left + x, top + y) & 0xFFFFFF) != (picture.getRGB(x, y) & 0xFFFFFF)) {
                    return false;
                }
            }
        }
        return true;
    }

    private BufferedImage rendered(String name) throws IOException, InterruptedException {
        Path file = folder.resolve(name);
        if (!Files.exists(file) && startProgram("render", "render", scene.toString(), "-o", file.toString()).waitFor() != 0) {
            throw new IOException("the scene could not be rendered");
        }
        return ImageIO.read(file.toFile());
    }

    private Process startProgram(String log, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(PROGRAM));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true)
                .redirectOutput(folder.resolve(log + ".log").toFile());
        builder.environment().put("JAVA_TOOL_OPTIONS", "-Dlightning.data=" + folder.resolve("data"));
        return builder.start();
    }

    private void copyTextures() throws IOException {
        Path textures = Files.createDirectory(folder.resolve("textures"));
        try (var files = Files.list(Path.of("textures"))) {
            for (Path file : files.toList()) {
                Files.copy(file, textures.resolve(file.getFileName()));
            }
        }
    }
}
