package lightning.format.mesh.ply;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;
import lightning.format.mesh.TextSource;

/**
 * What the header of a PLY file says of the rest.
 *
 * @param elements in the order in which they follow
 */
record PlyHeader(Format format, List<Element> elements) {
    private static final int MOST_ELEMENTS = 100;
    private static final int MOST_PROPERTIES = 1000;

    enum Format {
        ASCII("ascii", ByteOrder.LITTLE_ENDIAN), LITTLE("binary_little_endian", ByteOrder.LITTLE_ENDIAN),
        BIG("binary_big_endian", ByteOrder.BIG_ENDIAN);

        final String word;
        final ByteOrder order;

        Format(String word, ByteOrder order) {
            this.word = word;
            this.order = order;
        }
    }

    /** @param count how many follow, at least 0 */
    record Element(String name, long count, List<Property> properties) {
        Optional<Property> property(String wanted) {
            return properties.stream().filter(p -> p.name.equals(wanted)).findFirst();
        }

        /** The fewest bytes that all of it can take in a file: in text each number has a digit and something behind it. */
        long leastBytes(Format format) {
            long each = 0;
            for (Property p : properties) {
                each += format == Format.ASCII ? 2 : (p.length == null ? p.type : p.length).bytes;
            }
            return Math.max(0, count * each - (format == Format.ASCII ? 1 : 0));
        }
    }

    /**
     * A number, or a list of them.
     *
     * @param length the type of a list's length; null for a number
     */
    record Property(String name, PlyType type, PlyType length) {
        boolean isList() {
            return length != null;
        }
    }

    /**
     * Reads a header to the end of its last line, and holds the counts against the bytes that follow.
     *
     * @param notes hears of lines before all elements that are none of a header's
     * @throws MeshException if it says what no PLY file says, or more than the file has bytes for
     */
    static PlyHeader read(TextSource text, ByteSource source, Notes notes) throws IOException, MeshException {
        if (!text.word() || !text.is("ply")) {
            throw text.problem("a PLY file must begin with the word ply");
        }
        Format format = null;
        List<Element> elements = new ArrayList<>();
        while (text.nextLine()) {
            if (!text.word() || text.is("comment") || text.is("obj_info")) {
                continue;
            }
            if (text.is("format")) {
                format = format(text);
            } else if (text.is("element")) {
                elements.add(element(text, elements));
            } else if (text.is("property")) {
                if (elements.isEmpty()) {
                    throw text.problem("a property must stand behind an element");
                }
                add(text, elements.getLast());
            } else if (text.is("end_header")) {
                if (format == null) {
                    throw text.problem("the header must say a format");
                }
                text.passLineEnd();
                return checked(new PlyHeader(format, List.copyOf(elements)), source);
            } else if (elements.isEmpty()) {
                // Some writers break their comments there.
                notes.add("lines of the header that are no comments");
            } else {
                throw text.problem("expected format, element, property, comment or end_header, found " + Quote.of(text.text()));
            }
        }
        throw text.problem("the header must end with end_header");
    }

    private static Format format(TextSource text) throws IOException, MeshException {
        String word = word(text, "a format");
        for (Format format : Format.values()) {
            if (format.word.equals(word)) {
                return format;
            }
        }
        throw text.problem("the format must be ascii, binary_little_endian or binary_big_endian, was " + Quote.of(word));
    }

    private static Element element(TextSource text, List<Element> before) throws IOException, MeshException {
        if (before.size() == MOST_ELEMENTS) {
            throw text.problem("a header must have at most " + MOST_ELEMENTS + " elements");
        }
        String name = word(text, "the name of an element");
        if (before.stream().anyMatch(e -> e.name.equals(name))) {
            throw text.problem("there is a second element " + Quote.of(name));
        }
        word(text, "the number of elements");
        return new Element(name, text.whole("the number of elements", 0, Integer.MAX_VALUE), new ArrayList<>());
    }

    private static void add(TextSource text, Element to) throws IOException, MeshException {
        if (to.properties.size() == MOST_PROPERTIES) {
            throw text.problem("an element must have at most " + MOST_PROPERTIES + " properties");
        }
        String first = word(text, "a type");
        boolean list = first.equals("list");
        PlyType length = list ? type(text, word(text, "the type of a list's length")) : null;
        if (list && !length.isWhole()) {
            throw text.problem("the length of a list must be of a whole type");
        }
        PlyType type = type(text, list ? word(text, "the type of a list's numbers") : first);
        String name = word(text, "the name of a property");
        if (to.property(name).isPresent()) {
            throw text.problem("there is a second property " + Quote.of(name));
        }
        to.properties.add(new Property(name, type, length));
    }

    private static PlyType type(TextSource text, String name) throws MeshException {
        return PlyType.of(name).orElseThrow(() -> text.problem(
                "a type must be char, uchar, short, ushort, int, uint, float, double or list, was " + Quote.of(name)));
    }

    private static String word(TextSource text, String expected) throws IOException, MeshException {
        if (!text.word()) {
            throw text.problem("expected " + expected + ", found the end of the line");
        }
        return text.text();
    }

    private static PlyHeader checked(PlyHeader header, ByteSource source) throws MeshException {
        long least = 0;
        for (Element element : header.elements) {
            long own = element.leastBytes(header.format);
            least += own;
            if (least > source.left()) {
                throw source.problem("element " + element.name, "the header says " + element.count + ", which are at least " + own
                        + " bytes, but only " + source.left() + " bytes follow it");
            }
        }
        return header;
    }
}
