package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.geometry.Bounds;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Labeled;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.SplitPane;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import javafx.scene.text.Text;
import javafx.stage.Stage;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.widget.WindowPlacement;
import org.junit.jupiter.api.Test;
import org.kordamp.ikonli.javafx.FontIcon;

/** On a small screen, or a large one at scale 2, everything can be reached. */
class SmallWindowTest extends EditorFixture {

    private void resize(double width, double height) {
        robot.interact(() -> {
            stage.setWidth(width);
            stage.setHeight(height);
        });
        // The window receives its new size later.
        waitFor("the window is so wide", () -> stage.getScene().getWidth() == width && stage.getScene().getHeight() == height);
        FastRobot.settle();
    }

    private static Bounds screenBounds(Node node) {
        return ScreenBounds.of(node);
    }

    private Bounds window() {
        return screenBounds(stage.getScene().getRoot());
    }

    private List<Region> panes() {
        return List.of("#traced", "#preview", "#lights", "#side").stream().map(id -> robot.lookup(id).<Region>query()).toList();
    }

    @Test
    void everyPane_fitsInWindow() {
        resize(960, 540);
        for (Region pane : panes()) {
            assertThat(window().contains(screenBounds(pane))).as(pane.getId()).isTrue();
            assertThat(pane.getWidth()).as(pane.getId()).isGreaterThan(150);
            assertThat(pane.getHeight()).as(pane.getId()).isGreaterThan(80);
        }
    }

    @Test
    void headerControls_fitInPane() {
        resize(960, 540);
        for (String pane : new String[] {"#traced", "#preview"}) {
            Bounds all = screenBounds(robot.lookup(pane).query());
            Set<Node> controls = robot.from(robot.lookup(pane + " .pane-header").<Node>query()).lookup(Node::isFocusTraversable).queryAll();
            assertThat(controls).hasSizeGreaterThan(4);
            assertThat(controls.stream().filter(c -> isVisible(c) && !all.contains(screenBounds(c))).map(Node::getId)).isEmpty();
        }
    }

    @Test
    void pixelReport_isNotClipped() {
        resize(960, 540);
        Label line = robot.lookup("#pixel").query();
        robot.moveTo("#traced-picture");
        waitFor("the text is shown", () -> line.getText().contains("normal"));
        FastRobot.settle();
        assertThat(robot.from(line).lookup(".text").<Text>query().getText()).isEqualTo(line.getText());
    }

    @Test
    void pixelLine_whileHovered_stays() {
        Label line = robot.lookup("#pixel").query();
        robot.moveTo("#traced-picture");
        waitFor("the text is shown", () -> line.getText().contains("normal"));
        robot.moveTo("#pixel");
        FastRobot.settle();
        assertThat(line.getText()).contains("normal");
        assertThat(line.getTooltip().getText()).isEqualTo(line.getText());
        robot.moveTo("#lights");
        waitFor("the text is cleared", () -> line.getText().isBlank());
        assertThat(line.getTooltip()).isNull();
    }

    @Test
    void lastProperty_isReachableByScrolling() {
        resize(960, 540);
        ScrollPane scroll = robot.lookup("#properties .scroll-pane").query();
        robot.interact(() -> scroll.setVvalue(1));
        FastRobot.settle();
        Node last = List.copyOf(robot.lookup("#properties .section").queryAllAs(Node.class)).getLast();
        assertThat(screenBounds(scroll).getMaxY()).isGreaterThanOrEqualTo(screenBounds(last).getMaxY());
        assertThat(window().getMaxY()).isGreaterThanOrEqualTo(screenBounds(last).getMaxY());
    }

    @Test
    void toolBar_movesExcessToOverflow() {
        resize(860, 540);
        Node overflow = robot.lookup("#toolbar .tool-bar-overflow-button").query();
        waitFor("the tool bar has an overflow", overflow::isVisible);
        assertThat(window()).as(screenBounds(overflow) + " is in it").matches(b -> b.contains(screenBounds(overflow)));
        assertThat(screenBounds(overflow).getWidth()).isGreaterThan(8);
        robot.clickOn(overflow);
        // A layout of the tool bar removes its buttons from the menu and adds them again, so only the window's thread sees them reliably.
        waitFor("the overflow menu shows hidden items", () -> robot.lookup("#effects-panel").tryQuery().isPresent());
        robot.push(KeyCode.ESCAPE);
    }

    @Test
    void toolBarLabel_staysWithItsControl() {
        for (double width : new double[] {860, 960, 1300}) {
            resize(width, 540);
            FastRobot.settle();
            Node bar = robot.lookup("#toolbar").query();
            boolean named = robot.from(bar).lookup("Bounces").tryQuery().filter(SmallWindowTest::isVisible).isPresent();
            boolean isDepthShown = robot.from(bar).lookup("#depth").tryQuery().filter(SmallWindowTest::isVisible).isPresent();
            assertThat(named).as("the name next to the control, at width " + width).isEqualTo(isDepthShown);
        }
    }

    /** Returns whether a node and all its parents are visible. */
    private static boolean isVisible(Node node) {
        return node == null || node.isVisible() && isVisible(node.getParent());
    }

