package lightning.editor.document.motion;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import lightning.base.file.OrdinaryFile;
import lightning.base.file.SafeFile;
import lightning.base.math.Vec3;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;

/** Motion paths as text; the format is described in {@code docs/motion-path.md}. */
public final class MotionPathFile {
    private static final String HEAD = "lightning-path 1";
    private static final int MAX_BYTES = 32 << 20;
    private static final int WORDS = 8;
    private static final Pattern SPACE = Pattern.compile("[ \\t]+");

    private MotionPathFile() {}

    /** A path as text that reads back as an equal path. */
    public static String write(MotionPath path) {
        StringBuilder text = new StringBuilder(HEAD).append("\nevery ").append(path.every()).append('\n');
        for (MotionPath.Key key : path.keys()) {
            text.append("at ").append(text(key.position())).append("  direction ").append(text(key.direction())).append('\n');
        }
        return text.toString();
    }

    /** Writes a path to a file, at once or not at all. */
    public static void save(MotionPath path, Path file) throws IOException {
        SafeFile.write(file, out -> out.write(write(path).getBytes(StandardCharsets.UTF_8)));
    }

    /**
     * Reads a path from a file.
     *
     * @throws IOException if it cannot be read or is no motion path: {@code file:line: what was expected and found}
     */
    public static MotionPath load(Path file) throws IOException {
        byte[] bytes;
        try (InputStream in = OrdinaryFile.open(file, "a motion path")) {
            bytes = in.readNBytes(MAX_BYTES + 1);
        }
        if (bytes.length > MAX_BYTES) {
            throw new IOException(Quote.path(file) + ": a motion path may have at most " + MAX_BYTES + " bytes");
        }
        try {
            return read(StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString(), file.toString());
        } catch (CharacterCodingException e) {
            throw new IOException(Quote.path(file) + ": must be UTF-8 text", e);
        }
    }

    /**
     * Reads a path from a text.
     *
     * @param name how complaints call it
     * @throws IOException as {@link #load}
     */
    public static MotionPath read(String text, String name) throws IOException {
        String file = Quote.path(name);
        List<MotionPath.Key> keys = new ArrayList<>();
        int every = MotionPath.DEFAULT_EVERY;
        boolean headed = false;
        int number = 0;
        int end;
        // A byte order mark, which some editors write, is passed over.
        for (int start = text.startsWith("\uFEFF") ? 1 : 0; start < text.length(); start = end + 1) {
            int newline = text.indexOf('\n', start);
            end = newline < 0 ? text.length() : newline;
            number++;
            String content = content(text, start, end);
            if (content.isEmpty()) {
                continue;
            }
            String place = file + ":" + number + ": ";
            String[] words = SPACE.split(content, WORDS + 1);
            if (!headed) {
                require(content.equals(HEAD), place, HEAD, content);
                headed = true;
            } else if (keys.isEmpty() && words[0].equals("every")) {
                require(words.length == 2, place, "every and a whole number", content);
                every = every(place, words[1]);
            } else {
                keys.add(key(place, words, content));
                require(keys.size() <= MotionPath.MAX_KEYS, place, "at most " + MotionPath.MAX_KEYS + " keys", "more");
            }
        }
        require(headed, file + ": ", HEAD, "nothing");
        require(!keys.isEmpty(), file + ": ", "at least one key, as in 'at 0 3 2  direction 0 -1 0'", "none");
        return new MotionPath(every, keys);
    }

    /** A line without its comment, its line end and the spaces around. */
    private static String content(String text, int start, int end) {
        int comment = text.indexOf('#', start, end);
        int to = comment < 0 ? end : comment;
        if (comment < 0 && end < text.length() && to > start && text.charAt(to - 1) == '\r') {
            to--;
        }
        int from = start;
        while (from < to && isSpace(text.charAt(from))) {
            from++;
        }
        while (to > from && isSpace(text.charAt(to - 1))) {
            to--;
        }
        return text.substring(from, to);
    }

    private static boolean isSpace(char c) {
        return c == ' ' || c == '\t';
    }

    private static int every(String place, String word) throws IOException {
        double value = number(place, word);
        require(value == Math.rint(value) && value >= 1 && value <= MotionPath.MAX_EVERY, place,
                "a whole number from 1 to " + MotionPath.MAX_EVERY, word);
        return (int) value;
    }

    private static MotionPath.Key key(String place, String[] words, String content) throws IOException {
        require(words.length == WORDS && words[0].equals("at") && words[4].equals("direction"), place,
                "at x y z direction x y z", content);
        try {
            return new MotionPath.Key(vector(place, words, 1), vector(place, words, 5));
        } catch (IllegalArgumentException e) {
            throw new IOException(place + e.getMessage(), e);
        }
    }

    private static Vec3 vector(String place, String[] words, int at) throws IOException {
        return new Vec3(number(place, words[at]), number(place, words[at + 1]), number(place, words[at + 2]));
    }

    private static double number(String place, String word) throws IOException {
        OptionalDouble number = Decimal.read(word);
        require(number.isPresent(), place, "a number", word);
        return number.getAsDouble();
    }

    private static void require(boolean right, String place, String expected, String found) throws IOException {
        if (!right) {
            throw new IOException(place + "expected " + expected + ", found " + Quote.of(found));
        }
    }

    private static String text(Vec3 v) {
        return Decimal.text(v.x()) + " " + Decimal.text(v.y()) + " " + Decimal.text(v.z());
    }
}
