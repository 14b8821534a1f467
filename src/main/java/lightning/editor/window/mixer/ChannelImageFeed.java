package lightning.editor.window.mixer;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.animation.PauseTransition;
import javafx.beans.property.ObjectProperty;
import javafx.util.Duration;
import lightning.base.work.Progress;
import lightning.editor.Workbench;
import lightning.editor.window.model.PaneUpdater;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.LightShares;
import lightning.render.relight.LightThumbnails;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Computes the thumbnails of the mixer's strips. */
final class ChannelImageFeed implements AutoCloseable {
    /** Width of a strip's thumbnail, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;
    /** Time without a new picture after which the shares are computed. */
    private static final Duration SETTLE_DELAY = Duration.millis(300);

    private final ObjectProperty<ViewTransform> viewProperty;
    private final PaneUpdater<ChannelImages> feed;
    /** Computes shares of all pixels. */
    private final PaneUpdater<LightShares> shares;
    private final PauseTransition settleTimer = new PauseTransition(SETTLE_DELAY);
    private final Workbench workbench;
    /** Last thumbnails; null before the first. */
    private @Nullable ChannelImages images;
    /** Last shares; null before the first. */
    private @Nullable LightShares lastShares;
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
                () -> workbench.cache().flatMap(this::thumbnails).map(thumbnails -> ChannelImages.of(thumbnails, view)), newImages -> {
                    images = newImages;
                    listener.accept(newImages);
                });
        shares = new PaneUpdater<>("lightning-shares", windowExecutor, () -> workbench.cache().flatMap(this::shares), newShares -> {
            lastShares = newShares;
            if (images != null) {
                listener.accept(images);
            }
        });
        settleTimer.setOnFinished(_ -> shares.request());
    }

    /** Returns thumbnails; empty if there is a newer picture. */
    private Optional<LightThumbnails> thumbnails(PixelCache cache) {
        try {
            return Optional.of(LightThumbnails.of(cache, workbench.options().withThreads(1), WIDTH, HEIGHT,
                    Progress.cancellation(() -> !isNewest(cache))));
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    /** Returns the last shares of all pixels, scaled to an edited scene; empty if that needs a picture of it. */
    Optional<LightShares> scaledShares(Scene scene) {
        return Optional.ofNullable(lastShares).flatMap(last -> last.in(scene));
    }

    /** Returns the shares of all pixels; empty if there is a newer picture. */
    private Optional<LightShares> shares(PixelCache cache) {
        try {
            return Optional.of(LightShares.of(cache, workbench.options().withThreads(1), Progress.cancellation(() -> !isNewest(cache))));
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    private boolean isNewest(PixelCache cache) {
        return workbench.cache().orElse(null) == cache;
    }

    /** Computes the thumbnails again, after the traced picture or its view transform changed. */
    void refresh() {
        view = viewProperty.get().forOutput();
        feed.request();
        settleTimer.playFromStart();
    }

    /** Ends the thread; the next refresh starts another. */
    @Override
    public void close() {
        settleTimer.stop();
        shares.close();
        feed.close();
    }
}
