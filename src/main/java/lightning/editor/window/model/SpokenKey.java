package lightning.editor.window.model;

import java.util.Set;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.base.text.Texts;

/**
 * A key as the editor calls it wherever it speaks of it: the window toolkit writes {@code Ctrl} in menus whatever language is spoken,
 * and where texts say {@code Strg} nobody should have to know that this is the same.
 */
public final class SpokenKey extends KeyCombination {
    private static final Set<String> MODIFIERS = Set.of(Texts.key("Ctrl"), Texts.key("Shift"), Texts.key("Alt"));
    private static final Set<String> NAMED = Set.of(Texts.key("Delete"), Texts.key("Insert"), Texts.key("Home"), Texts.key("End"),
            Texts.key("Space"), Texts.key("Backspace"), Texts.key("Page Up"), Texts.key("Page Down"));

    private final KeyCombination key;

    /** The same key. */
    public SpokenKey(KeyCombination key) {
        super(key.getShift(), key.getControl(), key.getAlt(), key.getMeta(), key.getShortcut());
        this.key = key;
    }

    /** How a key is called: {@code Strg+Umschalt+P}. */
    public static String text(KeyCombination key) {
        var text = new StringBuilder();
        String left = key.getDisplayText();
        int plus = left.indexOf('+');
        while (plus > 0 && MODIFIERS.contains(left.substring(0, plus))) {
            text.append(Texts.of(left.substring(0, plus))).append('+');
            left = left.substring(plus + 1);
            plus = left.indexOf('+');
        }
        return text.append(NAMED.contains(left) ? Texts.of(left) : left).toString();
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
        return o instanceof SpokenKey other && key.equals(other.key);
    }

    @Override
    public int hashCode() {
        return key.hashCode();
    }
}
