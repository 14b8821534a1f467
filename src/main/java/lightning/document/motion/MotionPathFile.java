package lightning.document.motion;

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
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;

/** Text format of recorded shots, described in {@code docs/motion-path.md}. */
public final class MotionPathFile {
    private static final String HEADER = "lightning-path 1";
    private static final int MAX_BYTES = 32 << 20;
    private static final int WORDS_PER_KEY = 8;
    private static final Pattern SPACE = Pattern.compile("[ \\t]+");

    private MotionPathFile() {}

    /** Returns the text, which reads back as an equal shot of the same light. */
    public static String write(RecordedShot recorded) {
        StringBuilder text = new StringBuilder(HEADER).append("\nevery ").append(recorded.interval()).append('\n');
        List<Keyframe> positions = recorded.shot().tracks().getFirst().keys();
        List<Keyframe> directions = recorded.shot().tracks().getLast().keys();
        for (int i = 0; i < recorded.keyCount(); i++) {
            text.append("at ").append(text(positions.get(i))).append("  direction ").append(text(directions.get(i))).append('\n');
        }
        return text.toString();
    }

    /** Writes a file atomically. */
    public static void save(RecordedShot recorded, Path file) throws IOException {
        AtomicFile.write(file, out -> out.write(write(recorded).getBytes(StandardCharsets.UTF_8)));
    }

    /**
     * Reads a file.
     *
     * @param light name of the moving light; the file has no names
     * @throws IOException if it cannot be read or is not a motion path: {@code file:line: expected X, found Y}
     */
    public static RecordedShot load(Path file, String light) throws IOException {
        byte[] bytes;
        try (InputStream in = RegularFile.open(file, "a motion path")) {
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
     * @param name  file name for error messages
     * @param light as in {@link #load}
     * @throws IOException as {@link #load}
     */
    public static RecordedShot read(String text, String name, String light) throws IOException {
        String file = Quote.path(name);
        List<Light> samples = new ArrayList<>();
        int interval = RecordedShot.DEFAULT_INTERVAL;
        boolean hasHeader = false;
        int number = 0;
        int end;
        // Skips a byte order mark, which some editors write.
        for (int start = text.startsWith("\uFEFF") ? 1 : 0; start < text.length(); start = end + 1) {
            int newline = text.indexOf('\n', start);
            end = newline < 0 ? text.length() : newline;
            number++;
            String content = content(text, start, end);
            if (content.isEmpty()) {
                continue;
            }
            String location = file + ":" + number + ": ";
            String[] words = SPACE.split(content, WORDS_PER_KEY + 1);
            if (!hasHeader) {
                require(content.equals(HEADER), location, HEADER, content);
                hasHeader = true;
            } else if (samples.isEmpty() && words[0].equals("every")) {
                require(words.length == 2, location, "every and a whole number", content);
                interval = parseInterval(location, words[1]);
            } else {
                samples.add(parseSample(light, location, words, content));
                require(samples.size() <= RecordedShot.MAX_KEYS, location, "at most " + RecordedShot.MAX_KEYS + " keys", "more");
            }
        }
        require(hasHeader, file + ": ", HEADER, "nothing");
        require(!samples.isEmpty(), file + ": ", "at least one key, as in 'at 0 3 2  direction 0 -1 0'", "none");
        return RecordedShot.of(interval, samples);
    }

    /** Returns a line without its comment, its end and surrounding spaces. */
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

    private static int parseInterval(String location, String word) throws IOException {
        double value = parseNumber(location, word);
        require(value == Math.rint(value) && value >= 1 && value <= RecordedShot.MAX_INTERVAL, location,
                "a whole number from 1 to " + RecordedShot.MAX_INTERVAL, word);
        return (int) value;
    }

    private static Light parseSample(String light, String location, String[] words, String content) throws IOException {
        require(words.length == WORDS_PER_KEY && words[0].equals("at") && words[4].equals("direction"), location,
                "at x y z direction x y z", content);
        try {
            return Light.of(light, LightType.SPOT).withPosition(parseVector(location, words, 1))
                    .withDirection(parseVector(location, words, 5));
        } catch (RefusalException e) {
            throw new IOException(location + e.getMessage(), e);
        }
    }

    private static Vec3 parseVector(String location, String[] words, int at) throws IOException {
        return new Vec3(parseNumber(location, words[at]), parseNumber(location, words[at + 1]), parseNumber(location, words[at + 2]));
    }

    private static double parseNumber(String location, String word) throws IOException {
        OptionalDouble number = DecimalNumber.parse(word);
        require(number.isPresent(), location, "a number", word);
        return number.getAsDouble();
    }

    private static void require(boolean condition, String location, String expected, String found) throws IOException {
        if (!condition) {
            throw new IOException(location + "expected " + expected + ", found " + Quote.of(found));
        }
    }

    private static String text(Keyframe key) {
        return ((KeyframeValue.Numbers) key.value()).values().stream().map(DecimalNumber::format).collect(Collectors.joining(" "));
    }
}
