package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import lightning.editor.document.Command;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeysTest {
    private static final KeyCombination K = new KeyCodeCombination(KeyCode.K, KeyCombination.SHORTCUT_DOWN);

    @TempDir
    private Path folder;

    private final Keys keys = new Keys();

    private Keys readAgain() {
        var preferences = new Preferences(folder, Runnable::run);
        keys.remember(preferences);
        preferences.save();
        var again = new Keys();
        again.restore(new Preferences(folder, Runnable::run));
        return again;
    }

    @Test
    void chosenKey_isKeptFromRunToRun() {
        keys.set(Command.GO, Optional.of(K));
        keys.set(Command.SAVE_SCENE, Optional.empty());
        Keys again = readAgain();
        assertThat(again.of(Command.GO)).contains(K);
        assertThat(again.of(Command.SAVE_SCENE)).isEmpty();
        assertThat(again.of(Command.UNDO)).contains(KeyCombination.valueOf("Shortcut+Z"));
    }

    @Test
    void everyKeyOfTheProgram_comesBackFromTheFileForAnotherCommand() {
        for (Command command : Command.values()) {
            if (!command.shortcut().isEmpty() && command != Command.ABOUT) {
                keys.set(Command.ABOUT, Optional.of(KeyCombination.valueOf(command.shortcut())));
                assertThat(readAgain().of(Command.ABOUT)).as(command.title()).isEqualTo(keys.of(Command.ABOUT)).isPresent();
                keys.reset();
            }
        }
    }

    @Test
    void swappedKeys_areKept() {
        keys.set(Command.GO, Optional.of(KeyCombination.valueOf("F8")));
        keys.set(Command.LIVE, Optional.of(KeyCombination.valueOf("F5")));
        Keys again = readAgain();
        assertThat(again.of(Command.GO)).contains(KeyCombination.valueOf("F8"));
        assertThat(again.of(Command.LIVE)).contains(KeyCombination.valueOf("F5"));
    }

    @Test
    void keyThatIsTaken_leavesItsOwner() {
        keys.set(Command.GO, Optional.of(KeyCombination.valueOf("Shortcut+Z")));
        assertThat(keys.of(Command.UNDO)).isEmpty();
        assertThat(keys.owner(KeyCombination.valueOf("Shortcut+Z"))).contains(Command.GO);
    }

    @Test
    void reset_bringsTheProgramsOwnKeyBackToWhoHadIt() {
        keys.set(Command.GO, Optional.of(KeyCombination.valueOf("Shortcut+Z")));
        keys.reset(Command.UNDO);
        assertThat(keys.of(Command.UNDO)).contains(KeyCombination.valueOf("Shortcut+Z"));
        assertThat(keys.of(Command.GO)).isEmpty();
        keys.reset();
        assertThat(Command.values()).noneMatch(keys::isChanged);
    }

    @Test
    void damagedKey_countsAsNotChanged() {
        var preferences = new Preferences(folder, Runnable::run);
        preferences.set("key.GO", "Shortcut+Nonsense+");
        keys.restore(preferences);
        assertThat(keys.isChanged(Command.GO)).isFalse();
    }

    @Test
    void letterAlone_isForTyping() {
        assertThat(Keys.obstacle(new KeyCodeCombination(KeyCode.K))).isPresent();
        assertThat(Keys.obstacle(new KeyCodeCombination(KeyCode.F12))).isEmpty();
        assertThat(Keys.obstacle((KeyCodeCombination) K)).isEmpty();
        assertThat(Keys.obstacle(new KeyCodeCombination(KeyCode.V, KeyCombination.SHORTCUT_DOWN))).isPresent();
    }
}
