package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import javafx.scene.image.ImageView;
import lightning.document.DeskScene;
import lightning.editor.Command;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Closed panels and closed editors leave no thread running. */
@OwnEditor
class ClosedPanelTest extends EditorFixture {

    private static Set<Thread> threads() {
        return Thread.getAllStackTraces().keySet().stream().filter(t -> t.getName().startsWith("lightning-")).collect(Collectors.toSet());
    }

    private static boolean runs(String name) {
        return threads().stream().anyMatch(t -> t.getName().equals(name));
    }

    private void open(Command... panels) {
        robot.interact(() -> Arrays.stream(panels).forEach(model().commands()::run));
    }

    @ParameterizedTest
    @CsvSource({"MIXER, lightning-mixer", "SCOPES, lightning-scopes", "CONTRIBUTIONS, lightning-contributions"})
    void closedPanel_stopsItsThreadUntilReopened(Command panel, String thread) {
        for (int time = 1; time <= 2; time++) {
            open(panel);
            waitFor("the panel works", () -> runs(thread));
            closePanels();
            waitFor("its thread has ended", () -> !runs(thread));
        }
    }

    @Test
    void pixelShares_areComputedOnThreadThatEndsWithPanel() {
        open(Command.CONTRIBUTIONS);
        robot.moveTo("#traced-picture");
        waitFor("the query runs", () -> runs("lightning-pixel-share"));
        closePanels();
        waitFor("its thread has ended", () -> !runs("lightning-pixel-share"));
    }

    @Test
    void reopenedPanel_showsLaterEdits() {
        open(Command.SCOPES);
        waitFor("the waveform is computed", () -> robot.lookup("#waveform").<ImageView>query().getImage() != null);
        Object before = robot.lookup("#waveform").<ImageView>query().getImage();
        closePanels();
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 3)));
        click("go");
        waitForPicture();
        open(Command.SCOPES);
        waitFor("the waveform is updated", () -> robot.lookup("#waveform").<ImageView>query().getImage() != before);
    }

    @Test
    void closedEditor_stopsPanelThreads() throws Exception {
        close();
        waitFor("the first editor's threads have ended",
                () -> threads().stream().noneMatch(t -> t.getName().startsWith("lightning-render")));
        Set<Thread> others = threads();
        open();
        floatPanels();
        open(Command.MIXER, Command.SCOPES, Command.CONTRIBUTIONS, Command.LOOKS, Command.HISTORY_PANEL, Command.UPDATES_PANEL,
                Command.EFFECTS_PANEL, Command.ACCURACY_PANEL, Command.COMPARE_SETTINGS, Command.KEYS, Command.TIMELINE);
        robot.moveTo("#traced-picture");
        waitFor("the panels' threads run", () -> runs("lightning-mixer") && runs("lightning-scopes") && runs("lightning-contributions"));
        close();
        waitFor("no thread of the editor runs", () -> others.containsAll(threads()));
        assertThat(threads()).isSubsetOf(others);
        open();
    }
}
