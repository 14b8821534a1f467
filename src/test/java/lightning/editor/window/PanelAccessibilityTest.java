package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Labeled;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.stage.Window;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.Contrast;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Accessibility of the secondary windows, and of the main window in both themes: contrast, and use without a mouse. */
class PanelAccessibilityTest extends EditorFixture {
    private static final int MANY = 120;
    private static final List<Command> PANELS = List.of(Command.ACCURACY_PANEL, Command.COMPARE_SETTINGS, Command.EFFECTS_PANEL,
            Command.KEYS, Command.SCOPES,
            Command.HISTORY_PANEL, Command.UPDATES_PANEL, Command.MIXER, Command.LOOKS, Command.CONTRIBUTIONS, Command.LIGHT_LINKS,
            Command.PALETTE, Command.ABOUT);

    @BeforeEach
    void openPanelsInWindows() {
        floatPanels();
    }

    @AfterEach
    void closeWindows() {
        robot.interact(() -> {
            panels().forEach(Window::hide);
            ColorTheme.DARK.apply();
        });
    }

    private List<Window> panels() {
        return List.copyOf(Window.getWindows()).stream().filter(window -> window != stage).toList();
    }

    private Window open(Command command) {
        robot.interact(() -> model().commands().run(command));
        waitFor(command + " is open and has the keyboard", () -> panels().size() == 1 && panels().getFirst().isFocused());
        return panels().getFirst();
    }

    private void closePanel() {
        closePanels();
    }

    private static Stream<Node> nodes(Node node) {
        return Stream.concat(Stream.of(node), node instanceof Parent p ? p.getChildrenUnmodifiable().stream().filter(Node::isVisible)
                .flatMap(PanelAccessibilityTest::nodes) : Stream.empty());
    }

    private static List<Node> controls(Window window) {
        return nodes(window.getScene().getRoot()).filter(n -> n.isFocusTraversable() && !(n instanceof ScrollPane)).toList();
    }

    private static boolean isNamed(Node node) {
        return node.getAccessibleText() != null && !node.getAccessibleText().isEmpty()
                || node instanceof Labeled l && l.getText() != null && !l.getText().isEmpty();
    }

    @Test
    void panelControls_areNamedAndReachableByTab() {
        List<String> found = new ArrayList<>();
        for (Command command : PANELS) {
            Window window = open(command);
            robot.interact(
                    () -> controls(window).stream().filter(n -> !isNamed(n)).map(n -> command + ": no name of " + n).forEach(found::add));
            Set<Node> wanted = controls(window).stream().filter(n -> !n.isDisabled())
                    .filter(n -> !(n instanceof ToggleButton t) || t.getToggleGroup() == null || t.isSelected())
                    .collect(Collectors.toSet());
            Set<Node> reached = new HashSet<>();
            for (int i = 0; i < MANY && !reached.containsAll(wanted); i++) {
                reached.add(window.getScene().getFocusOwner());
                robot.push(KeyCode.TAB);
            }
            wanted.removeAll(reached);
            wanted.forEach(n -> found.add(command + ": not reached " + n));
            closePanel();
        }
        assertThat(found).isEmpty();
    }

    @Test
    void dialogButtons_areReachableByTabAndEscapeCancels() {
        robot.interact(() -> model().editor().edit(scene -> LightEdits.edit(scene, "lamp", l -> l.withIntensity(0.5))));
        // The command blocks until the dialog is answered.
        Platform.runLater(() -> model().commands().run(Command.QUIT));
        waitFor("the dialog opens", () -> panels().size() == 1 && panels().getFirst().isFocused());
        Window question = panels().getFirst();
        List<Node> wanted = controls(question);
        assertThat(wanted).hasSize(3).allMatch(PanelAccessibilityTest::isNamed);
        Set<Node> reached = new HashSet<>();
        for (Node _ : wanted) {
            reached.add(question.getScene().getFocusOwner());
            robot.push(KeyCode.TAB);
        }
        assertThat(reached).containsAll(wanted);
        robot.push(KeyCode.ESCAPE);
        waitFor("all panels are closed", () -> panels().isEmpty());
        assertThat(stage.isShowing()).isTrue();
    }

    @Test
    void textsAndIcons_haveEnoughContrastInBothThemes() {
        List<String> found = new ArrayList<>();
        for (ColorTheme looks : ColorTheme.values()) {
            robot.interact(looks::apply);
            for (boolean materials : new boolean[] {true, false}) {
                robot.interact(() -> model().editor().materialShownProperty().set(materials));
                collect(stage, looks + " editor", found);
            }
            for (Command command : PANELS) {
                collect(open(command), looks + " " + command, found);
                closePanel();
            }
        }
        assertThat(found).isEmpty();
    }

    private void collect(Window window, String where, List<String> found) {
        robot.interact(() -> {
            Parent root = window.getScene().getRoot();
            root.applyCss();
            root.layout();
            Contrast.findLowContrast(root).forEach(line -> found.add(where + ": " + line));
        });
    }

    @Test
    void focusMark_hasEnoughContrastInBothThemes() {
        for (ColorTheme looks : ColorTheme.values()) {
            robot.interact(() -> {
                looks.apply();
                var mark = new Region();
                mark.setStyle("-fx-background-color: -color-accent-emphasis;");
                var ground = new Region();
                ground.setStyle("-fx-background-color: -color-bg-default;");
                var frame = (javafx.scene.layout.Pane) robot.lookup("#lights").queryParent();
                frame.getChildren().addAll(mark, ground);
                frame.applyCss();
                assertThat(Contrast.ratio(color(mark), color(ground))).as(looks.name()).isGreaterThanOrEqualTo(Contrast.MIN_ICON_RATIO);
                frame.getChildren().removeAll(mark, ground);
            });
        }
    }

    private static Color color(Region region) {
        return (Color) region.getBackground().getFills().getFirst().getFill();
    }
}
