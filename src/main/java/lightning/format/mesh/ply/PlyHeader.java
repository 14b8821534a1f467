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
import org.jspecify.annotations.Nullable;

/**
 * Header of a PLY file.
 *
 * @param elements in file order
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

    /**
     * Element declaration.
     *
     * @param count number of instances, at least 0
     */
    record Element(String name, long count, List<Property> properties) {
        Optional<Property> property(String propertyName) {
            return properties.stream().filter(p -> p.name.equals(propertyName)).findFirst();
        }

        /** Returns the minimum file size of all instances in bytes: in text each number has a digit and a separator. */
        long minBytes(Format format) {
            long bytesPerElement = 0;
            for (Property p : properties) {
                bytesPerElement += format == Format.ASCII ? 2 : (p.lengthType == null ? p.type : p.lengthType).bytes;
            }
            return Math.max(0, count * bytesPerElement - (format == Format.ASCII ? 1 : 0));
        }
    }

    /**
     * Property declaration: a number or a list.
     *
     * @param lengthType type of a list's length; null for a number
     */
    record Property(String name, PlyType type, @Nullable PlyType lengthType) {
        boolean isList() {
            return lengthType != null;
        }
    }

    /**
     * Reads a header through its last line, and checks the counts against the remaining bytes.
     *
     * @param notes receives invalid lines before the first element
     * @throws MeshException if it is invalid, or declares more than the file can contain
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
                    throw text.problem("a property must follow an element");
                }
                addProperty(text, elements.getLast());
            } else if (text.isToken("end_header")) {
                if (format == null) {
                    throw text.problem("the header must have a format");
                }
                text.skipLineEnd();
                return checkSize(new PlyHeader(format, List.copyOf(elements)), source);
            } else if (elements.isEmpty()) {
                // Some writers wrap their comments.
                notes.add("unknown header lines");
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
            throw text.problem("duplicate element " + Quote.of(name));
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
        if (length != null && !length.isInteger()) {
            throw text.problem("a list's length must have an integer type");
        }
        PlyType type = parseType(text, list ? nextToken(text, "the type of a list's numbers") : first);
        String name = nextToken(text, "the name of a property");
        if (element.property(name).isPresent()) {
            throw text.problem("duplicate property " + Quote.of(name));
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
                throw source.problem("element " + element.name, "the header declares " + element.count + ", at least " + elementBytes
                        + " bytes, but only " + source.remaining() + " bytes follow");
            }
        }
        return header;
    }
}
