package lightning.editor.window.measure;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.document.loop.Frame;
import lightning.editor.window.model.PaneUpdater;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.PixelImage;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.image.Scopes;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;

/** Histogram and waveform of the displayed picture, computed on a dedicated thread. Only the newest picture is computed. */
public final class ScopesPane extends VBox {
    private static final int HEIGHT = 160;
    private static final double WIDTH = 512;
    private static final double MIN_WIDTH = 160;
    /** Total width of the margins, pixels. */
    private static final double MARGINS = 28;

    private final TracedPicture picture;
    private final PaneUpdater<ScopeImages> feed;
    private final ImageView histogram = view("histogram", Messages.tr("Histogram of red, green and blue values"));
    private final ImageView waveform = view("waveform", Messages.tr("Waveform of the values in each column"));
    private final Label clippingLabel = new Label();
    private volatile @Nullable Frame frame;
    private volatile ViewTransform shownView = ViewTransform.DEFAULT;

    private record ScopeImages(Scopes scopes, int[] histogramPixels, int[] waveformPixels) {
        // The arrays are never written after construction.
    }

    /** @param window  runs tasks in order on the window's thread */
    public ScopesPane(TracedPicture picture, Executor window) {
        this.picture = picture;
        feed = new PaneUpdater<>("lightning-scopes", window, this::computeImages, this::show);
        setId("scopes");
        getStyleClass().addAll("panel", "scopes");
        clippingLabel.setId("scopes-cut");
        getChildren().setAll(new Label(Messages.tr("Histogram")), histogram, clippingLabel, new Label(Messages.tr("Waveform")), waveform);
        setMinWidth(MIN_WIDTH + MARGINS);
        for (ImageView view : List.of(histogram, waveform)) {
            view.fitWidthProperty().bind(widthProperty().map(w -> Math.clamp(w.doubleValue() - MARGINS, MIN_WIDTH, WIDTH)));
        }
        VisibilityListener.attach(this, this::subscribe);
    }

    private static ImageView view(String id, String text) {
        var view = new ImageView();
        view.setId(id);
        view.setAccessibleText(text);
        view.setFitHeight(id.equals("histogram") ? HEIGHT : Scopes.CODES);
        view.setSmooth(false);
        return view;
    }

    /** Subscribes to changes of the picture and the view. */
    private Subscription subscribe() {
        return Subscription.combine(picture.renderStateProperty().subscribe(_ -> update()),
                picture.outputViewProperty().subscribe(_ -> update()),
                () -> frame = null, feed::close);
    }

    private void update() {
        Frame newFrame = picture.frame();
        ViewTransform view = picture.outputView();
        if (newFrame == null || newFrame == frame && view.equals(shownView)) {
            return;
        }
        frame = newFrame;
        shownView = view;
        feed.request();
    }

    private Optional<ScopeImages> computeImages() {
        return Optional.ofNullable(frame).map(source -> Scopes.of(source.displayed(), shownView))
                .map(scopes -> new ScopeImages(scopes, scopes.histogramPixels(HEIGHT), scopes.waveformPixels()));
    }

    private void show(ScopeImages images) {
        Scopes scopes = images.scopes();
        histogram.setImage(PixelImage.of(Scopes.CODES, HEIGHT, images.histogramPixels()));
        waveform.setImage(PixelImage.of(scopes.columns(), Scopes.CODES, images.waveformPixels()));
        clippingLabel.setText(
                String.format(Messages.locale(), Messages.tr("Clipped: %.1f %% black, %.1f %% white"), 100 * scopes.pixelShare(0),
                        100 * scopes.pixelShare(Scopes.CODES - 1)));
    }
}
