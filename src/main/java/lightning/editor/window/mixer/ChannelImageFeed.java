package lightning.editor.window.mixer;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.PaneUpdater;
import lightning.render.image.ViewTransform;
import lightning.render.relight.LightThumbnails;

/** Computes the thumbnails of the mixer's strips. */
final class ChannelImageFeed implements AutoCloseable {
    /** Width of a strip's thumbnail, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;

    private final ObjectProperty<ViewTransform> viewProperty;
    private final PaneUpdater<ChannelImages> feed;
    private volatile ViewTransform view = ViewTransform.DEFAULT;

    /**
     * Creates a feed without a thread.
     *
     * @param viewProperty view transform from linear light to display pixels
     * @param windowExecutor runs tasks in order on the window's thread
     * @param listener receives the thumbnails on the window's thread
     */
    ChannelImageFeed(Workbench workbench, ObjectProperty<ViewTransform> viewProperty, Executor windowExecutor,
            Consumer<ChannelImages> listener) {
        this.viewProperty = viewProperty;
        feed = new PaneUpdater<>("lightning-mixer", windowExecutor, () -> workbench.cache()
                .map(cache -> LightThumbnails.of(cache, WIDTH, HEIGHT)).map(shares -> ChannelImages.of(shares, view)), listener);
    }

    /** Computes the thumbnails again, after the traced picture or its view transform changed. */
    void refresh() {
        view = viewProperty.get().forOutput();
        feed.request();
    }

    /** Ends the thread; the next refresh starts another. */
    @Override
    public void close() {
        feed.close();
    }
}
