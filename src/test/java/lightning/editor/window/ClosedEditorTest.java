package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import lightning.editor.Command;
import org.junit.jupiter.api.Test;

@OwnEditor
class ClosedEditorTest extends EditorFixture {
    private List<WeakReference<?>> before;

    /** The toolkit may still access a child window after its owner has closed it. */
    @Test
    void otherWindows_closeBeforeEditor() {
        List<Window> closed = new ArrayList<>();
        floatPanels();
        robot.interact(() -> {
            model().commands().run(Command.MIXER);
            model().commands().run(Command.HISTORY_PANEL);
            List.copyOf(Window.getWindows()).forEach(w -> w.addEventHandler(WindowEvent.WINDOW_HIDING, _ -> closed.add(w)));
            assertThat(Window.getWindows()).hasSizeGreaterThanOrEqualTo(3);
            model().commands().run(Command.QUIT);
        });
        assertThat(closed).hasSizeGreaterThanOrEqualTo(3).endsWith(stage);
    }

    /** Otherwise its pictures and caches would stay in memory until the process ends. */
    @Test
    void closedEditor_isGarbageCollected() throws Exception {
        before = Stream.of(model(), model().editor(), model().picture().raster()).<WeakReference<?>>map(WeakReference::new).toList();
        close();
        open();
        // The robot keeps a reference to the last node it used.
        robot.clickOn("#traced-picture");
        waitFor("the closed editor is collected", () -> {
            System.gc();
            return before.stream().allMatch(r -> r.get() == null);
        });
    }
}
