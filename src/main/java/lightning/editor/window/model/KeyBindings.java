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
import lightning.editor.Command;

/** Keyboard shortcuts of the commands: defaults and the user's changes. No two commands share a shortcut. */
public final class KeyBindings {
    private static final String NONE = "none";

    /** The user's changes; null values mark commands without a shortcut. */
    private final Map<Command, KeyCombination> customBindings = new EnumMap<>(Command.class);
    private final ReadOnlyLongWrapper changes = new ReadOnlyLongWrapper();

    /** Counter that increases with every change of a shortcut. */
    public ReadOnlyLongProperty changesProperty() {
        return changes.getReadOnlyProperty();
    }

    /** Returns the shortcut of a command, or empty if it has none. */
    public Optional<KeyCombination> binding(Command command) {
        return customBindings.containsKey(command) ? Optional.ofNullable(customBindings.get(command)) : defaultBinding(command);
    }

    private static Optional<KeyCombination> defaultBinding(Command command) {
        return command.shortcut().isEmpty() ? Optional.empty() : Optional.of(KeyCombination.valueOf(command.shortcut()));
    }

    /** Returns the shortcut's {@link KeyLabel} text, or an empty string if there is none. */
    public String text(Command command) {
        return binding(command).map(KeyLabel::text).orElse("");
    }

    /** Returns whether a key event matches a command's shortcut. */
    public boolean matches(Command command, KeyEvent event) {
        return binding(command).filter(k -> k.match(event)).isPresent();
    }

    /** Returns whether a command's shortcut differs from its default. */
    public boolean isChanged(Command command) {
        return !binding(command).equals(defaultBinding(command));
    }

    /** Returns the command that a shortcut is assigned to, or empty if it is free. */
    public Optional<Command> owner(KeyCombination key) {
        return Stream.of(Command.values()).filter(c -> binding(c).filter(key::equals).isPresent()).findFirst();
    }

    /** Assigns a shortcut to a command and removes it from any other; an empty one clears it. */
    public void set(Command command, Optional<KeyCombination> key) {
        key.flatMap(this::owner).ifPresent(owner -> put(owner, Optional.empty()));
        put(command, key);
        changes.set(changes.get() + 1);
    }

    /** Restores the default shortcut of a command and removes it from any other. */
    public void reset(Command command) {
        set(command, defaultBinding(command));
    }

    /** Restores the default shortcuts of all commands. */
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

    /** Returns the shortcut of a key event, or empty for a modifier alone. */
    public static Optional<KeyCodeCombination> fromEvent(KeyEvent event) {
        KeyCode code = event.getCode();
        return code.isModifierKey() || code == KeyCode.UNDEFINED ? Optional.empty() : Optional.of(new KeyCodeCombination(code,
                modifier(event.isShiftDown()), KeyCombination.ModifierValue.UP, modifier(event.isAltDown()),
                KeyCombination.ModifierValue.UP, modifier(event.isShortcutDown())));
    }

    private static KeyCombination.ModifierValue modifier(boolean down) {
        return down ? KeyCombination.ModifierValue.DOWN : KeyCombination.ModifierValue.UP;
    }

    /** Returns why a key cannot be a shortcut, as a clause, or empty if it can. */
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

    /** Restores stored shortcuts. Ignores invalid ones. */
    public void restore(Preferences preferences) {
        for (Command command : Command.values()) {
            String text = preferences.text("key." + command.name(), "");
            try {
                if (!text.isEmpty()) {
                    set(command, text.equals(NONE) ? Optional.empty() : Optional.of(KeyCombination.valueOf(text)));
                }
            } catch (IllegalArgumentException e) {
                // Keeps the current shortcut.
            }
        }
    }

    /** Stores the changed shortcuts. */
    public void save(Preferences preferences) {
        for (Command command : Command.values()) {
            preferences.set("key." + command.name(),
                    isChanged(command) ? binding(command).map(KeyCombination::getName).orElse(NONE) : "");
        }
    }
}
