package lightning.editor.window.model;

import java.util.Set;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.base.text.Messages;

/** Key combination with a localized display text, for example {@code Strg+Umschalt+P}. JavaFX always writes {@code Ctrl} in menus. */
public final class KeyLabel extends KeyCombination {
    private static final Set<String> MODIFIERS = Set.of(Messages.key("Ctrl"), Messages.key("Shift"), Messages.key("Alt"));
    private static final Set<String> NAMED_KEYS =
            Set.of(Messages.key("Delete"), Messages.key("Insert"), Messages.key("Home"), Messages.key("End"),
                    Messages.key("Space"), Messages.key("Backspace"), Messages.key("Page Up"), Messages.key("Page Down"));

    private final KeyCombination key;

    /** Creates a label of a key combination. */
    public KeyLabel(KeyCombination key) {
        super(key.getShift(), key.getControl(), key.getAlt(), key.getMeta(), key.getShortcut());
        this.key = key;
    }

    /** Returns the localized text of a key combination, for example {@code Strg+Umschalt+P}. */
    public static String text(KeyCombination key) {
        var text = new StringBuilder();
        String rest = key.getDisplayText();
        int plus = rest.indexOf('+');
        while (plus > 0 && MODIFIERS.contains(rest.substring(0, plus))) {
            text.append(Messages.tr(rest.substring(0, plus))).append('+');
            rest = rest.substring(plus + 1);
            plus = rest.indexOf('+');
        }
        // The toolkit's name of the key is not the one printed on it.
        return text.append(isEscape(key) ? Messages.tr("Esc") : NAMED_KEYS.contains(rest) ? Messages.tr(rest) : rest).toString();
    }

    private static boolean isEscape(KeyCombination key) {
        return key instanceof KeyCodeCombination combination && combination.getCode() == KeyCode.ESCAPE;
    }

    @Override
    public boolean match(KeyEvent event) {
        return key.match(event);
    }

    @Override
    public String getName() {
        return key.getName();
    }

    @Override
    public String getDisplayText() {
        return text(key);
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof KeyLabel other && key.equals(other.key);
    }

    @Override
    public int hashCode() {
        return key.hashCode();
    }
}
