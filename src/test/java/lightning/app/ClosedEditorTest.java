package lightning.app;

import java.lang.ref.WeakReference;
import lightning.app.model.EditorModel;
import org.junit.jupiter.api.Test;

class ClosedEditorTest extends EditorDesk {
    private WeakReference<EditorModel> before;

    /** Its pictures and caches would stay for as long as the process lives. */
    @Test
    void closedEditor_isForgotten() throws Exception {
        before = new WeakReference<>(model());
        close();
        open();
        // What the tests' hand touched last it knows.
        robot.clickOn("#traced-picture");
        waitFor("nothing knows the closed editor", () -> {
            System.gc();
            return before.get() == null;
        });
    }
}
