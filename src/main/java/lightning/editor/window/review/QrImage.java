package lightning.editor.window.review;

import io.nayuki.qrcodegen.QrCode;
import java.util.Arrays;
import javafx.scene.image.Image;
import lightning.editor.window.widget.PixelImage;

/** QR codes of addresses. */
final class QrImage {
    /** Light border that readers need, modules. */
    private static final int BORDER = 4;
    /** Size of a module, pixels. */
    private static final int MODULE = 4;
    private static final int LIGHT = 0xFFFFFFFF;
    private static final int DARK = 0xFF000000;

    private QrImage() {}

    /** Returns the code of a text that a code can hold: at most 2 331 bytes in UTF-8. */
    static Image of(String text) {
        QrCode code = QrCode.encodeText(text, QrCode.Ecc.MEDIUM);
        int side = MODULE * (code.size + 2 * BORDER);
        int[] pixels = new int[side * side];
        Arrays.setAll(pixels, i -> code.getModule(i % side / MODULE - BORDER, i / side / MODULE - BORDER) ? DARK : LIGHT);
        return PixelImage.of(side, side, pixels);
    }
}
