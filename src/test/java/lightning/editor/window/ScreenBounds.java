package lightning.editor.window;

import java.util.concurrent.TimeUnit;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import lightning.base.work.Await;
import org.testfx.util.WaitForAsyncUtils;

/** Places of nodes on the screen. */
public final class ScreenBounds {
    private ScreenBounds() {}

    /**
     * Returns the bounds of a node, in pixels of the screen. They are computed on the window's thread: JavaFX corrects bounds while it reads
     * them, which fails on two threads at once.
     */
    public static Bounds of(Node node) {
        return Platform.isFxApplicationThread() ? onWindowThread(node)
                : WaitForAsyncUtils.waitForAsyncFx(TimeUnit.SECONDS.toMillis(Await.TIMEOUT_SECONDS), () -> onWindowThread(node));
    }

    private static Bounds onWindowThread(Node node) {
        return node.localToScreen(node.getBoundsInLocal());
    }
}
