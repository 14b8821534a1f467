package lightning.editor.window.mixer;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.PaneUpdater;
import lightning.render.image.ViewTransform;
import lightning.render.relight.LightThumbnails;

/** Makes the strips' pictures. */
final class ChannelImageFeed implements AutoCloseable {
    /** Of a strip's picture, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;

    private final ObjectProperty<ViewTransform> viewProperty;
    private final PaneUpdater<ChannelImages> feed;
    private volatile ViewTransform view = ViewTransform.DEFAULT;

    /**
     * @param viewProperty  how linear light becomes display pixels
     * @param windowExecutor runs tasks in turn on the window's thread
     * @param listener  on the window's thread
     */
    ChannelImageFeed(Workbench workbench, ObjectProperty<ViewTransform> viewProperty, Executor windowExecutor,
            Consumer<ChannelImages> listener) {
        this.viewProperty = viewProperty;
        feed = new PaneUpdater<>("lightning-mixer", windowExecutor, () -> workbench.cache()
                .map(cache -> LightThumbnails.of(cache, WIDTH, HEIGHT)).map(shares -> ChannelImages.of(shares, view)), listener);
    }

    /** The traced picture is another, or it is shown in another way. */
    void refresh() {
        view = viewProperty.get().forOutput();
        feed.request();
    }

    /** Ends its thread until the next look. */
    @Override
    public void close() {
        feed.close();
    }
}
