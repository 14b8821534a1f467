package lightning.editor.window.command;

import lightning.base.text.Texts;
import lightning.format.picture.PictureFormat;

/** What a picture can be exported as. */
enum ExportKind {
    LAYERS_HALF(Texts.key("Layers as OpenEXR, Half…"), PictureFormat.EXR, 16, true),
    LAYERS_FLOAT(Texts.key("Layers as OpenEXR, 32 Bits…"), PictureFormat.EXR, 32, true),
    EXR(Texts.key("Picture as OpenEXR, 32 Bits…"), PictureFormat.EXR, 32, false),
    HDR(Texts.key("Picture as Radiance HDR…"), PictureFormat.HDR, 8, false),
    PNG(Texts.key("Picture as PNG, 16 Bits…"), PictureFormat.PNG, 16, false);

    private final String title;
    private final PictureFormat format;
    private final int bits;
    private final boolean layers;

    ExportKind(String title, PictureFormat format, int bits, boolean layers) {
        this.title = title;
        this.format = format;
        this.bits = bits;
        this.layers = layers;
    }

    /** As a menu has it. */
    String title() {
        return Texts.of(title);
    }

    PictureFormat format() {
        return format;
    }

    /** Of a number. */
    int bits() {
        return bits;
    }

    boolean hasLayers() {
        return layers;
    }
}
