package lightning.format.ies;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;

/** The words behind the line {@code TILT=} of a file, between spaces, commas and ends of lines, with the line of each. */
final class IesWords {
    private static final String TILT = "TILT=";
    /** Some programs end a file with it. */
    private static final String END = "\u001a";

    private final Path file;
    private final String tilt;
    private final List<String> words = new ArrayList<>();
    private final List<Integer> lines = new ArrayList<>();
    private int next;

    IesWords(Path file, byte[] bytes) throws MeshException {
        this.file = file;
        String[] all = new String(bytes, StandardCharsets.ISO_8859_1).split("\r\n|\r|\n", -1);
        int start = 0;
        while (start < all.length && !all[start].strip().toUpperCase(Locale.ROOT).startsWith(TILT)) {
            start++;
        }
        if (start == all.length) {
            throw new MeshException(file, "", "a file of intensities must have a line that begins with " + TILT + ", found none");
        }
        tilt = all[start].strip().substring(TILT.length()).strip();
        for (int i = start + 1; i < all.length; i++) {
            for (String word : all[i].split("[ \t,]+")) {
                if (!word.isEmpty() && !word.equals(END)) {
                    words.add(word);
                    lines.add(i + 1);
                }
            }
        }
    }

    /** What stands behind {@code TILT=}. */
    String tilt() {
        return tilt;
    }

    /** @throws MeshException if another number of words is left */
    void expect(long count) throws MeshException {
        if (words.size() - next != count) {
            throw problem("expected " + count + " angles and intensities, found " + (words.size() - next));
        }
    }

    /** @throws MeshException if the next word is no whole number in the range */
    int whole(String what, int min, int max) throws MeshException {
        double v = number(what, min, max);
        if (v != Math.rint(v)) {
            throw problem(what + " must be a whole number, was " + Decimal.text(v));
        }
        return (int) v;
    }

    /** @throws MeshException if the next word is no number in the range */
    double number(String what, double min, double max) throws MeshException {
        if (next == words.size()) {
            throw problem("expected the " + what + ", found the end of the file");
        }
        String word = words.get(next++);
        OptionalDouble v = Decimal.read(word);
        if (v.isEmpty() || !(v.getAsDouble() >= min && v.getAsDouble() <= max)) {
            throw problem(what + " must be a number from " + Decimal.text(min) + " to " + Decimal.text(max) + ", was " + Quote.of(word));
        }
        return v.getAsDouble();
    }

    /** A problem with the line of the word that was read last. */
    MeshException problem(String message) {
        return new MeshException(file, next == 0 ? "" : "line " + lines.get(next - 1), message);
    }
}
