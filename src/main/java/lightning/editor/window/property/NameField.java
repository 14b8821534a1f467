package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.collections.ObservableList;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Priority;
import lightning.base.text.Messages;

/** Stands in place of a name in a row while another is typed, and says why that is refused. */
final class NameField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final Label label;
    private final BiFunction<String, String, Optional<String>> rename;
    private final Runnable onRenamed;
    private String oldName;

    /**
     * @param label  what shows the name, in a row of nodes
     * @param rename gives what is called by the first name the second, stripped; tells why it refuses to, here and to the artist
     * @param onRenamed  called when it did
     * @param onCanceled   called when Escape is pressed or keys go elsewhere
     */
    NameField(Label label, BiFunction<String, String, Optional<String>> rename, Runnable onRenamed, Runnable onCanceled) {
        this.label = label;
        this.rename = rename;
        this.onRenamed = onRenamed;
        label.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(label, Priority.ALWAYS);
        HBox.setHgrow(this, Priority.ALWAYS);
        setAccessibleText(Messages.tr("new name"));
        setOnAction(_ -> rename());
        addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                onCanceled.run();
                event.consume();
            }
        });
        focusedProperty().addListener((_, was, _) -> {
            if (was) {
                onCanceled.run();
            }
        });
    }

    /** Takes the label's place; {@code name} is what shall be another. */
    void open(String name) {
        oldName = name;
        setText(name);
        showRefusal(Optional.empty());
        replace(label, this);
        requestFocus();
        selectAll();
    }

    /** Gives its place back to the label. */
    void close() {
        replace(this, label);
    }

    private void rename() {
        Optional<String> refusal = rename.apply(oldName, getText().strip());
        showRefusal(refusal);
        if (refusal.isEmpty()) {
            onRenamed.run();
        }
    }

    private void showRefusal(Optional<String> refusal) {
        pseudoClassStateChanged(REFUSED, refusal.isPresent());
        setTooltip(refusal.map(Tooltip::new).orElse(null));
        setAccessibleHelp(refusal.orElse(""));
    }

    private static void replace(Node oldNode, Node newNode) {
        if (oldNode.getParent() instanceof Pane row) {
            ObservableList<Node> nodes = row.getChildren();
            nodes.set(nodes.indexOf(oldNode), newNode);
        }
    }
}
