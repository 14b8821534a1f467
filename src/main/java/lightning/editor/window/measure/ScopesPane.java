package lightning.editor.window.measure;

import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Texts;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.PaneFeed;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.PixelImage;
import lightning.editor.window.widget.WhileSeen;
import lightning.render.image.Scopes;
import lightning.render.image.ViewTransform;

/** Histogram and waveform of the traced picture as it is shown, counted on a thread of its own; of many pictures the newest. */
public final class ScopesPane extends VBox {
    private static final int HEIGHT = 160;
    private static final int WIDTH = 512;

    private final TracedPicture picture;
    private final PaneFeed<Counted> feed;
    private final ImageView histogram = view("histogram", Texts.of("How many pixels have each code, red, green and blue"));
    private final ImageView waveform = view("waveform", Texts.of("Which codes the pixels of each column have"));
    private final Label cut = new Label();
    private volatile Frame frame;
    private volatile ViewTransform shown = ViewTransform.DEFAULT;

    private record Counted(Scopes scopes, int[] bars, int[] wave) {
        // Arrays in a record: written once by their maker, never after.
    }

    /** @param window runs tasks in turn on the window's thread */
    public ScopesPane(TracedPicture picture, Executor window) {
        this.picture = picture;
        feed = new PaneFeed<>("lightning-scopes", window, this::count, this::show);
        setId("scopes");
        getStyleClass().addAll("panel", "scopes");
        cut.setId("scopes-cut");
        getChildren().setAll(new Label(Texts.of("Histogram")), histogram, cut, new Label(Texts.of("Waveform")), waveform);
        WhileSeen.follow(this, this::follow);
    }

    private static ImageView view(String id, String text) {
        var view = new ImageView();
        view.setId(id);
        view.setAccessibleText(text);
        view.setFitWidth(WIDTH);
        view.setFitHeight(id.equals("histogram") ? HEIGHT : Scopes.CODES);
        view.setSmooth(false);
        return view;
    }

    /** Follows the picture. */
    private Subscription follow() {
        return Subscription.combine(picture.renderingProperty().subscribe(_ -> look()), picture.viewProperty().subscribe(_ -> look()),
                () -> frame = null, feed::close);
    }

    private void look() {
        Frame now = picture.frame();
        ViewTransform view = picture.viewProperty().get();
        if (now == null || now == frame && view.equals(shown)) {
            return;
        }
        frame = now;
        shown = view;
        feed.request();
    }

    private Optional<Counted> count() {
        return Optional.ofNullable(frame).map(about -> Scopes.of(about.seen(), shown))
                .map(scopes -> new Counted(scopes, scopes.histogramPixels(HEIGHT), scopes.waveformPixels()));
    }

    private void show(Counted counted) {
        Scopes scopes = counted.scopes();
        histogram.setImage(PixelImage.of(Scopes.CODES, HEIGHT, counted.bars()));
        waveform.setImage(PixelImage.of(scopes.columns(), Scopes.CODES, counted.wave()));
        cut.setText(String.format(Texts.locale(), Texts.of("%.1f %% of a channel at black, %.1f %% at white"), 100 * scopes.shareOf(0),
                100 * scopes.shareOf(Scopes.CODES - 1)));
    }
}
