package lightning.editor.window.mixer;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.PaneFeed;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SmallShares;

/** Makes the strips' pictures. */
final class ShareFeed implements AutoCloseable {
    /** Of a strip's picture, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;

    private final ObjectProperty<ViewTransform> shown;
    private final PaneFeed<SharePictures> feed;
    private volatile ViewTransform view = ViewTransform.DEFAULT;

    /**
     * @param shown  how linear light becomes display pixels
     * @param window runs tasks in turn on the window's thread
     * @param heard  on the window's thread
     */
    ShareFeed(Workbench workbench, ObjectProperty<ViewTransform> shown, Executor window, Consumer<SharePictures> heard) {
        this.shown = shown;
        feed = new PaneFeed<>("lightning-mixer", window, () -> workbench.known()
                .map(cache -> SmallShares.of(cache, WIDTH, HEIGHT)).map(shares -> SharePictures.of(shares, view)), heard);
    }

    /** The traced picture is another, or it is shown in another way. */
    void look() {
        view = shown.get().ofPicture();
        feed.request();
    }

    /** Ends its thread until the next look. */
    @Override
    public void close() {
        feed.close();
    }
}
