package lightning.editor.window.mixer;

import java.util.function.Consumer;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PaneFeed;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SmallShares;

/** Makes the strips' pictures. */
final class ShareFeed implements AutoCloseable {
    /** Of a strip's picture, pixels. */
    static final int WIDTH = 88;
    static final int HEIGHT = 60;

    private final EditorModel model;
    private final PaneFeed<SharePictures> feed;
    private volatile ViewTransform view = ViewTransform.DEFAULT;

    /** @param heard on the window's thread */
    ShareFeed(EditorModel model, Consumer<SharePictures> heard) {
        this.model = model;
        feed = new PaneFeed<>("lightning-mixer", model.window(), () -> model.workbench().known()
                .map(cache -> SmallShares.of(cache, WIDTH, HEIGHT)).map(shares -> SharePictures.of(shares, view)), heard);
    }

    /** The traced picture is another, or it is shown in another way. */
    void look() {
        view = model.viewProperty().get().ofPicture();
        feed.request();
    }

    /** Ends its thread until the next look. */
    @Override
    public void close() {
        feed.close();
    }
}
