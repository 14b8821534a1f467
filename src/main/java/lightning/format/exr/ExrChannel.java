package lightning.format.exr;

/**
 * A column of numbers, one for each pixel.
 *
 * @param name as in {@code key.diffuse.R}: what stands before the last dot is the layer
 */
public record ExrChannel(String name, ExrType type) {
    /** The longest name that a file may have. */
    public static final int MAX_NAME_LENGTH = 255;

    /** @throws IllegalArgumentException if the name is empty, longer than {@link #MAX_NAME_LENGTH}, or not of printable ASCII */
    public ExrChannel {
        if (name.isEmpty() || name.length() > MAX_NAME_LENGTH || !name.chars().allMatch(c -> c > ' ' && c < 127)) {
            throw new IllegalArgumentException("a channel's name must have 1 to " + MAX_NAME_LENGTH + " characters of ASCII, was " + name);
        }
    }
}
