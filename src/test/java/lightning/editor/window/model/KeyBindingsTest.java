package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import lightning.editor.Command;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeyBindingsTest {
    private static final KeyCombination K = new KeyCodeCombination(KeyCode.K, KeyCombination.SHORTCUT_DOWN);

    @TempDir
    private Path folder;

    private final KeyBindings keyBindings = new KeyBindings();

    private KeyBindings reload() {
        var preferences = new Preferences(folder, Runnable::run);
        keyBindings.save(preferences);
        preferences.save();
        var again = new KeyBindings();
        again.restore(new Preferences(folder, Runnable::run));
        return again;
    }

    @Test
    void customKey_isRestoredInNextRun() {
        keyBindings.set(Command.GO, Optional.of(K));
        keyBindings.set(Command.SAVE_SCENE, Optional.empty());
        KeyBindings again = reload();
        assertThat(again.binding(Command.GO)).contains(K);
        assertThat(again.binding(Command.SAVE_SCENE)).isEmpty();
        assertThat(again.binding(Command.UNDO)).contains(KeyCombination.valueOf("Shortcut+Z"));
    }

    @Test
    void everyDefaultKey_canBeRestoredForOtherCommand() {
        for (Command command : Command.values()) {
            if (!command.shortcut().isEmpty() && command != Command.ABOUT) {
                keyBindings.set(Command.ABOUT, Optional.of(KeyCombination.valueOf(command.shortcut())));
                assertThat(reload().binding(Command.ABOUT)).as(command.title()).isEqualTo(keyBindings.binding(Command.ABOUT)).isPresent();
                keyBindings.reset();
            }
        }
    }

    @Test
    void swappedKeys_areRestored() {
        keyBindings.set(Command.GO, Optional.of(KeyCombination.valueOf("F8")));
        keyBindings.set(Command.LIVE, Optional.of(KeyCombination.valueOf("F5")));
        KeyBindings again = reload();
        assertThat(again.binding(Command.GO)).contains(KeyCombination.valueOf("F8"));
        assertThat(again.binding(Command.LIVE)).contains(KeyCombination.valueOf("F5"));
    }

    @Test
    void reassignedKey_isRemovedFromOwner() {
        keyBindings.set(Command.GO, Optional.of(KeyCombination.valueOf("Shortcut+Z")));
        assertThat(keyBindings.binding(Command.UNDO)).isEmpty();
        assertThat(keyBindings.owner(KeyCombination.valueOf("Shortcut+Z"))).contains(Command.GO);
    }

    @Test
    void reset_restoresDefaultKey() {
        keyBindings.set(Command.GO, Optional.of(KeyCombination.valueOf("Shortcut+Z")));
        keyBindings.reset(Command.UNDO);
        assertThat(keyBindings.binding(Command.UNDO)).contains(KeyCombination.valueOf("Shortcut+Z"));
        assertThat(keyBindings.binding(Command.GO)).isEmpty();
        keyBindings.reset();
        assertThat(Command.values()).noneMatch(keyBindings::isChanged);
    }

    @Test
    void damagedKey_isIgnored() {
        var preferences = new Preferences(folder, Runnable::run);
        preferences.set("key.GO", "Shortcut+Nonsense+");
        keyBindings.restore(preferences);
        assertThat(keyBindings.isChanged(Command.GO)).isFalse();
    }

    @Test
    void letterWithoutModifier_isInvalid() {
        assertThat(KeyBindings.invalidReason(new KeyCodeCombination(KeyCode.K))).isPresent();
        assertThat(KeyBindings.invalidReason(new KeyCodeCombination(KeyCode.F12))).isEmpty();
        assertThat(KeyBindings.invalidReason((KeyCodeCombination) K)).isEmpty();
        assertThat(KeyBindings.invalidReason(new KeyCodeCombination(KeyCode.V, KeyCombination.SHORTCUT_DOWN))).isPresent();
    }
}
