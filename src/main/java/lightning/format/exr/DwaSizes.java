package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.DataFormatException;

/**
 * Numbers at the start of a DWA chunk.
 *
 * @param version 0, 1, or 2 for chunks with rules
 * @param zlibBytes bytes of channels stored as zlib, uncompressed
 * @param zlibStored bytes of these in the chunk
 * @param acStored bytes of the cosines without the means of blocks
 * @param dcStored bytes of the means of blocks
 * @param runsStored bytes of channels stored as runs
 * @param runsEncoded bytes of these, uncompressed, as runs
 * @param runsBytes bytes of these channels
 * @param acCount 16-bit numbers of cosines
 * @param dcCount 16-bit numbers of means
 * @param acCode code of the compression of the cosines: {@link #HUFFMAN} or {@link #DEFLATE}
 */
record DwaSizes(int version, int zlibBytes, int zlibStored, int acStored, int dcStored, int runsStored, int runsEncoded, int runsBytes,
        int acCount, int dcCount, int acCode) {
    static final int MAX_VERSION = 2;
    static final int HUFFMAN = 0;
    static final int DEFLATE = 1;
    /** Length in bytes. */
    static final int BYTES = 11 * Long.BYTES;

    /**
     * Reads the numbers.
     *
     * @param in little-endian
     * @throws DataFormatException if one is negative, or too large for any chunk
     */
    static DwaSizes read(ByteBuffer in) throws DataFormatException {
        return new DwaSizes(next(in), next(in), next(in), next(in), next(in), next(in), next(in), next(in), next(in), next(in), next(in));
    }

    private static int next(ByteBuffer in) throws DataFormatException {
        long value = in.getLong();
        DamagedData.rejectIf(value < 0 || value > Integer.MAX_VALUE / 2);
        return (int) value;
    }

    /** Returns the bytes of the numbers. */
    byte[] encode() {
        ByteBuffer out = ByteBuffer.allocate(BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : new int[] {version, zlibBytes, zlibStored, acStored, dcStored, runsStored, runsEncoded, runsBytes, acCount,
            dcCount, acCode}) {
            out.putLong(value);
        }
        return out.array();
    }
}
