package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;

/**
 * Decoder of PIZ's canonical Huffman codes for 16-bit numbers. The largest symbol repeats the number before it; eight bits say how often.
 * A longer code is a smaller number than the beginning of a shorter one.
 */
final class HuffmanDecoder {
    private static final int MAX_SYMBOLS = (1 << 16) + 1;
    /** Maximum length of a code. Longer ones would need more than 2³⁸ numbers. */
    private static final int MAX_CODE_BITS = 56;
    /** Bits of a code length, or of a run of symbols without a code. */
    private static final int LENGTH_BITS = 6;
    private static final int SHORT_RUN = 59;
    private static final int LONG_RUN = 63;
    private static final int MIN_SHORT_RUN = 2;
    private static final int MIN_LONG_RUN = MIN_SHORT_RUN + LONG_RUN - SHORT_RUN;
    private static final int COUNT_BITS = 8;
    /** Codes up to this length are looked up. */
    private static final int TABLE_BITS = 12;

    /** Smallest code of each length. */
    private final long[] firstCodes = new long[MAX_CODE_BITS + 1];
    private final int[] codeCounts = new int[MAX_CODE_BITS + 1];
    /** Index of the first symbol of each length in {@link #symbols}. */
    private final int[] firstSymbols = new int[MAX_CODE_BITS + 1];
    private final int[] symbols;
    /** Symbol and length of the code that begins each number of {@link #TABLE_BITS} bits; 0 for a longer one. */
    private final int[] table = new int[1 << TABLE_BITS];

    private HuffmanDecoder(byte[] lengths) throws DataFormatException {
        int total = 0;
        for (byte length : lengths) {
            codeCounts[length]++;
        }
        codeCounts[0] = 0;
        long code = 0;
        for (int length = MAX_CODE_BITS; length > 0; length--) {
            firstCodes[length] = code;
            firstSymbols[length] = total;
            total += codeCounts[length];
            code = code + codeCounts[length] >> 1;
        }
        symbols = new int[total];
        int[] next = firstSymbols.clone();
        for (int symbol = 0; symbol < lengths.length; symbol++) {
            if (lengths[symbol] > 0) {
                symbols[next[lengths[symbol]]++] = symbol;
            }
        }
        fillTable();
    }

    private void fillTable() throws DataFormatException {
        for (int length = 1; length <= TABLE_BITS; length++) {
            DamagedData.rejectIf(firstCodes[length] + codeCounts[length] > 1L << length);
            int span = TABLE_BITS - length;
            for (int i = 0; i < codeCounts[length]; i++) {
                int start = (int) (firstCodes[length] + i) << span;
                Arrays.fill(table, start, start + (1 << span), symbols[firstSymbols[length] + i] << LENGTH_BITS | length);
            }
        }
    }

    /**
     * Decodes a block.
     *
     * @param data header, code lengths and codes
     * @param count expected numbers
     * @throws DataFormatException if the data is damaged
     */
    static short[] decode(ByteBuffer data, int count) throws DataFormatException {
        ByteBuffer in = data.order(ByteOrder.LITTLE_ENDIAN);
        int firstSymbol = in.getInt();
        int lastSymbol = in.getInt();
        in.getInt();
        int bits = in.getInt();
        in.getInt();
        DamagedData.rejectIf(firstSymbol < 0 || lastSymbol < firstSymbol || lastSymbol >= MAX_SYMBOLS || bits < 0);
        byte[] lengths = new byte[lastSymbol + 1];
        readLengths(new BitReader(in, (long) in.remaining() * Byte.SIZE), lengths, firstSymbol);
        DamagedData.rejectIf(bits > (long) in.remaining() * Byte.SIZE);
        return new HuffmanDecoder(lengths).decode(new BitReader(in, bits), lastSymbol, count);
    }

    private static void readLengths(BitReader in, byte[] lengths, int firstSymbol) throws DataFormatException {
        for (int symbol = firstSymbol; symbol < lengths.length;) {
            int length = in.read(LENGTH_BITS);
            if (length >= SHORT_RUN) {
                symbol += length == LONG_RUN ? in.read(COUNT_BITS) + MIN_LONG_RUN : length - SHORT_RUN + MIN_SHORT_RUN;
                DamagedData.rejectIf(symbol > lengths.length);
            } else if (length > MAX_CODE_BITS) {
                throw new DataFormatException();
            } else {
                lengths[symbol++] = (byte) length;
            }
        }
    }

    private short[] decode(BitReader in, int repeatSymbol, int count) throws DataFormatException {
        short[] numbers = new short[count];
        int n = 0;
        while (in.hasRemaining()) {
            int symbol = readSymbol(in);
            int repeats = symbol == repeatSymbol ? in.read(COUNT_BITS) : 1;
            DamagedData.rejectIf(repeats > count - n || symbol == repeatSymbol && n == 0);
            Arrays.fill(numbers, n, n + repeats, symbol == repeatSymbol ? numbers[n - 1] : (short) symbol);
            n += repeats;
        }
        DamagedData.rejectIf(n < count);
        return numbers;
    }

    private int readSymbol(BitReader in) throws DataFormatException {
        int entry = table[(int) in.peek(TABLE_BITS)];
        if (entry != 0) {
            in.skip(entry & (1 << LENGTH_BITS) - 1);
            return entry >> LENGTH_BITS;
        }
        for (int length = TABLE_BITS + 1; length <= MAX_CODE_BITS; length++) {
            long index = in.peek(length) - firstCodes[length];
            if (index >= 0 && index < codeCounts[length]) {
                in.skip(length);
                return symbols[firstSymbols[length] + (int) index];
            }
        }
        throw new DataFormatException();
    }

    /** Reader of bits, from the highest bit of each byte. Takes whole bytes from its buffer. */
    private static final class BitReader {
        private final ByteBuffer in;
        private long left;
        /** Next bits, from the highest one. */
        private long buffer;
        private int buffered;

        BitReader(ByteBuffer in, long bits) {
            this.in = in;
            left = bits;
        }

        boolean hasRemaining() {
            return left > 0;
        }

        /** Returns the next bits, with zeros after the end. */
        long peek(int count) {
            while (buffered < count && in.hasRemaining()) {
                buffer |= (in.get() & 0xFFL) << Long.SIZE - Byte.SIZE - buffered;
                buffered += Byte.SIZE;
            }
            return buffer >>> Long.SIZE - count;
        }

        void skip(int count) throws DataFormatException {
            DamagedData.rejectIf(count > left || count > buffered);
            left -= count;
            buffer <<= count;
            buffered -= count;
        }

        int read(int count) throws DataFormatException {
            int bits = (int) peek(count);
            skip(count);
            return bits;
        }
    }
}
