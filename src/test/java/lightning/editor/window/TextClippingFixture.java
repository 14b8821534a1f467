package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Labeled;
import javafx.scene.control.TextField;
import javafx.scene.text.Text;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.editor.Command;
import org.junit.jupiter.api.AfterEach;
import org.kordamp.ikonli.javafx.FontIcon;

/** No text of the editor is clipped on a small screen, in any pane or window. */
abstract class TextClippingFixture extends EditorFixture {
    private final List<String> clippedTexts = new ArrayList<>();

    @AfterEach
    void closeWindows() {
        closePanels();
    }

    /** Asserts that no text is clipped. */
    void assertNotClipped() {
        robot.interact(() -> {
            stage.setWidth(1366);
            stage.setHeight(768);
        });
        waitFor("the window is so wide", () -> stage.getScene().getWidth() == 1366);
        robot.moveTo("#traced-picture");
        waitFor("the pixel report is shown", () -> text("pixel").contains("ball") || text("pixel").contains("floor"));
        checkWindow("no light", () -> model().editor().selection().selectLight(null));
        for (String light : List.of("lamp", "sun", "stage")) {
            checkWindow(light, () -> model().editor().selection().selectLight(light));
        }
        checkWindow("material", () -> {
            model().materials().choose("matt");
            model().editor().materialShownProperty().set(true);
        });
        checkWindow("shape", () -> model().editor().selection().selectNode("ball"));
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        for (Command panel : List.of(Command.ACCURACY_PANEL, Command.COMPARE_SETTINGS, Command.EFFECTS_PANEL, Command.KEYS, Command.SCOPES,
                Command.HISTORY_PANEL,
                Command.UPDATES_PANEL, Command.MIXER, Command.LOOKS, Command.CONTRIBUTIONS, Command.LIGHT_LINKS,
                Command.PALETTE)) {
            checkWindow(panel.name(), () -> model().commands().run(panel));
            robot.interact(this::narrow);
            waitFor("windows are narrow", () -> windows().allMatch(window -> window.getScene().getWidth() <= 960));
            checkWindow(panel + " at twice the scale", () -> {});
            if (panel == Command.PALETTE) {
                checkWindow("the longest commands", () -> robot.lookup("#palette-query").<TextField>query().setText("2 ×"));
            }
            closePanels();
        }
        assertThat(clippedTexts).isEmpty();
    }

    /** Returns the secondary windows. */
    private Stream<Window> windows() {
        return Window.getWindows().stream().filter(window -> window instanceof Stage && window != stage);
    }

    /** Makes windows as small as on a screen of 1920×1080 at scale 2. */
    private void narrow() {
        windows().forEach(window -> {
            window.setWidth(Math.min(window.getWidth(), 960));
            window.setHeight(Math.min(window.getHeight(), 540));
        });
    }

    private void checkWindow(String where, Runnable how) {
        robot.interact(how);
        FastRobot.settle();
        robot.interact(() -> List.copyOf(Window.getWindows()).stream().filter(w -> w.getScene() != null).forEach(window -> {
            window.getScene().getRoot().applyCss();
            window.getScene().getRoot().layout();
            nodes(window.getScene().getRoot()).filter(Labeled.class::isInstance).map(Labeled.class::cast)
                    .filter(TextClippingFixture::isClipped)
                    .map(l -> where + ": " + l.getText() + " as " + displayedText(l) + " in " + l)
                    .filter(line -> !clippedTexts.contains(line))
                    .forEach(clippedTexts::add);
        }));
    }

    private static Stream<Node> nodes(Node node) {
        return Stream.concat(Stream.of(node), node instanceof Parent p ? p.getChildrenUnmodifiable().stream().filter(Node::isVisible)
                .flatMap(TextClippingFixture::nodes) : Stream.empty());
    }

    /** Returns the displayed text of a label. */
    private static String displayedText(Labeled labeled) {
        return labeled.getChildrenUnmodifiable().stream().filter(n -> n instanceof Text && !(n instanceof FontIcon))
                .map(n -> ((Text) n).getText()).findFirst().orElse("");
    }

    private static boolean isClipped(Labeled labeled) {
        String drawn = displayedText(labeled);
        return !drawn.isEmpty() && !drawn.strip().replace("_", "").equals(labeled.getText().strip().replace("_", ""));
    }
}
