package lightning.format.mesh.ply;

import static java.util.Objects.requireNonNull;

import java.io.EOFException;
import java.io.IOException;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.TextTokenizer;
import org.jspecify.annotations.Nullable;

/** Reader for the data after the header, in text or binary form. */
final class PlyBodyReader {
    private final ByteSource source;
    /** Tokenizer; null for binary data. */
    private final @Nullable TextTokenizer text;
    private final ConversionNotes notes;
    /** Name of the current element, for messages. */
    private String element = "";
    private long elementIndex;
    /** Number of elements started. */
    private long startedElements;
    /** True if each element ends with its line. */
    private boolean oneElementPerLine = true;

    /**
     * Creates a reader.
     *
     * @param notes receives extra numbers that the header does not declare
     */
    PlyBodyReader(PlyHeader.Format format, TextTokenizer text, ByteSource source, ConversionNotes notes) {
        this.source = source;
        this.notes = notes;
        this.text = format == PlyHeader.Format.ASCII ? text : null;
        source.setByteOrder(format.order);
    }

    /** Starts an element; skips the rest of the previous line if elements end with their lines. */
    void startElement(String newElement, long newIndex) throws IOException {
        if (text != null && oneElementPerLine && startedElements > 0 && !text.isAtLineEnd()) {
            if (startedElements == 1) {
                // The second element is on the first one's line: the file is one stream of numbers.
                oneElementPerLine = false;
            } else {
                notes.add("extra numbers at line ends, not declared in the header");
                text.nextLine();
            }
        }
        startedElements++;
        element = newElement;
        elementIndex = newIndex;
    }

    /** Reads a number as a double, which represents all types exactly. */
    double number(PlyType type) throws IOException, MeshException {
        return number(type, false);
    }

    /** Reads a number, or NaN if the file contains it. */
    double numberOrNaN(PlyType type) throws IOException, MeshException {
        return number(type, true);
    }

    private double number(PlyType type, boolean allowNaN) throws IOException, MeshException {
        try {
            return text == null ? type.read(source) : nextNumber(allowNaN);
        } catch (EOFException e) {
            throw problem("unexpected end of file");
        }
    }

    /** Reads the length of a list, limited by the file's remaining bytes. */
    int listLength(PlyHeader.Property list) throws IOException, MeshException {
        double length = number(requireNonNull(list.lengthType()));
        // In text each number has a digit and, except for the last, a separator.
        double max = text == null ? source.remaining() / list.type().bytes : (source.remaining() + 1) / 2;
        if (!(length >= 0 && length <= max && length == Math.rint(length))) {
            throw problem(list.name() + " must have from 0 to " + (long) max + " numbers by the file's size, was " + length);
        }
        return (int) length;
    }

    /** Creates a problem with the current element. */
    MeshException problem(String message) {
        String location = element + " " + elementIndex;
        return text == null ? source.problem(location, message) : text.problem(location + ": " + message);
    }

    private double nextNumber(boolean allowNaN) throws IOException, MeshException {
        assert text != null;
        while (!text.readToken()) {
            if (!text.nextLine()) {
                throw new EOFException();
            }
        }
        String label = "a number of " + element + " " + elementIndex;
        return allowNaN ? text.numberOrNaN(label) : text.number(label);
    }
}
