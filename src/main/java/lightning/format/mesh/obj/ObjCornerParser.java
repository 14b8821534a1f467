package lightning.format.mesh.obj;

import java.util.HashSet;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.TextTokenizer;

/** Parser for face corners: indices of position, texture coordinates and normal. */
final class ObjCornerParser {
    static final String COORDINATES = "texture coordinates";
    static final String NORMALS = "normals";

    private final TextTokenizer text;
    private final ObjVertexData points;
    private final ConversionNotes notes;
    /** Attributes that corners referenced before the file defined any. */
    private final Set<String> missing = new HashSet<>();
    private int position;

    /**
     * Creates a parser.
     *
     * @param points vertex data read so far
     */
    ObjCornerParser(TextTokenizer text, ObjVertexData points, ConversionNotes notes) {
        this.text = text;
        this.points = points;
        this.notes = notes;
    }

    /**
     * Returns the vertex for the last token: {@code 3}, {@code 3/1}, {@code 3//2} or {@code 3/1/2}.
     *
     * @param smoothingGroup smoothing group, 0 for none
     */
    int readVertex(ObjMeshBuilder mesh, int smoothingGroup) throws MeshException {
        int start = 0;
        position = ObjMeshBuilder.NONE;
        int coordinate = ObjMeshBuilder.NONE;
        int normal = smoothingGroup == 0 ? ObjMeshBuilder.NONE : ObjMeshBuilder.smoothNormal(smoothingGroup);
        for (int index = 0; start <= text.length(); index++) {
            int end = start;
            while (end < text.length() && text.byteAt(end) != '/') {
                end++;
            }
            if (index > 2 || index == 0 && end == start) {
                throw text.badLine("a corner must be written as 3, 3/1, 3//2 or 3/1/2, was " + Quote.of(text.text()));
            }
            if (end > start) {
                switch (index) {
                    case 0 -> position = index(start, end, points.positionCount(), "vertices");
                    case 1 -> coordinate = optionalIndex(start, end, points.coordinateCount(), COORDINATES, coordinate);
                    default -> normal = optionalIndex(start, end, points.normalCount(), NORMALS, normal);
                }
            }
            start = end + 1;
        }
        return mesh.addVertex(position, coordinate, normal);
    }

    /** Returns the position of the last vertex read. */
    int position() {
        return position;
    }

    /** Returns an optional index; {@code fallback} if it is absent or the file has no such data. */
    private int optionalIndex(int from, int to, int count, String label, int fallback) throws MeshException {
        if (count > 0 || number(from, to) == 0) {
            return index(from, to, count, label);
        }
        missing.add(label);
        notes.add("indices of missing " + label);
        return fallback;
    }

    /** Rejects vertex data that earlier faces have already referenced. */
    void checkOrder(String label) throws MeshException {
        if (missing.contains(label)) {
            throw text.problem(label + " must precede the faces that use them");
        }
    }

    /** Converts an index counted from 1, or backward from −1, to one counted from 0. */
    private int index(int from, int to, int count, String label) throws MeshException {
        long v = number(from, to);
        if (v == 0 || Math.abs(v) > count) {
            throw text.badLine("a corner must reference one of " + count + " preceding " + label + ", was " + Quote.of(text.text()));
        }
        return (int) (v < 0 ? count + v : v - 1);
    }

    /** Parses an integer of up to eleven digits in a part of the token; 0 if it is empty. */
    private long number(int from, int to) {
        boolean negative = text.byteAt(from) == '-';
        int first = negative ? from + 1 : from;
        if (to == first || to - from >= 12) {
            return 0;
        }
        long v = 0;
        for (int i = first; i < to; i++) {
            if (text.byteAt(i) < '0' || text.byteAt(i) > '9') {
                return 0;
            }
            v = 10 * v + text.byteAt(i) - '0';
        }
        return negative ? -v : v;
    }
}
