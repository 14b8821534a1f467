package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.DataFormatException;

/**
 * Decoder of PXR24 chunks: zlib data of differences between neighbors in a line, whose high bytes precede the lower ones. Floats have
 * lost their lowest byte.
 */
final class Pxr24Decoder {
    /** Bytes of a float without its lowest one. */
    private static final int FLOAT_BYTES = 3;

    private Pxr24Decoder() {}

    static byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException {
        long lineBytes = block.channels().stream().mapToLong(c -> (long) storedBytes(c.type()) * block.width()).sum();
        byte[] stored = ExrCompression.inflate(compressed, (int) (lineBytes * block.height()));
        ByteBuffer out = ByteBuffer.allocate((int) block.byteCount()).order(ByteOrder.LITTLE_ENDIAN);
        int in = 0;
        for (int y = 0; y < block.height(); y++) {
            for (ExrChannel channel : block.channels()) {
                decodeLine(stored, in, block.width(), channel.type(), out);
                in += storedBytes(channel.type()) * block.width();
            }
        }
        return out.array();
    }

    private static int storedBytes(ExrType type) {
        return type == ExrType.FLOAT ? FLOAT_BYTES : type.bytes();
    }

    private static void decodeLine(byte[] stored, int start, int width, ExrType type, ByteBuffer out) {
        int planes = storedBytes(type);
        int value = 0;
        for (int x = 0; x < width; x++) {
            int difference = 0;
            for (int p = 0; p < planes; p++) {
                difference = difference << Byte.SIZE | stored[start + p * width + x] & 0xFF;
            }
            value += difference;
            switch (type) {
                case UINT -> out.putInt(value);
                case HALF -> out.putShort((short) value);
                case FLOAT -> out.putInt(value << Byte.SIZE);
            }
        }
    }
}
