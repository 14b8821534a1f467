package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.Collectors;
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

/** Who does not see, or has no mouse, can use the editor too. */
class AccessTest extends EditorDesk {
    private static final int MANY = 200;

    /** All controls that take the keyboard, those left out that are parts of others. */
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
    void everyControl_isReachedByTheTabKey() {
        // In a group of switches the Tab key goes to the one that is on, and the arrow keys to the others.
        Set<Node> wanted = controls().stream().filter(n -> !n.isDisabled() && isSeen(n))
                .filter(n -> !(n instanceof ToggleButton t) || t.getToggleGroup() == null || t.isSelected()).collect(Collectors.toSet());
        Set<Node> reached = new HashSet<>();
        for (int i = 0; i < MANY && !reached.containsAll(wanted); i++) {
            robot.push(KeyCode.TAB);
            reached.add(stage.getScene().getFocusOwner());
        }
        wanted.removeAll(reached);
        assertThat(wanted).isEmpty();
    }

    private static boolean isSeen(Node node) {
        for (Node n = node; n != null; n = n.getParent()) {
            if (!n.isVisible()) {
                return false;
            }
        }
        return true;
    }
}
