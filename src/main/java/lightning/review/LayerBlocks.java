package lightning.review;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import lightning.render.image.Film;

/** Writer of layers, each as a block of data of the page, which the page decodes when it shows the layer's picture. */
final class LayerBlocks {
    private final OutputStream out;
    private int count;

    LayerBlocks(OutputStream out) {
        this.out = out;
    }

    /** Writes a film and returns the id of its block. */
    String add(Film film) throws IOException {
        String id = "layer-" + count++;
        // Base64 has no character with a meaning in HTML.
        String block = "<script type=\"text/plain\" id=\"" + id + "\">" + HalfPlanes.encode(film) + "</script>\n";
        out.write(block.getBytes(StandardCharsets.US_ASCII));
        return id;
    }
}
