package lightning.layer;

import java.util.Optional;
import lightning.format.exr.ExrCompression;

/**
 * Storage of the content of an OpenEXR file.
 *
 * @param compression one of {@link ExrCompression#writable}
 * @param hasParts whether each layer is a part of its own, so that programs read only those that they show
 * @param crop part of the image that the file has; empty for all
 */
public record ExrLayout(ExrCompression compression, boolean hasParts, Optional<ImageCrop> crop) {
    /** One part with the whole image, as every program reads it. */
    public static final ExrLayout DEFAULT = new ExrLayout(ExrCompression.ZIP, false, Optional.empty());
}
