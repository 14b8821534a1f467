package lightning.format.gltf;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import lightning.base.text.RefusalException;

/**
 * Decoder of compressed buffer views (EXT_meshopt_compression, appendix A): attributes, triangles and sequences of indices. The input is
 * read with bounds checks of Java: damaged data throws an {@link IndexOutOfBoundsException} or {@link IllegalArgumentException}.
 */
final class MeshoptCodec {
    private static final int ATTRIBUTES = 0xA0;
    private static final int TRIANGLES = 0xE1;
    private static final int INDICES = 0xD1;
    private static final int GROUP = 16;
    private static final int MAX_BLOCK_BYTES = 8192;
    private static final int MAX_BLOCK = 256;
    private static final int MIN_TAIL = 32;
    private static final int FIFO = 16;

    private final byte[] in;
    private int next;

    private MeshoptCodec(byte[] in) {
        this.in = in;
    }

    /**
     * Decodes attributes.
     *
     * @param count  number of elements
     * @param stride bytes of an element, a multiple of 4 up to 256
     * @return {@code byte[count * stride]}
     */
    static byte[] attributes(byte[] in, int count, int stride) {
        return new MeshoptCodec(in).attributes(count, stride);
    }

    /**
     * Decodes triangles.
     *
     * @param count number of indices, a multiple of 3
     */
    static int[] triangles(byte[] in, int count) {
        return new MeshoptCodec(in).triangles(count);
    }

    /** Decodes a sequence of indices. */
    static int[] indices(byte[] in, int count) {
        return new MeshoptCodec(in).indices(count);
    }

    private int read() {
        return in[next++] & 0xFF;
    }

    private void requireHeader(int header) {
        if (read() != header) {
            throw new RefusalException("has an unknown header " + (in[0] & 0xFF));
        }
    }

    private byte[] attributes(int count, int stride) {
        requireHeader(ATTRIBUTES);
        byte[] out = new byte[Math.multiplyExact(count, stride)];
        byte[] last = Arrays.copyOfRange(in, in.length - stride, in.length);
        int most = Math.min(MAX_BLOCK_BYTES / stride & -GROUP, MAX_BLOCK);
        byte[] deltas = new byte[most];
        for (int start = 0; start < count; start += most) {
            int size = Math.min(most, count - start);
            for (int k = 0; k < stride; k++) {
                readBytes(deltas, (size + GROUP - 1) / GROUP);
                byte value = last[k];
                for (int i = 0; i < size; i++) {
                    int zigzag = deltas[i] & 0xFF;
                    value += (byte) (-(zigzag & 1) ^ zigzag >> 1);
                    out[(start + i) * stride + k] = value;
                }
                last[k] = value;
            }
        }
        if (in.length - next != Math.max(MIN_TAIL, stride)) {
            throw new RefusalException("has " + (in.length - next) + " bytes at the end");
        }
        return out;
    }

    /** Reads groups of 16 bytes, each with its number of bits: 0, 2, 4 or 8. */
    private void readBytes(byte[] out, int groups) {
        int header = next;
        next += (groups + 3) / 4;
        for (int g = 0; g < groups; g++) {
            int code = in[header + g / 4] >> g % 4 * 2 & 3;
            switch (code) {
                case 0 -> Arrays.fill(out, g * GROUP, (g + 1) * GROUP, (byte) 0);
                case 3 -> {
                    System.arraycopy(in, next, out, g * GROUP, GROUP);
                    next += GROUP;
                }
                default -> readBits(out, g * GROUP, 2 * code);
            }
        }
    }

    /** Reads 16 numbers of a few bits, the highest of a byte first; the largest one says that a whole byte follows after all. */
    private void readBits(byte[] out, int at, int bits) {
        int packed = next;
        next += GROUP * bits / 8;
        int escape = (1 << bits) - 1;
        for (int i = 0; i < GROUP; i++) {
            int v = in[packed + i * bits / 8] >> 8 - bits - i * bits % 8 & escape;
            out[at + i] = v == escape ? in[next++] : (byte) v;
        }
    }

