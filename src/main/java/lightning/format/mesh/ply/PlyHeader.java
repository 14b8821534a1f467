package lightning.format.mesh.ply;

import java.io.IOException;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.TextTokenizer;

/**
 * What the header of a PLY file says of the rest.
 *
 * @param elements in the order in which they follow
 */
record PlyHeader(Format parseFormat, List<Element> elements) {
    private static final int MAX_ELEMENTS = 100;
    private static final int MAX_PROPERTIES = 1000;

    enum Format {
        ASCII("ascii", ByteOrder.LITTLE_ENDIAN), BINARY_LITTLE_ENDIAN("binary_little_endian", ByteOrder.LITTLE_ENDIAN),
        BINARY_BIG_ENDIAN("binary_big_endian", ByteOrder.BIG_ENDIAN);

        final String keyword;
        final ByteOrder order;

        Format(String keyword, ByteOrder order) {
            this.keyword = keyword;
            this.order = order;
        }
    }

    /** @param count how many follow, at least 0 */
    record Element(String name, long count, List<Property> properties) {
        Optional<Property> property(String propertyName) {
            return properties.stream().filter(p -> p.name.equals(propertyName)).findFirst();
        }

        /** The fewest bytes that all of it can take in a file: in text each number has a digit and something behind it. */
        long minBytes(Format format) {
            long bytesPerElement = 0;
            for (Property p : properties) {
                bytesPerElement += format == Format.ASCII ? 2 : (p.lengthType == null ? p.type : p.lengthType).bytes;
            }
            return Math.max(0, count * bytesPerElement - (format == Format.ASCII ? 1 : 0));
        }
    }

    /**
     * A number, or a list of them.
     *
     * @param lengthType the type of a list's length; null for a number
     */
    record Property(String name, PlyType type, PlyType lengthType) {
        boolean isList() {
            return lengthType != null;
        }
    }

    /**
     * Reads a header to the end of its last line, and holds the counts against the bytes that follow.
     *
     * @param notes hears of lines before all elements that are none of a header's
     * @throws MeshException if it says what no PLY file says, or more than the file has bytes for
     */
    static PlyHeader read(TextTokenizer text, ByteSource source, ConversionNotes notes) throws IOException, MeshException {
        if (!text.readToken() || !text.isToken("ply")) {
            throw text.problem("a PLY file must begin with the word ply");
        }
        Format format = null;
        List<Element> elements = new ArrayList<>();
        while (text.nextLine()) {
            if (!text.readToken() || text.isToken("comment") || text.isToken("obj_info")) {
                continue;
            }
            if (text.isToken("format")) {
                format = parseFormat(text);
            } else if (text.isToken("element")) {
                elements.add(parseElement(text, elements));
            } else if (text.isToken("property")) {
                if (elements.isEmpty()) {
                    throw text.problem("a property must stand behind an element");
                }
                addProperty(text, elements.getLast());
            } else if (text.isToken("end_header")) {
                if (format == null) {
                    throw text.problem("the header must say a format");
                }
                text.skipLineEnd();
                return checkSize(new PlyHeader(format, List.copyOf(elements)), source);
            } else if (elements.isEmpty()) {
                // Some writers break their comments there.
                notes.add("lines of the header that are no comments");
            } else {
                throw text.problem("expected format, element, property, comment or end_header, found " + Quote.of(text.text()));
            }
        }
        throw text.problem("the header must end with end_header");
    }

    private static Format parseFormat(TextTokenizer text) throws IOException, MeshException {
        String token = nextToken(text, "a format");
        for (Format format : Format.values()) {
            if (format.keyword.equals(token)) {
                return format;
            }
        }
        throw text.problem("the format must be ascii, binary_little_endian or binary_big_endian, was " + Quote.of(token));
    }

    private static Element parseElement(TextTokenizer text, List<Element> previous) throws IOException, MeshException {
        if (previous.size() == MAX_ELEMENTS) {
            throw text.problem("a header must have at most " + MAX_ELEMENTS + " elements");
        }
        String name = nextToken(text, "the name of an element");
        if (previous.stream().anyMatch(e -> e.name.equals(name))) {
            throw text.problem("there is a second element " + Quote.of(name));
        }
        nextToken(text, "the number of elements");
        return new Element(name, text.integer("the number of elements", 0, Integer.MAX_VALUE), new ArrayList<>());
    }

    private static void addProperty(TextTokenizer text, Element element) throws IOException, MeshException {
        if (element.properties.size() == MAX_PROPERTIES) {
            throw text.problem("an element must have at most " + MAX_PROPERTIES + " properties");
        }
        String first = nextToken(text, "a type");
        boolean list = first.equals("list");
        PlyType length = list ? parseType(text, nextToken(text, "the type of a list's length")) : null;
        if (list && !length.isInteger()) {
            throw text.problem("the length of a list must be of a whole type");
        }
        PlyType type = parseType(text, list ? nextToken(text, "the type of a list's numbers") : first);
        String name = nextToken(text, "the name of a property");
        if (element.property(name).isPresent()) {
            throw text.problem("there is a second property " + Quote.of(name));
        }
        element.properties.add(new Property(name, type, length));
    }

    private static PlyType parseType(TextTokenizer text, String name) throws MeshException {
        return PlyType.of(name).orElseThrow(() -> text.problem(
                "a type must be char, uchar, short, ushort, int, uint, float, double or list, was " + Quote.of(name)));
    }

    private static String nextToken(TextTokenizer text, String expected) throws IOException, MeshException {
        if (!text.readToken()) {
            throw text.problem("expected " + expected + ", found the end of the line");
        }
        return text.text();
    }

    private static PlyHeader checkSize(PlyHeader header, ByteSource source) throws MeshException {
        long minBytes = 0;
        for (Element element : header.elements) {
            long elementBytes = element.minBytes(header.parseFormat);
            minBytes += elementBytes;
            if (minBytes > source.remaining()) {
                throw source.problem("element " + element.name, "the header says " + element.count + ", which are at least " + elementBytes
                        + " bytes, but only " + source.remaining() + " bytes follow it");
            }
        }
        return header;
    }
}
