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
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.window.model.Keys;
import lightning.editor.window.model.SpokenKey;

/**
 * The key of a command. A click, and the next key is taken: at once where it is free, at a second press where another command has it.
 * Delete takes the key away, Home brings the program's own back, Escape ends it.
 */
public final class KeyButton extends Button {
    private static final PseudoClass CHANGED = PseudoClass.getPseudoClass("changed");

    private final Keys keys;
    private final Command command;
    private final Label told;
    private boolean listening;
    /** Another command has it: pressed again, it is taken. */
    private Optional<KeyCodeCombination> asked = Optional.empty();

    /** @param told says what comes of a press */
    public KeyButton(Keys keys, Command command, Label told) {
        this.keys = keys;
        this.command = command;
        this.told = told;
        setId("key-" + command.id());
        getStyleClass().addAll("small", "key-button");
        setMinWidth(USE_PREF_SIZE);
        setTooltip(new Tooltip(Texts.of("Click, then press another key.\nDelete: no key. Home: the program's own. Escape: as it was.")));
        setOnAction(_ -> listen());
        addEventFilter(KeyEvent.KEY_PRESSED, this::press);
        focusedProperty().subscribe(is -> {
            if (!is) {
                end();
            }
        });
        keys.changesProperty().subscribe(_ -> show());
    }

    private void listen() {
        listening = true;
        asked = Optional.empty();
        setText(Texts.of("press a key …"));
        told.setText("");
    }

    private void press(KeyEvent e) {
        if (!listening) {
            return;
        }
        e.consume();
        switch (e.getCode()) {
            case ESCAPE -> end();
            case DELETE, BACK_SPACE -> set(Optional.empty());
            case HOME -> {
                listening = false;
                keys.reset(command);
            }
            case KeyCode _ -> Keys.pressed(e).ifPresent(this::take);
        }
    }

    private void take(KeyCodeCombination key) {
        Optional<String> obstacle = Keys.obstacle(key);
        Optional<Command> owner = keys.owner(key).filter(c -> c != command);
        if (obstacle.isPresent()) {
            told.setText(obstacle.get());
        } else if (owner.isPresent() && !asked.equals(Optional.of(key))) {
            asked = Optional.of(key);
            told.setText(Texts.of("{0} is {1}'s: press again to take it", SpokenKey.text(key), owner.get().plainTitle()));
        } else {
            set(Optional.of(key));
        }
    }

    private void set(Optional<KeyCombination> key) {
        listening = false;
        told.setText("");
        keys.set(command, key);
    }

    private void end() {
        listening = false;
        told.setText("");
        show();
    }

    private void show() {
        if (!listening) {
            String key = keys.text(command);
            setText(key.isEmpty() ? Texts.of("none") : key);
            setAccessibleText(Texts.of("Key of {0}: {1}", command.plainTitle(), getText()));
            pseudoClassStateChanged(CHANGED, keys.isChanged(command));
        }
    }
}