    private int readVarint() {
        int v = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            int b = read();
            v |= (b & 0x7F) << shift;
            if (b < 0x80) {
                break;
            }
        }
        return v;
    }

    private static int signed(int zigzag) {
        return zigzag >>> 1 ^ -(zigzag & 1);
    }

    private int[] indices(int count) {
        requireHeader(INDICES);
        int[] out = new int[count];
        int[] last = new int[2];
        for (int i = 0; i < count; i++) {
            int v = readVarint();
            int which = v & 1;
            last[which] += signed(v >>> 1);
            out[i] = last[which];
        }
        return out;
    }

    /** State of the triangle decoder: the newest vertices and edges, and the next new vertex. */
    private static final class Recent {
        private final int[] vertices = new int[FIFO];
        private final int[] edges = new int[2 * FIFO];
        private int vertex;
        private int edge;
        private int fresh;

        Recent() {
            Arrays.fill(vertices, -1);
            Arrays.fill(edges, -1);
        }

        int vertex(int back) {
            return vertices[vertex - back & FIFO - 1];
        }

        void push(int v, boolean keeps) {
            vertices[vertex] = v;
            vertex = keeps ? vertex + 1 & FIFO - 1 : vertex;
        }

        void pushEdge(int a, int b) {
            edges[2 * edge] = a;
            edges[2 * edge + 1] = b;
            edge = edge + 1 & FIFO - 1;
        }

        void pushEdges(int a, int b, int c) {
            pushEdge(b, a);
            pushEdge(c, b);
            pushEdge(a, c);
        }

        /** Returns a vertex by its code: 0 for the next new one, otherwise how far back it is. */
        int byCode(int code) {
            return code == 0 ? fresh++ : vertex(code);
        }
    }

    private int[] triangles(int count) {
        requireHeader(TRIANGLES);
        int[] out = new int[count];
        var recent = new Recent();
        int codes = next;
        next += count / 3;
        int table = in.length - FIFO;
        int last = 0;
        for (int i = 0; i < count; i += 3) {
            if (next > table) {
                throw new RefusalException("ends after " + i / 3 + " of " + count / 3 + " triangles");
            }
            int code = in[codes + i / 3] & 0xFF;
            int a;
            int b;
            int c;
            if (code < 0xF0) {
                int edge = recent.edge - 1 - (code >> 4) & FIFO - 1;
                a = recent.edges[2 * edge];
                b = recent.edges[2 * edge + 1];
                int third = code & 15;
                if (third < 13) {
                    c = third == 0 ? recent.fresh++ : recent.vertex(third + 1);
                    recent.push(c, third == 0);
                } else {
                    last = third == 15 ? last + signed(readVarint()) : last + (third == 13 ? -1 : 1);
                    c = last;
                    recent.push(c, true);
                }
                recent.pushEdge(c, b);
                recent.pushEdge(a, c);
            } else if (code < 0xFE) {
                int both = in[table + (code & 15)] & 0xFF;
                a = recent.fresh++;
                b = recent.byCode(both >> 4);
                c = recent.byCode(both & 15);
                recent.push(a, true);
                recent.push(b, both >> 4 == 0);
                recent.push(c, (both & 15) == 0);
                recent.pushEdges(a, b, c);
            } else {
                int both = read();
                int second = both >> 4;
                int third = both & 15;
                if (both == 0) {
                    recent.fresh = 0;
                }
                a = code == 0xFE ? recent.fresh++ : 0;
                b = second == 15 ? 0 : recent.byCode(second);
                c = third == 15 ? 0 : recent.byCode(third);
                if (code == 0xFF) {
                    last += signed(readVarint());
                    a = last;
                }
                if (second == 15) {
                    last += signed(readVarint());
                    b = last;
                }
                if (third == 15) {
                    last += signed(readVarint());
                    c = last;
                }
                recent.push(a, true);
                recent.push(b, second == 0 || second == 15);
                recent.push(c, third == 0 || third == 15);
                recent.pushEdges(a, b, c);
            }
            out[i] = a;
            out[i + 1] = b;
            out[i + 2] = c;
        }
        if (next != table) {
            throw new RefusalException("has " + (table - next) + " bytes at the end");
        }
        return out;
    }

    /** Replaces octahedral directions by unit vectors; the fourth component stays. */
    static void decodeOctahedral(byte[] data, int stride) {
        ByteBuffer out = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        int bytes = stride / 4;
        double max = bytes == 1 ? Byte.MAX_VALUE : Short.MAX_VALUE;
        for (int at = 0; at < data.length; at += stride) {
            double x = number(out, at, bytes);
            double y = number(out, at + bytes, bytes);
            double z = number(out, at + 2 * bytes, bytes) - Math.abs(x) - Math.abs(y);
            double t = Math.min(z, 0);
            x += x >= 0 ? t : -t;
            y += y >= 0 ? t : -t;
            double scale = max / Math.sqrt(x * x + y * y + z * z);
            put(out, at, bytes, x * scale);
            put(out, at + bytes, bytes, y * scale);
            put(out, at + 2 * bytes, bytes, z * scale);
        }
    }

    /** Replaces three components of a quaternion and the place of the largest one by four components. */
    static void decodeQuaternion(byte[] data) {
        ByteBuffer out = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        for (int at = 0; at < data.length; at += 8) {
            int packed = out.getShort(at + 6);
            double scale = Math.sqrt(0.5) / (packed | 3);
            double[] q = {out.getShort(at) * scale, out.getShort(at + 2) * scale, out.getShort(at + 4) * scale};
            double largest = Math.sqrt(Math.max(0, 1 - q[0] * q[0] - q[1] * q[1] - q[2] * q[2]));
            for (int k = 1; k <= 3; k++) {
                put(out, at + 2 * (packed + k & 3), 2, q[k - 1] * Short.MAX_VALUE);
            }
            put(out, at + 2 * (packed & 3), 2, largest * Short.MAX_VALUE);
        }
    }

    /** Replaces numbers of an exponent of 8 and a mantissa of 24 bits by floats. */
    static void decodeExponential(byte[] data) {
        ByteBuffer out = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        for (int at = 0; at < data.length; at += 4) {
            int v = out.getInt(at);
            out.putFloat(at, (float) Math.scalb((double) (v << 8 >> 8), v >> 24));
        }
    }

    private static double number(ByteBuffer in, int at, int bytes) {
        return bytes == 1 ? in.get(at) : in.getShort(at);
    }

    /** Rounds half away from 0. */
    private static void put(ByteBuffer out, int at, int bytes, double v) {
        int rounded = (int) (v + (v >= 0 ? 0.5 : -0.5));
        if (bytes == 1) {
            out.put(at, (byte) rounded);
        } else {
            out.putShort(at, (short) rounded);
        }
    }
}
