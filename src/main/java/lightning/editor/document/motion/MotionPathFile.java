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
import java.util.stream.Collectors;
import lightning.base.file.OrdinaryFile;
import lightning.base.file.SafeFile;
import lightning.base.math.Vec3;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.shot.Key;
import lightning.scene.shot.Setting;

/** Recorded shots as text; the format is described in {@code docs/motion-path.md}. */
public final class MotionPathFile {
    private static final String HEAD = "lightning-path 1";
    private static final int MAX_BYTES = 32 << 20;
    private static final int WORDS = 8;
    private static final Pattern SPACE = Pattern.compile("[ \\t]+");

    private MotionPathFile() {}

    /** Returns the text, which reads back as an equal shot of the same light. */
    public static String write(RecordedShot recorded) {
        StringBuilder text = new StringBuilder(HEAD).append("\nevery ").append(recorded.every()).append('\n');
        List<Key> positions = recorded.shot().tracks().getFirst().keys();
        List<Key> directions = recorded.shot().tracks().getLast().keys();
        for (int i = 0; i < recorded.keys(); i++) {
            text.append("at ").append(text(positions.get(i))).append("  direction ").append(text(directions.get(i))).append('\n');
        }
        return text.toString();
    }

    /** Writes a file completely or not at all. */
    public static void save(RecordedShot recorded, Path file) throws IOException {
        SafeFile.write(file, out -> out.write(write(recorded).getBytes(StandardCharsets.UTF_8)));
    }

    /**
     * Reads a file.
     *
     * @param light the name of the light that shall move; the file names none
     * @throws IOException if it cannot be read or is no motion path: {@code file:line: what was expected and found}
     */
    public static RecordedShot load(Path file, String light) throws IOException {
        byte[] bytes;
        try (InputStream in = OrdinaryFile.open(file, "a motion path")) {
            bytes = in.readNBytes(MAX_BYTES + 1);
        }
        if (bytes.length > MAX_BYTES) {
            throw new IOException(Quote.path(file) + ": a motion path may have at most " + MAX_BYTES + " bytes");
        }
        try {
            return read(StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString(), file.toString(), light);
        } catch (CharacterCodingException e) {
            throw new IOException(Quote.path(file) + ": must be UTF-8 text", e);
        }
    }

    /**
     * Reads a text.
     *
     * @param name  the file's name in error messages
     * @param light as in {@link #load}
     * @throws IOException as {@link #load}
     */
    public static RecordedShot read(String text, String name, String light) throws IOException {
        String file = Quote.path(name);
        List<Light> samples = new ArrayList<>();
        int every = RecordedShot.DEFAULT_EVERY;
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
            } else if (samples.isEmpty() && words[0].equals("every")) {
                require(words.length == 2, place, "every and a whole number", content);
                every = every(place, words[1]);
            } else {
                samples.add(sample(light, place, words, content));
                require(samples.size() <= RecordedShot.MAX_KEYS, place, "at most " + RecordedShot.MAX_KEYS + " keys", "more");
            }
        }
        require(headed, file + ": ", HEAD, "nothing");
        require(!samples.isEmpty(), file + ": ", "at least one key, as in 'at 0 3 2  direction 0 -1 0'", "none");
        return RecordedShot.of(every, samples);
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
        require(value == Math.rint(value) && value >= 1 && value <= RecordedShot.MAX_EVERY, place,
                "a whole number from 1 to " + RecordedShot.MAX_EVERY, word);
        return (int) value;
    }

    private static Light sample(String light, String place, String[] words, String content) throws IOException {
        require(words.length == WORDS && words[0].equals("at") && words[4].equals("direction"), place,
                "at x y z direction x y z", content);
        try {
            return Light.of(light, LightType.SPOT).withPosition(vector(place, words, 1)).withDirection(vector(place, words, 5));
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

    private static String text(Key key) {
        return ((Setting.Numbers) key.setting()).all().stream().map(Decimal::text).collect(Collectors.joining(" "));
    }
}
