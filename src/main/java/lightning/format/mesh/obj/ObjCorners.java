package lightning.format.mesh.obj;

import java.util.HashSet;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.Notes;
import lightning.format.mesh.TextSource;

/** Reads the corners of faces: which position, texture coordinates and normal each names. */
final class ObjCorners {
    static final String COORDINATES = "texture coordinates";
    static final String NORMALS = "normals";

    private final TextSource text;
    private final ObjPoints points;
    private final Notes notes;
    /** Texture coordinates or normals that corners named before the file had any. */
    private final Set<String> missing = new HashSet<>();
    private int position;

    /** @param points those read so far */
    ObjCorners(TextSource text, ObjPoints points, Notes notes) {
        this.text = text;
        this.points = points;
        this.notes = notes;
    }

    /**
     * The vertex that the last word names: {@code 3}, {@code 3/1}, {@code 3//2} or {@code 3/1/2}.
     *
     * @param smooth the smoothing group, 0 for none
     */
    int vertex(ObjMesh mesh, int smooth) throws MeshException {
        int at = 0;
        position = ObjMesh.NONE;
        int coordinate = ObjMesh.NONE;
        int normal = smooth == 0 ? ObjMesh.NONE : ObjMesh.smoothNormal(smooth);
        for (int part = 0; at <= text.length(); part++) {
            int end = at;
            while (end < text.length() && text.at(end) != '/') {
                end++;
            }
            if (part > 2 || part == 0 && end == at) {
                throw text.problem("a corner must be as 3, 3/1, 3//2 or 3/1/2, was " + Quote.of(text.text()));
            }
            if (end > at) {
                switch (part) {
                    case 0 -> position = index(at, end, points.positionCount(), "vertices");
                    case 1 -> coordinate = optionalIndex(at, end, points.coordinateCount(), COORDINATES, coordinate);
                    default -> normal = optionalIndex(at, end, points.normalCount(), NORMALS, normal);
                }
            }
            at = end + 1;
        }
        return mesh.vertex(position, coordinate, normal);
    }

    /** The position of the vertex that was read last. */
    int position() {
        return position;
    }

    /** The index of something that a corner can do without, as it must where the file has none: then {@code without}. */
    private int optionalIndex(int from, int to, int count, String what, int without) throws MeshException {
        if (count > 0 || number(from, to) == 0) {
            return index(from, to, count, what);
        }
        missing.add(what);
        notes.add("indices of " + what + ", of which the file has none");
        return without;
    }

    /** Refuses texture coordinates or normals that faces before them would have named. */
    void checkOrder(String what) throws MeshException {
        if (missing.contains(what)) {
            throw text.problem(what + " must stand before the faces that name them");
        }
    }

    /** An index that the file counts from 1, or from the last backwards with −1; counted from 0 here. */
    private int index(int from, int to, int count, String what) throws MeshException {
        long v = number(from, to);
        if (v == 0 || Math.abs(v) > count) {
            throw text.problem("a corner must name one of " + count + " " + what + " before it, was " + Quote.of(text.text()));
        }
        return (int) (v < 0 ? count + v : v - 1);
    }

    /** The whole number of up to eleven digits in a part of the word; 0 where there is none. */
    private long number(int from, int to) {
        boolean negative = text.at(from) == '-';
        int first = negative ? from + 1 : from;
        if (to == first || to - from >= 12) {
            return 0;
        }
        long v = 0;
        for (int i = first; i < to; i++) {
            if (text.at(i) < '0' || text.at(i) > '9') {
                return 0;
            }
            v = 10 * v + text.at(i) - '0';
        }
        return negative ? -v : v;
    }
}
