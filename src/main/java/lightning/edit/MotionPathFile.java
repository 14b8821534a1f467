package lightning.edit;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.file.SafeFile;
import lightning.math.Vec3;

/** Motion paths as text; the format is described in {@code docs/motion-path.md}. */
public final class MotionPathFile {
    private static final String HEAD = "lightning-path 1";
    private static final long MAX_BYTES = 32L << 20;
    private static final int WORDS = 8;

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
        if (Files.size(file) > MAX_BYTES) {
            throw new IOException(file + ": a motion path may have at most " + MAX_BYTES + " bytes");
        }
        try {
            return read(Files.readString(file), file.toString());
        } catch (CharacterCodingException e) {
            throw new IOException(file + ": must be UTF-8 text", e);
        }
    }

    /**
     * Reads a path from a text.
     *
     * @param name how complaints call it
     * @throws IOException as {@link #load}
     */
    public static MotionPath read(String text, String name) throws IOException {
        var reader = new BufferedReader(new StringReader(text));
        List<MotionPath.Key> keys = new ArrayList<>();
        int every = MotionPath.DEFAULT_EVERY;
        boolean headed = false;
        int number = 0;
        for (String line = reader.readLine(); line != null; line = reader.readLine()) {
            number++;
            String content = line.replaceFirst("#.*", "").strip();
            if (content.isEmpty()) {
                continue;
            }
            String place = name + ":" + number + ": ";
            String[] words = content.split("\\s+");
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
        require(headed, name + ": ", HEAD, "nothing");
        require(!keys.isEmpty(), name + ": ", "at least one key, as in 'at 0 3 2  direction 0 -1 0'", "none");
        return new MotionPath(every, keys);
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
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            throw new IOException(place + "expected a number, found '" + word + "'", e);
        }
    }

    private static void require(boolean right, String place, String expected, String found) throws IOException {
        if (!right) {
            throw new IOException(place + "expected " + expected + ", found '" + found + "'");
        }
    }

    private static String text(Vec3 v) {
        return number(v.x()) + " " + number(v.y()) + " " + number(v.z());
    }

    private static String number(double v) {
        return v == Math.rint(v) && Math.abs(v) < 1e7 && (v != 0 || 1 / v > 0) ? Long.toString((long) v) : Double.toString(v);
    }
}
