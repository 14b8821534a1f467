package lightning.editor.window;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import lightning.base.text.Messages;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.SceneWarnings;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;

/** Warnings about the edited scene in the status line. A warning stays until its cause is gone or the user clicks it. */
final class WarningBar extends Button {
    private final SceneEditor editor;
    private final Tooltip details = new Tooltip();
    /** Warnings that the user has dismissed in the open document. */
    private final Set<String> dismissed = new HashSet<>();

    WarningBar(SceneEditor editor) {
        super("", new FontIcon(MaterialDesignA.ALERT_OUTLINE));
        this.editor = editor;
        setId("warning");
        getStyleClass().addAll("status-button", "status-warning");
        setMnemonicParsing(false);
        setMinWidth(0);
        setTooltip(details);
        details.setWrapText(true);
        managedProperty().bind(visibleProperty());
        setOnAction(_ -> {
            dismissed.addAll(SceneWarnings.of(editor.scene()));
            update();
        });
        editor.documentProperty().subscribe(_ -> dismissed.clear());
        editor.sceneProperty().subscribe(_ -> update());
    }

    private void update() {
        List<String> warnings = SceneWarnings.of(editor.scene());
        dismissed.retainAll(warnings);
        String text = String.join(" · ", warnings.stream().filter(w -> !dismissed.contains(w)).toList());
        setText(text);
        setAccessibleText(text.isEmpty() ? Messages.tr("Warning") : text);
        setVisible(!text.isEmpty());
        details.setText(Messages.tr("{0}\nClick to hide this warning.", text));
    }
}
