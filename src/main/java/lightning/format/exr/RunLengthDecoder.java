package lightning.format.exr;

import java.util.Arrays;
import java.util.zip.DataFormatException;

/** Decoder of RLE chunks: a count −n before n bytes, or a count n before a byte that is repeated n + 1 times. */
final class RunLengthDecoder {
    private RunLengthDecoder() {}

    static byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException {
        return BytePrediction.decode(decode(compressed, (int) block.byteCount()));
    }

    /**
     * Decodes runs alone.
     *
     * @throws DataFormatException if the result has another length
     */
    static byte[] decode(byte[] compressed, int decodedLength) throws DataFormatException {
        byte[] bytes = new byte[decodedLength];
        int out = 0;
        for (int in = 0; in < compressed.length;) {
            int count = compressed[in++];
            int length = count < 0 ? -count : count + 1;
            int used = count < 0 ? length : 1;
            DamagedData.rejectIf(used > compressed.length - in || length > bytes.length - out);
            if (count < 0) {
                System.arraycopy(compressed, in, bytes, out, length);
            } else {
                Arrays.fill(bytes, out, out + length, compressed[in]);
            }
            in += used;
            out += length;
        }
        DamagedData.rejectIf(out < bytes.length);
        return bytes;
    }
}
