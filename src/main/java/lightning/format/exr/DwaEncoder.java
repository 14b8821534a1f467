package lightning.format.exr;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import lightning.format.exr.DwaRule.Scheme;

/** Encoder of DWA chunks, as {@link DwaDecoder} reads them: colors of halves with losses, all else without. */
final class DwaEncoder {
    private DwaEncoder() {}

    static byte[] encode(byte[] raw, ExrBlock block) {
        ByteBuffer in = ByteBuffer.wrap(raw).order(ByteOrder.LITTLE_ENDIAN);
        DwaLayout layout = DwaLayout.of(block, DwaRule.WRITTEN);
        byte[] zlib = plain(layout, Scheme.ZLIB, raw);
        byte[] runs = plain(layout, Scheme.RUNS, raw);
        byte[] encodedRuns = runs.length == 0 ? runs : RunLengthEncoder.encode(runs);
        var blocks = new DwaBlockWriter(layout);
        blocks.write(in);
        byte[] ac = blocks.ac();
        byte[] dc = blocks.dc();
        byte[] storedZlib = deflate(zlib);
        byte[] storedAc = deflate(ac);
        byte[] storedDc = deflate(BytePrediction.encode(dc));
        byte[] storedRuns = deflate(encodedRuns);
        var sizes = new DwaSizes(DwaSizes.MAX_VERSION, zlib.length, storedZlib.length, storedAc.length, storedDc.length, storedRuns.length,
                encodedRuns.length, runs.length, ac.length / Short.BYTES, dc.length / Short.BYTES, DwaSizes.DEFLATE);
        var out = new ByteArrayOutputStream();
        out.writeBytes(sizes.encode());
        out.writeBytes(DwaRule.encode(DwaRule.WRITTEN));
        out.writeBytes(storedZlib);
        out.writeBytes(storedAc);
        out.writeBytes(storedDc);
        out.writeBytes(storedRuns);
        return out.toByteArray();
    }

    private static byte[] deflate(byte[] bytes) {
        return bytes.length == 0 ? bytes : ExrCompression.deflate(bytes);
    }

    /** Returns the channels of a storage without losses. */
    private static byte[] plain(DwaLayout layout, Scheme scheme, byte[] raw) {
        byte[] to = new byte[layout.bytes(scheme)];
        layout.forEachByte(scheme, (line, stored) -> to[stored] = raw[line]);
        return to;
    }
}
