package lightning.editor.window.mixer;

import java.util.Arrays;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.editor.window.widget.Percent;
import lightning.editor.window.widget.PixelImage;

/** What a strip gives to the picture: the picture of it, and its part in per cent. */
final class Thumbnail extends VBox {
    private final ImageView image = new ImageView();
    private final Label part = new Label("–");
    private int[] pixels;

    Thumbnail(String id) {
        getStyleClass().add("thumbnail");
        image.setId("thumbnail-" + id);
        var frame = new StackPane(image);
        frame.setMinSize(ShareFeed.WIDTH, ShareFeed.HEIGHT);
        frame.setMaxSize(ShareFeed.WIDTH, ShareFeed.HEIGHT);
        frame.getStyleClass().add("thumbnail-frame");
        part.setId("part-" + id);
        part.getStyleClass().add("part");
        getChildren().addAll(frame, part);
    }

    void show(Optional<SharePictures.One> one) {
        one.ifPresentOrElse(p -> {
            // A picture that is another object is drawn anew, and an edit of one light leaves most pictures as they are.
            if (!Arrays.equals(p.pixels(), pixels)) {
                pixels = p.pixels();
                image.setImage(PixelImage.of(p.width(), p.height(), pixels));
            }
            part.setText(Percent.text(p.part()));
        }, () -> {
            pixels = null;
            image.setImage(null);
            part.setText("–");
        });
    }
}
