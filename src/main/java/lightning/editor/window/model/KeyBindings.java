package lightning.editor.window.model;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.ReadOnlyLongProperty;
import javafx.beans.property.ReadOnlyLongWrapper;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.base.text.Messages;
import lightning.editor.document.Command;

/** The keys of the commands: those that the program gives them, until the artist gives them others. No two have the same. */
public final class KeyBindings {
    private static final String NONE = "none";

    /** What the artist chose; null for a command that shall have no key. */
    private final Map<Command, KeyCombination> customBindings = new EnumMap<>(Command.class);
    private final ReadOnlyLongWrapper changes = new ReadOnlyLongWrapper();

    /** Changes whenever a key has. */
    public ReadOnlyLongProperty changesProperty() {
        return changes.getReadOnlyProperty();
    }

    /** The key of a command; empty where it has none. */
    public Optional<KeyCombination> binding(Command command) {
        return customBindings.containsKey(command) ? Optional.ofNullable(customBindings.get(command)) : defaultBinding(command);
    }

    private static Optional<KeyCombination> defaultBinding(Command command) {
        return command.shortcut().isEmpty() ? Optional.empty() : Optional.of(KeyCombination.valueOf(command.shortcut()));
    }

    /** As {@link KeyLabel} writes it; empty where there is none. */
    public String text(Command command) {
        return binding(command).map(KeyLabel::text).orElse("");
    }

    /** Whether a key is a command's. */
    public boolean matches(Command command, KeyEvent event) {
        return binding(command).filter(k -> k.match(event)).isPresent();
    }

    /** Whether the artist changed it. */
    public boolean isChanged(Command command) {
        return !binding(command).equals(defaultBinding(command));
    }

    /** Who has a key; empty if it is free. */
    public Optional<Command> owner(KeyCombination key) {
        return Stream.of(Command.values()).filter(c -> binding(c).filter(key::equals).isPresent()).findFirst();
    }

    /** Gives a command a key, which is taken from whoever has it; or none, for an empty one. */
    public void set(Command command, Optional<KeyCombination> key) {
        key.flatMap(this::owner).ifPresent(owner -> put(owner, Optional.empty()));
        put(command, key);
        changes.set(changes.get() + 1);
    }

    /** Gives a command the program's own key again, which is taken from whoever has it. */
    public void reset(Command command) {
        set(command, defaultBinding(command));
    }

    /** Gives all commands the program's own keys again. */
    public void reset() {
        customBindings.clear();
        changes.set(changes.get() + 1);
    }

    private void put(Command command, Optional<KeyCombination> key) {
        if (key.equals(defaultBinding(command))) {
            customBindings.remove(command);
        } else {
            customBindings.put(command, key.orElse(null));
        }
    }

    /** The key that was pressed, as a command may have it; empty for a modifier alone. */
    public static Optional<KeyCodeCombination> fromEvent(KeyEvent event) {
        KeyCode code = event.getCode();
        return code.isModifierKey() || code == KeyCode.UNDEFINED ? Optional.empty() : Optional.of(new KeyCodeCombination(code,
                modifier(event.isShiftDown()), KeyCombination.ModifierValue.UP, modifier(event.isAltDown()),
                KeyCombination.ModifierValue.UP, modifier(event.isShortcutDown())));
    }

    private static KeyCombination.ModifierValue modifier(boolean down) {
        return down ? KeyCombination.ModifierValue.DOWN : KeyCombination.ModifierValue.UP;
    }

    /** Why no command may have a key, a clause; empty if one may. */
    public static Optional<String> invalidReason(KeyCodeCombination key) {
        boolean hasModifier = key.getShortcut() == KeyCombination.ModifierValue.DOWN || key.getAlt() == KeyCombination.ModifierValue.DOWN;
        if (!hasModifier && !key.getCode().isFunctionKey()) {
            return Optional
                    .of(Messages.tr("{0} needs Ctrl or Alt; only function keys work alone", KeyLabel.text(key)));
        }
        boolean hasShortcutOnly = key.getShift() == KeyCombination.ModifierValue.UP && key.getAlt() == KeyCombination.ModifierValue.UP;
        boolean isTextKey =
                key.getCode() == KeyCode.C || key.getCode() == KeyCode.V || key.getCode() == KeyCode.X || key.getCode() == KeyCode.A;
        return hasShortcutOnly && hasModifier && isTextKey
                ? Optional.of(Messages.tr("{0} is reserved for editing text", KeyLabel.text(key)))
                : Optional.empty();
    }

    /** Takes what was remembered; a key that is damaged counts as not changed. */
    public void restore(Preferences preferences) {
        for (Command command : Command.values()) {
            String text = preferences.text("key." + command.name(), "");
            try {
                if (!text.isEmpty()) {
                    set(command, text.equals(NONE) ? Optional.empty() : Optional.of(KeyCombination.valueOf(text)));
                }
            } catch (IllegalArgumentException e) {
                // It stays as it was.
            }
        }
    }

    /** Keeps what was changed. */
    public void save(Preferences preferences) {
        for (Command command : Command.values()) {
            preferences.set("key." + command.name(),
                    isChanged(command) ? binding(command).map(KeyCombination::getName).orElse(NONE) : "");
        }
    }
}
