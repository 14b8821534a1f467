package lightning.format.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;

/**
 * Images that a use accepts. Files are checked against it before their pixels are decoded, so that a small header cannot request all memory.
 *
 * @param noun      name of such an image in messages; empty to name its file alone
 * @param formats   accepted formats
 * @param maxBytes  maximum size of a file in bytes
 * @param maxSide   maximum width and height in pixels
 * @param maxPixels maximum number of pixels
 */
public record ImageLimits(String noun, List<ImageFormat> formats, long maxBytes, int maxSide, long maxPixels) {
    /** Maximum size of a file that is read as a whole, bytes. */
    private static final long MAX_ARRAY_BYTES = 1 << 30;

    /** Returns the file extensions of the formats, without dots. */
    public List<String> extensions() {
        return formats.stream().flatMap(format -> format.extensions().stream()).toList();
    }

    /** Returns a noun phrase for a file, such as {@code a Radiance HDR or OpenEXR file}. */
    public String description() {
        return "a " + ImageFormat.alternatives(formats, ImageFormat::title) + " file";
    }

    /** Returns these limits with another maximum number of pixels. */
    public ImageLimits withMaxPixels(long pixels) {
        return new ImageLimits(noun, formats, maxBytes, maxSide, pixels);
    }

    /** Returns the beginning of a message about a file. */
    String subject(String name) {
        return noun.isEmpty() ? Quote.path(name) + ": " : noun + " " + Quote.of(name) + " ";
    }

    /**
     * Checks an image size.
     *
     * @throws IOException if it exceeds the limits; the message contains them
     */
    void check(int width, int height) throws IOException {
        if (width < 1 || height < 1 || width > maxSide || height > maxSide) {
            throw new IOException("must have from 1 to " + maxSide + " pixels along each side, has " + width + "×" + height);
        }
        if ((long) width * height > maxPixels) {
            throw new IOException("must have at most " + maxPixels + " pixels, has " + width + "×" + height);
        }
    }

    /** Returns the content of a file for a decoder that needs all of it. */
    byte[] readBytes(Path file) throws IOException {
        return RegularFile.readBytes(file, description(), (int) Math.min(maxBytes, MAX_ARRAY_BYTES));
    }

    /**
     * Opens a file: of the format that the extension of its name says, or one that Java's decoders recognize.
     *
     * @throws IOException if it has no accepted format, or is too large; the message does not contain its name
     */
    ImageSource open(String name, Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException(Files.exists(file) ? "is not a regular file" : "no such file");
        }
        long bytes = Files.size(file);
        if (bytes > maxBytes) {
            throw new IOException("must have at most " + maxBytes + " bytes, has " + bytes);
        }
        return formats.stream().filter(format -> format.isNamed(name)).findFirst().orElse(formats.getFirst()).open(file, this);
    }
}
