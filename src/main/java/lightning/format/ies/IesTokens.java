package lightning.format.ies;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;

/** Tokens after the {@code TILT=} line of a file, separated by spaces, commas and line ends, with their line numbers. */
final class IesTokens {
    private static final Pattern TILT = Pattern.compile("TILT\\s*=\\s*(.*)", Pattern.CASE_INSENSITIVE);
    /** End-of-file character that some programs append. */
    private static final String END_OF_FILE = "\u001a";

    private final Path file;
    private final String tilt;
    private final List<String> tokens = new ArrayList<>();
    private final List<Integer> lineNumbers = new ArrayList<>();
    private int next;

    IesTokens(Path file, byte[] bytes) throws MeshException {
        this.file = file;
        String[] fileLines = new String(bytes, StandardCharsets.ISO_8859_1).split("\r\n|\r|\n", -1);
        int start = 0;
        while (start < fileLines.length && !TILT.matcher(fileLines[start].strip()).matches()) {
            start++;
        }
        if (start == fileLines.length) {
            throw new MeshException(file, "", "an IES file must have a line that begins with TILT=, found none");
        }
        tilt = TILT.matcher(fileLines[start].strip()).replaceFirst("$1").strip();
        for (int i = start + 1; i < fileLines.length; i++) {
            for (String token : fileLines[i].split("[ \t,]+")) {
                if (!token.isEmpty() && !token.equals(END_OF_FILE)) {
                    tokens.add(token);
                    lineNumbers.add(i + 1);
                }
            }
        }
    }

    /** Returns the value of {@code TILT=}. */
    String tilt() {
        return tilt;
    }

    /**
     * Requires a number of remaining tokens. Others may follow: some programs write text at the end.
     *
     * @throws MeshException if fewer remain
     */
    void requireRemaining(long count) throws MeshException {
        if (tokens.size() - next < count) {
            throw problem("expected " + count + " angles and intensities, found " + (tokens.size() - next));
        }
    }

    /**
     * Reads an integer.
     *
     * @throws MeshException if the next token is not an integer in the range
     */
    int integer(String label, int min, int max) throws MeshException {
        double v = number(label, min, max);
        if (v != Math.rint(v)) {
            throw problem(label + " must be a whole number, was " + DecimalNumber.format(v));
        }
        return (int) v;
    }

    /**
     * Reads a number.
     *
     * @throws MeshException if the next token is not a number in the range
     */
    double number(String label, double min, double max) throws MeshException {
        if (next == tokens.size()) {
            throw problem("expected the " + label + ", found the end of the file");
        }
        String token = tokens.get(next++);
        OptionalDouble v = DecimalNumber.parse(token);
        if (v.isEmpty() || !(v.getAsDouble() >= min && v.getAsDouble() <= max)) {
            throw problem(label + " must be a number from " + DecimalNumber.format(min) + " to " + DecimalNumber.format(max) + ", was "
                    + Quote.of(token));
        }
        return v.getAsDouble();
    }

    /** Returns a problem at the line of the last token read. */
    MeshException problem(String message) {
        return new MeshException(file, next == 0 ? "" : "line " + lineNumbers.get(next - 1), message);
    }
}
