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
import org.jspecify.annotations.Nullable;

/** Text field that replaces a row's label while renaming, and shows why a name is refused. */
final class NameField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final Label label;
    private final BiFunction<String, String, Optional<String>> rename;
    private final Runnable onRenamed;
    private @Nullable String oldName;

    /**
     * @param label  label of the name in a row
     * @param rename  renames from the first to the second name, stripped; returns and reports a refusal
     * @param onRenamed  runs after renaming
     * @param onCanceled  runs on Escape or when focus is lost
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

    /** Replaces the label and starts editing {@code name}. */
    void open(String name) {
        oldName = name;
        setText(name);
        showRefusal(Optional.empty());
        replace(label, this);
        requestFocus();
        selectAll();
    }

    /** Restores the label. */
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
