package lightning.format.mesh.ply;

import java.io.EOFException;
import java.io.IOException;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.TextTokenizer;

/** The numbers behind the header, in either form. */
final class PlyBodyReader {
    private final ByteSource source;
    /** Null where the numbers are binary. */
    private final TextTokenizer text;
    private final ConversionNotes notes;
    /** What is being read, as messages call it. */
    private String element = "";
    private long elementIndex;
    /** Elements that were entered. */
    private long startedElements;
    /** Whether each element ends with its line. */
    private boolean oneElementPerLine = true;

    /** @param notes hears of numbers that the header does not name */
    PlyBodyReader(PlyHeader.Format format, TextTokenizer text, ByteSource source, ConversionNotes notes) {
        this.source = source;
        this.notes = notes;
        this.text = format == PlyHeader.Format.ASCII ? text : null;
        source.setByteOrder(format.order);
    }

    /** Says what follows. Passes over what is left of the element before it, where lines of text end elements. */
    void startElement(String newElement, long newIndex) throws IOException {
        if (text != null && oneElementPerLine && startedElements > 0 && !text.isAtLineEnd()) {
            if (startedElements == 1) {
                // The second element stands on the line of the first: the file is one stream of numbers.
                oneElementPerLine = false;
            } else {
                notes.add("numbers at the ends of lines, which the header does not name");
                text.nextLine();
            }
        }
        startedElements++;
        element = newElement;
        elementIndex = newIndex;
    }

    /** The next number, as a double, which holds those of all types exactly. */
    double number(PlyType type) throws IOException, MeshException {
        return number(type, false);
    }

    /** The next number, or NaN where the file says so. */
    double numberOrNaN(PlyType type) throws IOException, MeshException {
        return number(type, true);
    }

    private double number(PlyType type, boolean allowNaN) throws IOException, MeshException {
        try {
            return text == null ? type.read(source) : nextNumber(allowNaN);
        } catch (EOFException e) {
            throw problem("the file ends before it does");
        }
    }

    /** The length of the list that follows, held against what is left of the file. */
    int listLength(PlyHeader.Property list) throws IOException, MeshException {
        double length = number(list.lengthType());
        // In text each number has a digit and, but for the last, something behind it.
        double max = text == null ? source.remaining() / list.type().bytes : (source.remaining() + 1) / 2;
        if (!(length >= 0 && length <= max && length == Math.rint(length))) {
            throw problem(list.name() + " must have from 0 to " + (long) max + " numbers, as the file has bytes for, was " + length);
        }
        return (int) length;
    }

    /** A problem with what is being read. */
    MeshException problem(String message) {
        String location = element + " " + elementIndex;
        return text == null ? source.problem(location, message) : text.problem(location + ": " + message);
    }

    private double nextNumber(boolean allowNaN) throws IOException, MeshException {
        while (!text.readToken()) {
            if (!text.nextLine()) {
                throw new EOFException();
            }
        }
        String label = "a number of " + element + " " + elementIndex;
        return allowNaN ? text.numberOrNaN(label) : text.number(label);
    }
}
