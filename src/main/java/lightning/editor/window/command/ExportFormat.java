package lightning.editor.window.command;

import lightning.base.text.Messages;
import lightning.format.image.ImageFormat;

/** File format for exporting the picture. */
enum ExportFormat {
    LAYERS_HALF(Messages.key("Layers as OpenEXR, 16-bit Half…"), ImageFormat.EXR, 16, true),
    LAYERS_FLOAT(Messages.key("Layers as OpenEXR, 32-bit Float…"), ImageFormat.EXR, 32, true),
    EXR(Messages.key("Image as OpenEXR, 32-bit Float…"), ImageFormat.EXR, 32, false),
    HDR(Messages.key("Image as Radiance HDR…"), ImageFormat.HDR, 8, false),
    PNG(Messages.key("Image as PNG, 16-bit…"), ImageFormat.PNG, 16, false);

    private final String title;
    private final ImageFormat format;
    private final int bits;
    private final boolean hasLayers;

    ExportFormat(String title, ImageFormat format, int bits, boolean layers) {
        this.title = title;
        this.format = format;
        this.bits = bits;
        this.hasLayers = layers;
    }

    /** Returns the title for menus. */
    String title() {
        return Messages.tr(title);
    }

    ImageFormat format() {
        return format;
    }

    /** Returns the bits per channel. */
    int bits() {
        return bits;
    }

    boolean hasLayers() {
        return hasLayers;
    }
}
