package lightning.app.mixer;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import lightning.app.model.EditorModel;
import lightning.image.ViewTransform;
import lightning.relight.SmallShares;
import lightning.work.OwnThread;

/** Makes the strips' pictures on a thread of its own; of pictures that come faster than that, the newest. */
final class ShareFeed implements AutoCloseable {
    /** Of a strip's picture, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;

    private final ExecutorService thread = OwnThread.inTurn("lightning-mixer");
    private final AtomicBoolean asked = new AtomicBoolean();
    private final EditorModel model;
    private final Consumer<SharePictures> heard;
    private volatile ViewTransform view = ViewTransform.DEFAULT;

    /** @param heard on the window's thread */
    ShareFeed(EditorModel model, Consumer<SharePictures> heard) {
        this.model = model;
        this.heard = heard;
    }

    /** The traced picture is another, or it is shown in another way. */
    void look() {
        view = model.viewProperty().get().ofPicture();
        if (asked.compareAndSet(false, true)) {
            thread.execute(this::make);
        }
    }

    private void make() {
        asked.set(false);
        model.workbench().known().map(cache -> SmallShares.of(cache, WIDTH, HEIGHT)).map(shares -> SharePictures.of(shares, view))
                .ifPresent(pictures -> model.window().execute(() -> heard.accept(pictures)));
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
