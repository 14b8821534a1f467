package lightning.format.exr;

import java.util.Arrays;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Compression of chunks that can be read. */
enum ExrCompression {
    NONE(0, 1, (bytes, _) -> bytes),
    RLE(1, 1, RunLengthDecoder::decode),
    ZIPS(2, 1, ExrCompression::inflateBytes),
    ZIP(3, 16, ExrCompression::inflateBytes),
    PIZ(4, 32, PizDecoder::decode),
    PXR24(5, 16, Pxr24Decoder::decode);

    /**
     * Maximum ratio of uncompressed bytes to compressed ones. zlib reaches 1032, and PXR24 adds a fourth byte to three. Damaged files
     * of a few bytes cannot request large arrays.
     */
    static final long MAX_RATIO = 2048;

    private final int code;
    private final int lines;
    private final Decoder decoder;

    ExrCompression(int code, int lines, Decoder decoder) {
        this.code = code;
        this.lines = lines;
        this.decoder = decoder;
    }

    private interface Decoder {
        byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException;
    }

    /** Returns the compression with a code of the format; empty if it cannot be read. */
    static Optional<ExrCompression> of(int code) {
        return Arrays.stream(values()).filter(c -> c.code == code).findFirst();
    }

    /** Returns the scan lines per chunk of a file without tiles. */
    int lines() {
        return lines;
    }

    /**
     * Decompresses a chunk. One that is as long as its pixels is not compressed.
     *
     * @param block its layout
     * @throws DataFormatException if the result has another length
     */
    byte[] decompress(byte[] compressed, ExrBlock block) throws DataFormatException {
        if (block.byteCount() > compressed.length * MAX_RATIO) {
            throw new DataFormatException();
        }
        byte[] raw = compressed.length == block.byteCount() ? compressed : decoder.decode(compressed, block);
        if (raw.length != block.byteCount()) {
            throw new DataFormatException();
        }
        return raw;
    }

    private static byte[] inflateBytes(byte[] compressed, ExrBlock block) throws DataFormatException {
        return BytePrediction.decode(inflate(compressed, (int) block.byteCount()));
    }

    /**
     * Decompresses zlib data.
     *
     * @throws DataFormatException if the result has another length
     */
    static byte[] inflate(byte[] compressed, int length) throws DataFormatException {
        byte[] bytes = new byte[length];
        try (Inflater inflater = new Inflater()) {
            inflater.setInput(compressed);
            if (inflater.inflate(bytes) != length || inflater.inflate(new byte[1]) != 0) {
                throw new DataFormatException();
            }
        }
        return bytes;
    }
}