    @Test
    void enlarging_restoresEveryPane() {
        resize(1000, 700);
        List<Bounds> before = panes().stream().map(SmallWindowTest::screenBounds).toList();
        resize(860, 500);
        resize(1000, 700);
        List<Bounds> after = panes().stream().map(SmallWindowTest::screenBounds).toList();
        for (int i = 0; i < before.size(); i++) {
            assertThat(after.get(i).getWidth()).as(panes().get(i).getId()).isCloseTo(before.get(i).getWidth(), within(2.0));
            assertThat(after.get(i).getHeight()).as(panes().get(i).getId()).isCloseTo(before.get(i).getHeight(), within(2.0));
        }
    }

    @Test
    void window_hasMinimumSize() {
        assertThat(stage.getMinWidth()).isBetween(600.0, 960.0);
        assertThat(stage.getMinHeight()).isBetween(300.0, 540.0);
        assertThat(robot.lookup(".split-pane").queryAllAs(SplitPane.class)).isNotEmpty();
    }

    @Test
    void headerLabels_areNotClipped() {
        for (double width : new double[] {1000, 960}) {
            resize(width, 540);
            robot.interact(() -> model().commands().run(Command.VERIFY));
            waitFor("the picture is verified", () -> isShown("difference"));
            FastRobot.settle();
            Set<String> cut = robot.lookup(n -> n instanceof Labeled && isIn(n, "pane-header", "tool-bar", "lights-tools"))
                    .queryAllAs(Labeled.class).stream().filter(l -> isVisible(l) && isClipped(l)).map(Labeled::getText)
                    .collect(Collectors.toSet());
            assertThat(cut).isEmpty();
        }
    }

    @Test
    void badge_isNotClipped() {
        resize(860, 540);
        robot.interact(() -> {
            model().accuracyModeProperty().set(AccuracyMode.ON_DEMAND);
            model().editor().edit(scene -> LightEdits.edit(scene, "lamp", l -> l.withIntensity(0.5)));
            model().editor().go();
        });
        waitFor("mirrors are older", () -> isShown("mirrors"));
        FastRobot.settle();
        Labeled badge = robot.lookup("#mirrors").query();
        assertThat(screenBounds(robot.lookup("#traced").query()).contains(screenBounds(badge))).isTrue();
        assertThat(textOf(badge)).isEqualToIgnoringWhitespace(badge.getText());
    }

    /** Returns the displayed text of a label. */
    private static String textOf(Labeled labeled) {
        return labeled.getChildrenUnmodifiable().stream().filter(n -> n instanceof Text t && !(n instanceof FontIcon))
                .map(n -> ((Text) n).getText()).collect(Collectors.joining());
    }

    @Test
    void accuracyNames_areNotClipped() {
        for (AccuracyMode precision : AccuracyMode.values()) {
            robot.interact(() -> model().accuracyModeProperty().set(precision));
            Set<String> cut = robot.lookup("#precision .label").queryAllAs(Labeled.class).stream().filter(SmallWindowTest::isClipped)
                    .map(Labeled::getText).collect(Collectors.toSet());
            assertThat(cut).isEmpty();
        }
    }

    private static boolean isIn(Node node, String... classes) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (n.getStyleClass().stream().anyMatch(Set.of(classes)::contains)) {
                return true;
            }
        }
        return false;
    }

    /** Returns whether the displayed text is shorter than the full text. */
    private static boolean isClipped(Labeled labeled) {
        return labeled.isVisible() && labeled.getText() != null && labeled.getChildrenUnmodifiable().stream()
                .anyMatch(n -> n instanceof Text t && !(n instanceof FontIcon) && !t.getText().equals(labeled.getText()));
    }

    @Test
    void panelWindow_fitsOnScreenAndScrolls() {
        robot.push(KeyCode.F1);
        FastRobot.settle();
        Node keys = robot.lookup("#keys").query();
        Stage window = (Stage) keys.getScene().getWindow();
        assertThat(window.getX()).isGreaterThanOrEqualTo(0);
        assertThat(window.getY() + window.getHeight()).isLessThanOrEqualTo(1000);
        assertThat(robot.from(keys).lookup("Rotate it").tryQuery()).isPresent();
        assertThat(robot.from(keys).lookup("Ctrl+Z").tryQuery()).isPresent();
        robot.push(KeyCode.ESCAPE);
    }

    @Test
    void windowOffScreen_isMovedBack() {
        var screen = new Rectangle2D(100, 50, 960, 540);
        assertThat(WindowPlacement.clampTo(screen, new Rectangle2D(900, -200, 400, 300))).isEqualTo(new Rectangle2D(660, 50, 400, 300));
        assertThat(WindowPlacement.clampTo(screen, new Rectangle2D(0, 400, 1600, 300))).isEqualTo(new Rectangle2D(100, 290, 960, 300));
        assertThat(WindowPlacement.clampTo(screen, new Rectangle2D(200, 100, 400, 300))).isEqualTo(new Rectangle2D(200, 100, 400, 300));
    }
}
