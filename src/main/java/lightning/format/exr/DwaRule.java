package lightning.format.exr;

import java.io.ByteArrayOutputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.DataFormatException;

/**
 * Rule of a DWA chunk: how it stores channels of some names.
 *
 * @param suffix last part of their names
 * @param ignoresCase whether upper and lower case are the same
 * @param color 0 for red, 1 for green, 2 for blue of a color; −1 for a channel on its own
 */
record DwaRule(String suffix, boolean ignoresCase, ExrType type, Scheme scheme, int color) {
    /** Storage of a channel; the order is that of the codes in a file. */
    enum Scheme {
        /** zlib data. */
        ZLIB,
        /** Quantized cosines. */
        COSINES,
        /** Runs of equal bytes, then zlib. */
        RUNS
    }

    /** Rules of chunks that have none. */
    static final List<DwaRule> LEGACY = legacyRules();

    /**
     * Rules of written chunks: colors of halves, and alpha. Floats keep every bit, so that ids of mattes, whose channels have the names of
     * colors, do.
     */
    static final List<DwaRule> WRITTEN = List.of(new DwaRule("R", false, ExrType.HALF, Scheme.COSINES, 0),
            new DwaRule("G", false, ExrType.HALF, Scheme.COSINES, 1), new DwaRule("B", false, ExrType.HALF, Scheme.COSINES, 2),
            new DwaRule("A", false, ExrType.HALF, Scheme.RUNS, -1));

    private static final int NUMBER_BYTES = 2;
    private static final int COLOR_SHIFT = 4;
    private static final int SCHEME_SHIFT = 2;
    private static final int SCHEME_MASK = 3;
    private static final int MAX_COLOR = 2;

    private static List<DwaRule> legacyRules() {
        List<List<String>> names = List.of(List.of("r", "red"), List.of("g", "grn", "green"), List.of("b", "blu", "blue"));
        List<DwaRule> rules = new ArrayList<>();
        for (ExrType type : List.of(ExrType.HALF, ExrType.FLOAT)) {
            for (int color = 0; color < names.size(); color++) {
                for (String name : names.get(color)) {
                    rules.add(new DwaRule(name, true, type, Scheme.COSINES, color));
                }
            }
            for (String name : List.of("y", "by", "ry")) {
                rules.add(new DwaRule(name, true, type, Scheme.COSINES, -1));
            }
        }
        for (ExrType type : ExrType.values()) {
            rules.add(new DwaRule("a", true, type, Scheme.RUNS, -1));
        }
        return rules;
    }

    private boolean matches(ExrChannel channel) {
        return channel.type() == type && (ignoresCase ? channel.suffix().equalsIgnoreCase(suffix) : channel.suffix().equals(suffix));
    }

    /** Returns whether a channel is a color's red, green or blue. */
    boolean isColor() {
        return color >= 0;
    }

    /** Returns the rule of each channel: the last one that matches; zlib without one. */
    static List<DwaRule> ofChannels(List<DwaRule> rules, List<ExrChannel> channels) {
        return channels.stream().map(channel -> rules.reversed().stream().filter(rule -> rule.matches(channel)).findFirst()
                .orElse(new DwaRule(channel.suffix(), false, channel.type(), Scheme.ZLIB, -1))).toList();
    }

    /**
     * Reads the rules of a chunk: their length in bytes with that of this number, then the rules.
     *
     * @param in little-endian
     */
    static List<DwaRule> read(ByteBuffer in) throws DataFormatException {
        int length = Short.toUnsignedInt(in.getShort()) - NUMBER_BYTES;
        DamagedData.rejectIf(length < 0 || length > in.remaining());
        ByteBuffer bytes = in.slice(in.position(), length);
        in.position(in.position() + length);
        List<DwaRule> rules = new ArrayList<>();
        try {
            while (bytes.hasRemaining()) {
                rules.add(readRule(bytes));
            }
        } catch (BufferUnderflowException e) {
            throw (DataFormatException) new DataFormatException().initCause(e);
        }
        return rules;
    }

    private static DwaRule readRule(ByteBuffer in) throws DataFormatException {
        var name = new ByteArrayOutputStream();
        for (byte b = in.get(); b != 0; b = in.get()) {
            name.write(b);
        }
        int flags = Byte.toUnsignedInt(in.get());
        int type = in.get();
        int scheme = flags >> SCHEME_SHIFT & SCHEME_MASK;
        int color = (flags >> COLOR_SHIFT) - 1;
        DamagedData.rejectIf(type < 0 || type >= ExrType.values().length || scheme >= Scheme.values().length || color > MAX_COLOR);
        return new DwaRule(name.toString(StandardCharsets.ISO_8859_1), (flags & 1) != 0, ExrType.values()[type], Scheme.values()[scheme],
                color);
    }

    /** Returns the bytes of some rules in a chunk, as {@link #read} expects them. */
    static byte[] encode(List<DwaRule> rules) {
        var out = new ByteArrayOutputStream();
        for (DwaRule rule : rules) {
            out.writeBytes(rule.suffix.getBytes(StandardCharsets.ISO_8859_1));
            out.write(0);
            out.write(rule.color + 1 << COLOR_SHIFT | rule.scheme.ordinal() << SCHEME_SHIFT | (rule.ignoresCase ? 1 : 0));
            out.write(rule.type.ordinal());
        }
        int length = out.size() + NUMBER_BYTES;
        byte[] bytes = Arrays.copyOf(new byte[] {(byte) length, (byte) (length >> Byte.SIZE)}, length);
        System.arraycopy(out.toByteArray(), 0, bytes, NUMBER_BYTES, out.size());
        return bytes;
    }
}
