package lightning.editor.window.command;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.model.KeyBindings;
import lightning.editor.window.model.KeyLabel;

/**
 * Button that shows and records the shortcut of a command. A click starts recording; the next key is assigned, after a second press if
 * another command has it.
 *
 * <p>Delete clears the shortcut, Home restores the default, Escape cancels.
 */
public final class KeyBindingButton extends Button {
    private static final PseudoClass CHANGED = PseudoClass.getPseudoClass("changed");

    private final KeyBindings keyBindings;
    private final Command command;
    private final Label message;
    private boolean isRecording;
    /** Key of another command, reassigned when pressed again. */
    private Optional<KeyCodeCombination> conflictingKey = Optional.empty();

    /** @param message  shows the result of a key press */
    public KeyBindingButton(KeyBindings keyBindings, Command command, Label message) {
        this.keyBindings = keyBindings;
        this.command = command;
        this.message = message;
        setId("key-" + command.id());
        getStyleClass().addAll("small", "key-button");
        setMinWidth(USE_PREF_SIZE);
        setTooltip(new Tooltip(Messages.tr("Click, then press the new shortcut.\nDelete: none. Home: default. Esc: cancel.")));
        setOnAction(_ -> startRecording());
        addEventFilter(KeyEvent.KEY_PRESSED, this::press);
        focusedProperty().subscribe(is -> {
            if (!is) {
                stopRecording();
            }
        });
        keyBindings.changesProperty().subscribe(_ -> refresh());
    }

    private void startRecording() {
        isRecording = true;
        conflictingKey = Optional.empty();
        setText(Messages.tr("press a key…"));
        message.setText("");
    }

    private void press(KeyEvent e) {
        if (!isRecording) {
            return;
        }
        e.consume();
        switch (e.getCode()) {
            case ESCAPE -> stopRecording();
            case DELETE, BACK_SPACE -> set(Optional.empty());
            case HOME -> {
                isRecording = false;
                keyBindings.reset(command);
            }
            case KeyCode _ -> KeyBindings.fromEvent(e).ifPresent(this::assign);
        }
    }

    private void assign(KeyCodeCombination key) {
        Optional<String> invalidReason = KeyBindings.invalidReason(key);
        Optional<Command> owner = keyBindings.owner(key).filter(c -> c != command);
        if (invalidReason.isPresent()) {
            message.setText(invalidReason.get());
        } else if (owner.isPresent() && !conflictingKey.equals(Optional.of(key))) {
            conflictingKey = Optional.of(key);
            message.setText(Messages.tr("{0} is assigned to {1}; press it again to reassign it", KeyLabel.text(key),
                    owner.get().plainTitle()));
        } else {
            set(Optional.of(key));
        }
    }

    private void set(Optional<KeyCombination> key) {
        isRecording = false;
        message.setText("");
        keyBindings.set(command, key);
    }

    private void stopRecording() {
        isRecording = false;
        message.setText("");
        refresh();
    }

    private void refresh() {
        if (!isRecording) {
            String key = keyBindings.text(command);
            setText(key.isEmpty() ? Messages.tr("none") : key);
            setAccessibleText(Messages.tr("Shortcut of {0}: {1}", command.plainTitle(), getText()));
            pseudoClassStateChanged(CHANGED, keyBindings.isChanged(command));
        }
    }
}
