package lightning.app;

import java.util.List;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.util.Duration;

/** The editor's program as far as its start goes: it opens the first scene, and closes when the picture was seen. */
public final class Rehearsal extends LightningApp {
    /** In this time the picture comes from the window's thread onto the screen. */
    private static final Duration A_LOOK = Duration.millis(500);

    /** Opens the editor where a window can be opened, and returns when it is closed. At most once in a process. */
    public static void open() {
        open(Rehearsal.class, List.of());
    }

    @Override
    void opened(Editor editor) {
        var look = new PauseTransition(A_LOOK);
        look.setOnFinished(_ -> Platform.exit());
        editor.model().renderingProperty().subscribe(state -> {
            if (state.frame() != null) {
                look.play();
            }
        });
    }
}
