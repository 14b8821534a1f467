package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Spinner;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** The editor can be used with a screen reader and without a mouse. */
class AccessibilityTest extends EditorFixture {
    private static final int MANY = 200;
    private static final Set<String> PANES = Set.of("toolbar", "traced", "preview", "lists", "side");

    /** Returns all controls that take keyboard focus, without parts of other controls. */
    private Set<Node> controls() {
        return robot.lookup(n -> n.isFocusTraversable() && !(n instanceof ScrollPane) && !isPart(n)).queryAll();
    }

    private static boolean isPart(Node node) {
        for (Node p = node.getParent(); p != null; p = p.getParent()) {
            if (p instanceof Spinner) {
                return true;
            }
        }
        return false;
    }

    private void selectShape() {
        robot.interact(() -> model().editor().selection().selectNode("ball"));
        waitFor("the list of shapes is in front", () -> robot.lookup("#shape-list").tryQuery().isPresent());
        FastRobot.settle();
    }

    @Test
    void shapeControls_areNamedAndReachableByTab() {
        selectShape();
        everyControl_isNamedForScreenReaders();
        everyControl_isReachableByTab();
    }

    @Test
    void tabKey_visitsPanesTopDownAndLeftToRight() {
        assertThat(wrongTabOrders()).isEmpty();
        selectShape();
        assertThat(wrongTabOrders()).isEmpty();
        robot.interact(() -> model().editor().materialShownProperty().set(true));
        FastRobot.settle();
        assertThat(wrongTabOrders()).isEmpty();
    }

    /** Returns the places where the Tab key moves up, or to the left, within a pane. */
    private List<String> wrongTabOrders() {
        List<String> wrong = new ArrayList<>();
        Node first = stage.getScene().getFocusOwner();
        Node a = first;
        for (int i = 0; i < MANY && (i == 0 || a != first); i++) {
            robot.push(KeyCode.TAB);
            Node b = stage.getScene().getFocusOwner();
            // Compares positions after scrolling: the focused control is scrolled into view.
            Bounds from = a.localToScene(a.getLayoutBounds());
            Bounds to = b.localToScene(b.getLayoutBounds());
            boolean up = to.getMaxY() <= from.getMinY();
            boolean beside = to.getMinY() < from.getMaxY() && from.getMinY() < to.getMaxY();
            if (!pane(a).isEmpty() && pane(a).equals(pane(b)) && (up || beside && to.getMaxX() <= from.getMinX())) {
                wrong.add(pane(a) + ": " + a + " → " + b);
            }
            a = b;
        }
        return wrong;
    }

    private static String pane(Node node) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (n.getId() != null && PANES.contains(n.getId())) {
                return n.getId();
            }
        }
        return "";
    }

    @Test
    void everyControl_isNamedForScreenReaders() {
        assertThat(controls()).hasSizeGreaterThan(40);
        assertThat(controls().stream().filter(n -> n.getAccessibleText() == null && !(n instanceof Labeled labeled
                && labeled.getText() != null && !labeled.getText().isEmpty()))).isEmpty();
    }

    @Test
    void everyDisabledControl_saysWhy() {
        Set<Node> disabled = controls().stream().filter(Node::isDisabled)
                .filter(n -> n instanceof Button || n instanceof ToggleButton || n instanceof TextField || n instanceof MenuButton)
                .collect(Collectors.toSet());
        assertThat(disabled).hasSizeGreaterThan(5);
        assertThat(disabled.stream().filter(n -> n.getAccessibleHelp() == null || n.getAccessibleHelp().isEmpty())).isEmpty();
    }

    @Test
    void everyControl_isReachableByTab() {
        // In a toggle group, the Tab key reaches the selected toggle and the arrow keys the others.
        Set<Node> wanted = controls().stream().filter(n -> !n.isDisabled() && isVisible(n))
                .filter(n -> !(n instanceof ToggleButton t) || t.getToggleGroup() == null || t.isSelected()).collect(Collectors.toSet());
        Set<Node> reached = new HashSet<>();
        for (int i = 0; i < MANY && !reached.containsAll(wanted); i++) {
            robot.push(KeyCode.TAB);
            reached.add(stage.getScene().getFocusOwner());
        }
        wanted.removeAll(reached);
        assertThat(wanted).isEmpty();
    }

    private static boolean isVisible(Node node) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (!n.isVisible()) {
                return false;
            }
        }
        return true;
    }
}
