package lightning.editor.window.mixer;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import lightning.base.work.Progress;
import lightning.editor.document.Workbench;
import lightning.editor.window.model.PaneUpdater;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.IndirectByLight;
import lightning.render.relight.LightThumbnails;

/** Computes the thumbnails of the mixer's strips. */
final class ChannelImageFeed implements AutoCloseable {
    /** Width of a strip's thumbnail, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;
    /** Maximum time for the indirect light of all lights of a picture, nanoseconds. */
    private static final long INDIRECT_NS = 5_000_000_000L;

    private final ObjectProperty<ViewTransform> viewProperty;
    private final PaneUpdater<ChannelImages> feed;
    private final Workbench workbench;
    /** Indirect light of the last picture; used on the feed's thread only. */
    private IndirectByLight indirect;
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
        this.workbench = workbench;
        feed = new PaneUpdater<>("lightning-mixer", windowExecutor,
                () -> workbench.cache().flatMap(this::thumbnails).map(shares -> ChannelImages.of(shares, view)), listener);
    }

    /** Returns thumbnails with indirect light, or with direct light if that takes too long; empty if there is a newer picture. */
    private Optional<LightThumbnails> thumbnails(PixelCache cache) {
        if (indirect == null || !indirect.isOf(cache)) {
            indirect = new IndirectByLight(cache);
        }
        long start = System.nanoTime();
        try {
            return Optional.of(LightThumbnails.of(cache, WIDTH, HEIGHT, indirect,
                    Progress.cancellation(() -> System.nanoTime() - start > INDIRECT_NS || !isNewest(cache))));
        } catch (CancellationException e) {
            return isNewest(cache) ? Optional.of(LightThumbnails.of(cache, WIDTH, HEIGHT)) : Optional.empty();
        }
    }

    private boolean isNewest(PixelCache cache) {
        return workbench.cache().orElse(null) == cache;
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
