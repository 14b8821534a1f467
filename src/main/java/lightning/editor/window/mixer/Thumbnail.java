package lightning.editor.window.mixer;

import java.util.Arrays;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.editor.window.widget.PercentText;
import lightning.editor.window.widget.PixelImage;
import org.jspecify.annotations.Nullable;

/** Thumbnail of a strip's contribution to the picture, with its share in percent. */
final class Thumbnail extends VBox {
    private final ImageView image = new ImageView();
    private final Label percentage = new Label("–");
    private final StackPane frame;
    private int @Nullable [] pixels;

    Thumbnail(String id) {
        getStyleClass().add("thumbnail");
        image.setId("thumbnail-" + id);
        frame = new StackPane(image);
        frame.setMinSize(ChannelImageFeed.WIDTH, ChannelImageFeed.HEIGHT);
        frame.setMaxSize(ChannelImageFeed.WIDTH, ChannelImageFeed.HEIGHT);
        frame.getStyleClass().add("thumbnail-frame");
        percentage.setId("part-" + id);
        percentage.getStyleClass().add("part");
        getChildren().addAll(frame, percentage);
    }

    /** Hides the image in a low mixer. */
    void setDetail(StripDetail detail) {
        frame.setVisible(detail == StripDetail.FULL);
        frame.setManaged(detail == StripDetail.FULL);
        setVisible(detail.includes(StripDetail.NO_THUMBNAIL));
        setManaged(detail.includes(StripDetail.NO_THUMBNAIL));
    }

    void show(Optional<ChannelImages.ChannelImage> channelImage) {
        channelImage.ifPresentOrElse(p -> {
            // The toolkit redraws every new image, but an edit of one light changes only few thumbnails.
            if (!Arrays.equals(p.pixels(), pixels)) {
                pixels = p.pixels();
                image.setImage(PixelImage.of(p.width(), p.height(), pixels));
            }
            percentage.setText(PercentText.format(p.fraction()));
        }, () -> {
            pixels = null;
            image.setImage(null);
            percentage.setText("–");
        });
    }
}
