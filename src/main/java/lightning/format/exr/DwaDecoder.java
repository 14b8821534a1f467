package lightning.format.exr;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.DataFormatException;
import lightning.format.exr.DwaRule.Scheme;

/**
 * Decoder of DWA chunks: colors as cosines of blocks of 8 × 8 pixels on a curve, as luminance and two differences; alpha as runs; all other
 * channels as zlib data.
 */
final class DwaDecoder {
    private DwaDecoder() {}

    static byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException {
        try {
            ByteBuffer in = ByteBuffer.wrap(compressed).order(ByteOrder.LITTLE_ENDIAN);
            DwaSizes sizes = DwaSizes.read(in);
            DamagedData.rejectIf(sizes.version() > DwaSizes.MAX_VERSION);
            DwaLayout layout = DwaLayout.of(block, sizes.version() < DwaSizes.MAX_VERSION ? DwaRule.LEGACY : DwaRule.read(in));
            check(sizes, layout);
            byte[] zlib = inflate(read(in, sizes.zlibStored()), sizes.zlibBytes());
            short[] ac = readCosines(read(in, sizes.acStored()), sizes);
            byte[] dc = BytePrediction.decode(inflate(read(in, sizes.dcStored()), Short.BYTES * sizes.dcCount()));
            byte[] runs = RunLengthDecoder.decode(inflate(read(in, sizes.runsStored()), sizes.runsEncoded()), sizes.runsBytes());
            ByteBuffer out = ByteBuffer.allocate((int) block.byteCount()).order(ByteOrder.LITTLE_ENDIAN);
            new DwaBlockReader(layout, ac, numbers(dc)).read(out);
            layout.forEachByte(Scheme.ZLIB, (line, stored) -> out.put(line, zlib[stored]));
            layout.forEachByte(Scheme.RUNS, (line, stored) -> out.put(line, runs[stored]));
            return out.array();
        } catch (BufferUnderflowException e) {
            throw (DataFormatException) new DataFormatException().initCause(e);
        }
    }

    /** Compares the numbers of a chunk with its channels, before anyone makes room for them. */
    private static void check(DwaSizes sizes, DwaLayout layout) throws DataFormatException {
        boolean fits = layout.isValid() && sizes.zlibBytes() == layout.bytes(Scheme.ZLIB) && sizes.runsBytes() == layout.bytes(Scheme.RUNS)
                && sizes.runsEncoded() <= 2L * sizes.runsBytes() && sizes.dcCount() == layout.blockCount()
                && sizes.acCount() <= (long) (DwaLayout.BLOCK - 1) * layout.blockCount();
        DamagedData.rejectIf(!fits);
    }

    private static byte[] read(ByteBuffer in, int length) throws DataFormatException {
        DamagedData.rejectIf(length > in.remaining());
        byte[] bytes = new byte[length];
        in.get(bytes);
        return bytes;
    }

    /** Decompresses zlib data; nothing is stored as no bytes. */
    private static byte[] inflate(byte[] compressed, int length) throws DataFormatException {
        return length == 0 && compressed.length == 0 ? compressed : ExrCompression.inflate(compressed, length);
    }

    private static short[] readCosines(byte[] stored, DwaSizes sizes) throws DataFormatException {
        if (sizes.acCount() == 0) {
            return new short[0];
        }
        return switch (sizes.acCode()) {
            case DwaSizes.HUFFMAN -> HuffmanDecoder.decode(ByteBuffer.wrap(stored), sizes.acCount());
            case DwaSizes.DEFLATE -> numbers(inflate(stored, Short.BYTES * sizes.acCount()));
            default -> throw new DataFormatException();
        };
    }

    private static short[] numbers(byte[] bytes) {
        short[] numbers = new short[bytes.length / Short.BYTES];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(numbers);
        return numbers;
    }
}
