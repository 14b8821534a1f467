package lightning.editor.window.command;

import java.util.Optional;
import lightning.base.text.Messages;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.format.image.ImageFormat;
import lightning.layer.ExrContent;
import org.jspecify.annotations.Nullable;

/** File format for exporting the picture. */
enum ExportFormat {
    LAYERS_HALF(Messages.key("Layers as OpenEXR, 16-bit Half…"), ImageFormat.EXR, 16, ExrContent.layers(ExrType.HALF)),
    LAYERS_FLOAT(Messages.key("Layers as OpenEXR, 32-bit Float…"), ImageFormat.EXR, 32, ExrContent.layers(ExrType.FLOAT)),
    MATTES(Messages.key("Mattes as OpenEXR, Cryptomatte…"), ImageFormat.EXR, 16, ExrContent.mattes(ExrContent.DEFAULT_MATTE_LEVELS)),
    EXR(Messages.key("Image as OpenEXR, 32-bit Float…"), ImageFormat.EXR, 32, null),
    ACESCG(Messages.key("Image as OpenEXR, ACEScg…"), ImageFormat.EXR, 32,
            new ExrContent(ExrType.FLOAT, ExrContent.Layers.NONE, false, 0, ExrPrimaries.ACESCG)),
    HDR(Messages.key("Image as Radiance HDR…"), ImageFormat.HDR, 8, null),
    PNG(Messages.key("Image as PNG, 16-bit…"), ImageFormat.PNG, 16, null);

    private final String title;
    private final ImageFormat format;
    private final int bits;
    private final @Nullable ExrContent content;

    ExportFormat(String title, ImageFormat format, int bits, @Nullable ExrContent content) {
        this.title = title;
        this.format = format;
        this.bits = bits;
        this.content = content;
    }

    /** Returns the title for menus. */
    String title() {
        return Messages.tr(title);
    }

    ImageFormat format() {
        return format;
    }

    /** Returns the bits per channel of the image. */
    int bits() {
        return bits;
    }

    /** Returns the layers or mattes of the file; empty for only the image. */
    Optional<ExrContent> content() {
        return Optional.ofNullable(content);
    }
}
