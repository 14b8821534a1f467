package lightning.format.exr;

import lightning.base.text.RefusalException;

/**
 * Channel of an OpenEXR image, with one number per pixel.
 *
 * @param name full name, such as {@code key_diffuse.R}; the part before the last dot is the layer
 * @param perceptual whether equal steps of the value look equal, so that DWA stores it without a curve
 */
public record ExrChannel(String name, ExrType type, boolean perceptual) {
    /** Maximum length of a channel name. */
    public static final int MAX_NAME_LENGTH = 255;

    /** @throws RefusalException if the name is empty, longer than {@link #MAX_NAME_LENGTH}, or not of printable ASCII */
    public ExrChannel {
        if (name.isEmpty() || name.length() > MAX_NAME_LENGTH || !name.chars().allMatch(c -> c > ' ' && c < 127)) {
            throw new RefusalException("a channel's name must have 1 to " + MAX_NAME_LENGTH + " ASCII characters, was " + name);
        }
    }

    /** Creates a channel whose values are proportional to light, or no color. */
    public ExrChannel(String name, ExrType type) {
        this(name, type, false);
    }

    /** Returns the part of the name after the last dot. */
    public String suffix() {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** Returns the part of the name before {@link #suffix}, with its dot; empty for a channel without a layer. */
    String prefix() {
        return name.substring(0, name.lastIndexOf('.') + 1);
    }
}
