package lightning.format.exr;

import java.io.ByteArrayOutputStream;

/** Encoder of RLE chunks: a count −n before n bytes, or a count n before a byte that is repeated n + 1 times. */
final class RunLengthEncoder {
    /** Shorter runs take no less room than single bytes. */
    private static final int MIN_RUN = 3;
    private static final int MAX_RUN = 128;
    private static final int MAX_LITERAL = 127;

    private RunLengthEncoder() {}

    static byte[] encode(byte[] bytes) {
        var out = new ByteArrayOutputStream(bytes.length / 2);
        int literal = 0;
        for (int at = 0; at < bytes.length;) {
            int run = runLength(bytes, at);
            if (run >= MIN_RUN) {
                writeLiteral(bytes, literal, at, out);
                out.write(run - 1);
                out.write(bytes[at]);
                at += run;
                literal = at;
            } else {
                at += run;
            }
        }
        writeLiteral(bytes, literal, bytes.length, out);
        return out.toByteArray();
    }

    private static int runLength(byte[] bytes, int start) {
        int end = start + 1;
        while (end < bytes.length && end - start < MAX_RUN && bytes[end] == bytes[start]) {
            end++;
        }
        return end - start;
    }

    private static void writeLiteral(byte[] bytes, int start, int end, ByteArrayOutputStream out) {
        for (int at = start; at < end; at += MAX_LITERAL) {
            int length = Math.min(MAX_LITERAL, end - at);
            out.write(-length);
            out.write(bytes, at, length);
        }
    }
}
