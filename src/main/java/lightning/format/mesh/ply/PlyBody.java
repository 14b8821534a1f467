package lightning.format.mesh.ply;

import java.io.EOFException;
import java.io.IOException;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;
import lightning.format.mesh.TextSource;

/** The numbers behind the header, in either form. */
final class PlyBody {
    private final ByteSource source;
    /** Null where the numbers are binary. */
    private final TextSource text;
    private final Notes notes;
    /** What is being read, as messages call it. */
    private String element = "";
    private long number;
    /** Elements that were entered. */
    private long entered;
    /** Whether each element ends with its line. */
    private boolean byLines = true;

    /** @param notes hears of numbers that the header does not name */
    PlyBody(PlyHeader.Format format, TextSource text, ByteSource source, Notes notes) {
        this.source = source;
        this.notes = notes;
        this.text = format == PlyHeader.Format.ASCII ? text : null;
        source.order(format.order);
    }

    /** Says what follows. Passes over what is left of the element before it, where lines of text end elements. */
    void enter(String newElement, long newNumber) throws IOException {
        if (text != null && byLines && entered > 0 && !text.isAtLineEnd()) {
            if (entered == 1) {
                // The second element stands on the line of the first: the file is one stream of numbers.
                byLines = false;
            } else {
                notes.add("numbers at the ends of lines, which the header does not name");
                text.nextLine();
            }
        }
        entered++;
        element = newElement;
        number = newNumber;
    }

    /** The next number, as a double, which holds those of all types exactly. */
    double number(PlyType type) throws IOException, MeshException {
        return number(type, false);
    }

    /** The next number, or NaN where the file says so. */
    double numberOrNaN(PlyType type) throws IOException, MeshException {
        return number(type, true);
    }

    private double number(PlyType type, boolean orNaN) throws IOException, MeshException {
        try {
            return text == null ? type.read(source) : word(orNaN);
        } catch (EOFException e) {
            throw problem("the file ends before it does");
        }
    }

    /** The length of the list that follows, held against what is left of the file. */
    int length(PlyHeader.Property list) throws IOException, MeshException {
        double length = number(list.length());
        // In text each number has a digit and, but for the last, something behind it.
        double most = text == null ? source.left() / list.type().bytes : (source.left() + 1) / 2;
        if (!(length >= 0 && length <= most && length == Math.rint(length))) {
            throw problem(list.name() + " must have from 0 to " + (long) most + " numbers, as the file has bytes for, was " + length);
        }
        return (int) length;
    }

    /** A problem with what is being read. */
    MeshException problem(String message) {
        String place = element + " " + number;
        return text == null ? source.problem(place, message) : text.problem(place + ": " + message);
    }

    private double word(boolean orNaN) throws IOException, MeshException {
        while (!text.word()) {
            if (!text.nextLine()) {
                throw new EOFException();
            }
        }
        String what = "a number of " + element + " " + number;
        return orNaN ? text.numberOrNaN(what) : text.number(what);
    }
}
