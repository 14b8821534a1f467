package lightning.format.exr;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import org.jspecify.annotations.Nullable;

/** Compression of chunks that can be read; some can be written too. */
public enum ExrCompression {
    NONE(0, 1, (bytes, _) -> bytes, (raw, _) -> raw),
    RLE(1, 1, RunLengthDecoder::decode, (raw, _) -> RunLengthEncoder.encode(BytePrediction.encode(raw))),
    /** zlib of single lines. */
    ZIPS(2, 1, ExrCompression::inflateBytes, ExrCompression::deflateBytes),
    /** zlib of 16 lines. */
    ZIP(3, 16, ExrCompression::inflateBytes, ExrCompression::deflateBytes),
    PIZ(4, 32, PizDecoder::decode, null),
    PXR24(5, 16, Pxr24Decoder::decode, null),
    B44(6, 32, B44Decoder::decode, null),
    B44A(7, 32, B44Decoder::decode, null),
    /** Colors of 32 lines with losses, by DreamWorks Animation. */
    DWAA(8, 32, DwaDecoder::decode, DwaEncoder::encode),
    /** The same of 256 lines. */
    DWAB(9, 256, DwaDecoder::decode, null);

    /**
     * Maximum ratio of uncompressed bytes to compressed ones, except for DWA. zlib reaches 1032, and PXR24 adds a fourth byte to three.
     * Damaged files of a few bytes cannot request large arrays.
     */
    static final long MAX_RATIO = 2048;
    /** Maximum ratio of DWA: four bytes in zlib data for a block of 64 floats. */
    static final long MAX_DWA_RATIO = 64 * 1032;
    /** Compression level that most writers of this format use; on noisy floats more effort gains 1 %. */
    private static final int COMPRESSION_LEVEL = 4;

    private final int code;
    private final int lines;
    private final Decoder decoder;
    /** Encoder; null if it can only be read. */
    private final @Nullable Encoder encoder;

    ExrCompression(int code, int lines, Decoder decoder, @Nullable Encoder encoder) {
        this.code = code;
        this.lines = lines;
        this.decoder = decoder;
        this.encoder = encoder;
    }

    private interface Decoder {
        byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException;
    }

    private interface Encoder {
        byte[] encode(byte[] raw, ExrBlock block);
    }

    /** Returns the compression with a code of the format; empty if it cannot be read. */
    static Optional<ExrCompression> of(int code) {
        return Arrays.stream(values()).filter(c -> c.code == code).findFirst();
    }

    /** Returns the compressions that can be written. */
    public static List<ExrCompression> writable() {
        return Arrays.stream(values()).filter(c -> c.encoder != null).toList();
    }

    /** Returns the keyword in options. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns whether it is DWA, by which colors of written halves lose details. All their other channels keep every bit. */
    public boolean isDwa() {
        return this == DWAA || this == DWAB;
    }

    /** Returns the code of the format. */
    int code() {
        return code;
    }

    /** Returns the scan lines per chunk of a file without tiles. */
    public int lines() {
        return lines;
    }

    /** Returns the maximum ratio of uncompressed bytes to compressed ones. */
    long maxRatio() {
        return isDwa() ? MAX_DWA_RATIO : MAX_RATIO;
    }

    /**
     * Decompresses a chunk. One that is as long as its pixels is not compressed.
     *
     * @param block its layout
     * @throws DataFormatException if the result has another length
     */
    byte[] decompress(byte[] compressed, ExrBlock block) throws DataFormatException {
        DamagedData.rejectIf(block.byteCount() > compressed.length * maxRatio());
        byte[] raw = compressed.length == block.byteCount() ? compressed : decoder.decode(compressed, block);
        DamagedData.rejectIf(raw.length != block.byteCount());
        return raw;
    }

    /**
     * Compresses a chunk; returns it as it is if the result is not shorter.
     *
     * @param raw as long as the block
     * @throws IllegalStateException if this compression cannot be written
     */
    byte[] compress(byte[] raw, ExrBlock block) {
        if (encoder == null) {
            throw new IllegalStateException(this + " cannot be written");
        }
        byte[] compressed = encoder.encode(raw, block);
        return compressed.length < raw.length ? compressed : raw;
    }

    private static byte[] inflateBytes(byte[] compressed, ExrBlock block) throws DataFormatException {
        return BytePrediction.decode(inflate(compressed, (int) block.byteCount()));
    }

    private static byte[] deflateBytes(byte[] raw, ExrBlock block) {
        return deflate(BytePrediction.encode(raw));
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
            DamagedData.rejectIf(inflater.inflate(bytes) != length || inflater.inflate(new byte[1]) != 0);
        }
        return bytes;
    }

    /** Returns the zlib data of some bytes, at most a little longer than these. */
    static byte[] deflate(byte[] bytes) {
        try (Deflater deflater = new Deflater(COMPRESSION_LEVEL)) {
            deflater.setInput(bytes);
            deflater.finish();
            // zlib adds 5 bytes to each block of at most 16 kB, and 6 to all.
            byte[] compressed = new byte[bytes.length + bytes.length / 1000 + 64];
            int length = deflater.deflate(compressed);
            assert deflater.finished();
            return Arrays.copyOf(compressed, length);
        }
    }
}
