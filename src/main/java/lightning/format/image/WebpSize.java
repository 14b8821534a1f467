package lightning.format.image;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import lightning.base.work.HeapBudget;

/**
 * Check of a WebP image before it is decoded. The decoder reserves memory for all pixels that a header names, however short the data is.
 */
final class WebpSize {
    private static final int HEADER = 12;
    private static final int CHUNK_HEADER = 8;
    /** Measured: 36 bytes with loss, in objects for blocks of 16×16 pixels; 3.2 without. */
    private static final int LOSSY_BYTES = 40;
    private static final int LOSSLESS_BYTES = 5;
    /** Bytes before the sides: the signature; or the tag of the frame and its start code. */
    private static final int LOSSLESS_SIDES = 1;
    private static final int LOSSY_SIDES = 6;
    private static final int FRAME_HEADER = 10;
    private static final int SIDE_BITS = 14;
    private static final int MAX_SIDE = (1 << SIDE_BITS) - 1;
    private static final int BLOCK_PIXELS = 256;
    /**
     * Least bits of a block of 16×16 pixels in a key frame. Its mode of prediction has fixed probabilities: another one than B_PRED costs at least
     * 1.2 + 0.7 + 0.6 bits, B_PRED 0.8 bits and at least 0.1 for each of 16 parts, and the mode of colors 0.8 bits (RFC 6386, 11.2 to 11.5).
     */
    private static final int MIN_BLOCK_BITS = 3;

    private WebpSize() {}

    static boolean isWebp(byte[] file) {
        return file.length > HEADER && text(file, 0).equals("RIFF") && text(file, CHUNK_HEADER).equals("WEBP");
    }

    /** Returns whether the frames of a WebP file can have the numbers of pixels that they claim, and there is memory to decode them. */
    static boolean isPlausible(byte[] file) {
        ByteBuffer bytes = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        // All places: a damaged file may have frames where its chunks do not lead.
        for (int i = HEADER; i + CHUNK_HEADER + FRAME_HEADER <= file.length; i++) {
            if (file[i] == 'V' && file[i + 1] == 'P' && file[i + 2] == '8') {
                int frame = i + CHUNK_HEADER;
                if (file[i + 3] == 'L') {
                    int sides = bytes.getInt(frame + LOSSLESS_SIDES);
                    if (!fits((1L + (sides & MAX_SIDE)) * (1 + (sides >> SIDE_BITS & MAX_SIDE)) * LOSSLESS_BYTES)) {
                        return false;
                    }
                } else if (file[i + 3] == ' ') {
                    int sides = bytes.getInt(frame + LOSSY_SIDES);
                    long pixels = (long) (sides & MAX_SIDE) * (sides >>> Short.SIZE & MAX_SIDE);
                    if (!fits(pixels * LOSSY_BYTES) || pixels / BLOCK_PIXELS * MIN_BLOCK_BITS > (long) file.length * Byte.SIZE) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    private static boolean fits(long bytes) {
        return bytes <= HeapBudget.availableBytes();
    }

    private static String text(byte[] file, int at) {
        return new String(file, at, Integer.BYTES, StandardCharsets.ISO_8859_1);
    }
}
