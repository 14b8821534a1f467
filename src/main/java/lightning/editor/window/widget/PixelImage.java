package lightning.editor.window.widget;

import java.nio.IntBuffer;
import javafx.scene.image.Image;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import org.jspecify.annotations.Nullable;

/** Creates images of pixel arrays. */
public final class PixelImage {
    private PixelImage() {}

    /** @param pixels  {@code int[width * height]}, 0xAARRGGBB, opaque or premultiplied, top row first; not copied */
    public static Image of(int width, int height, int @Nullable [] pixels) {
        return new WritableImage(new PixelBuffer<>(width, height, IntBuffer.wrap(pixels), PixelFormat.getIntArgbPreInstance()));
    }
}
