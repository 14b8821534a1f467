package lightning.format.exr;

/**
 * Channel of an OpenEXR image, with one number per pixel.
 *
 * @param name full name, such as {@code key_diffuse.R}; the part before the last dot is the layer
 */
public record ExrChannel(String name, ExrType type) {
    /** Maximum length of a channel name. */
    public static final int MAX_NAME_LENGTH = 255;

    /** @throws IllegalArgumentException if the name is empty, longer than {@link #MAX_NAME_LENGTH}, or not of printable ASCII */
    public ExrChannel {
        if (name.isEmpty() || name.length() > MAX_NAME_LENGTH || !name.chars().allMatch(c -> c > ' ' && c < 127)) {
            throw new IllegalArgumentException("a channel's name must have 1 to " + MAX_NAME_LENGTH + " ASCII characters, was " + name);
        }
    }
}
