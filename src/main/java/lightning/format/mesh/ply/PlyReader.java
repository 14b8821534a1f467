package lightning.format.mesh.ply;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.IntList;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.PolygonTriangulator;
import lightning.format.mesh.TextTokenizer;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Reader for PLY files: vertices with positions, normals, texture coordinates and colors; polygonal faces; triangle strips.
 * Skips and notes all other content.
 */
public final class PlyReader {
    private static final byte[] MAGIC = "ply".getBytes(StandardCharsets.US_ASCII);
    /** Restart marker in triangle strips. */
    private static final int RESTART = -1;

    private final ByteSource source;
    private final ConversionNotes notes;
    private final IntList triangles = new IntList();
    private final PolygonTriangulator polygon = new PolygonTriangulator();
    private final IntList corners = new IntList();
    private final IntList faceTriangles = new IntList();
    private final PlyBodyReader body;
    private @Nullable PlyVertices vertices;

    private PlyReader(ByteSource source, ConversionNotes notes, PlyBodyReader body) {
        this.source = source;
        this.notes = notes;
        this.body = body;
    }

    /** Returns whether a file has the PLY signature. */
    public static boolean isPly(ByteSource source) throws IOException {
        return source.startsWith(MAGIC);
    }

    /**
     * Reads a whole file.
     *
     * @param notes receives omitted features
     * @throws MeshException if it is invalid, declares more than it contains, or has no triangle
     * @throws IOException if it cannot be read
     */
    public static Mesh read(ByteSource source, ConversionNotes notes) throws IOException, MeshException {
        var text = new TextTokenizer(source);
        PlyHeader header = PlyHeader.read(text, source, notes);
        return new PlyReader(source, notes, new PlyBodyReader(header.parseFormat(), text, source, notes)).read(header);
    }

    private Mesh read(PlyHeader header) throws IOException, MeshException {
        for (PlyHeader.Element element : header.elements()) {
            switch (element.name()) {
                case "vertex" -> vertices = PlyVertices.read(element, body, source, notes);
                case "face" -> readFaces(element, requireIndexList(element, "vertex_indices", "vertex_index"), false);
                case "tristrips" -> readFaces(element, requireIndexList(element, "vertex_indices", "vertex_index"), true);
                default -> {
                    notes.add("elements " + element.name(), (int) element.count());
                    skip(element);
                }
            }
        }
        if (vertices == null || triangles.size() == 0) {
            throw source.problem("", "must have vertices and faces");
        }
        return vertices.mesh(triangles.toArray());
    }

    private PlyHeader.Property requireIndexList(PlyHeader.Element element, String... names) throws MeshException {
        for (String name : names) {
            var property = element.property(name);
            if (property.isPresent() && property.get().isList()) {
                return property.get();
            }
        }
        throw source.problem("element " + element.name(), "must have a list vertex_indices");
    }

    private void readFaces(PlyHeader.Element element, PlyHeader.Property indices, boolean strips) throws IOException, MeshException {
        if (vertices == null) {
            throw source.problem("element " + element.name(), "must follow the element vertex");
        }
        for (PlyHeader.Property property : element.properties()) {
            if (property != indices) {
                notes.add("properties " + property.name() + " of faces");
            }
        }
        for (long i = 0; i < element.count(); i++) {
            body.startElement(element.name(), i);
            for (PlyHeader.Property property : element.properties()) {
                if (property != indices) {
                    skip(property);
                } else if (strips) {
                    readStrip(property);
                } else {
                    readFace(property);
                }
            }
            if (triangles.size() > 3 * MeshLimits.TRIANGLES) {
                throw body.problem("a file must have at most " + MeshLimits.TRIANGLES + " triangles");
            }
        }
    }

    private void readFace(PlyHeader.Property list) throws IOException, MeshException {
        int count = body.listLength(list);
        corners.clear();
        for (int i = 0; i < count; i++) {
            corners.add(readVertexIndex(list.type(), 0));
        }
        if (!PolygonTriangulator.isFace(count, notes)) {
            return;
        }
        faceTriangles.clear();
        polygon.triangulate(corners.array(), count, requireNonNull(vertices).positions(), faceTriangles);
        for (int i = 0; i < faceTriangles.size(); i++) {
            triangles.add(corners.get(faceTriangles.get(i)));
        }
    }

    private void readStrip(PlyHeader.Property list) throws IOException, MeshException {
        int count = body.listLength(list);
        int secondLast = RESTART;
        int last = RESTART;
        boolean isFlipped = false;
        for (int i = 0; i < count; i++) {
            int v = readVertexIndex(list.type(), RESTART);
            if (v == RESTART) {
                secondLast = RESTART;
                isFlipped = false;
            } else if (secondLast != RESTART) {
                triangles.add(isFlipped ? last : secondLast);
                triangles.add(isFlipped ? secondLast : last);
                triangles.add(v);
                secondLast = last;
                isFlipped = !isFlipped;
            } else {
                secondLast = last;
            }
            last = v;
        }
    }

    private int readVertexIndex(PlyType type, int min) throws IOException, MeshException {
        double v = body.number(type);
        assert vertices != null;
        if (!(v >= min && v < vertices.count() && v == Math.rint(v))) {
            throw body.problem("a vertex must be a whole number from " + min + " to " + (vertices.count() - 1) + ", was "
                    + (v == Math.rint(v) ? Long.toString((long) v) : Double.toString(v)));
        }
        return (int) v;
    }

    private void skip(PlyHeader.Element element) throws IOException, MeshException {
        for (long i = 0; i < element.count() && !element.properties().isEmpty(); i++) {
            body.startElement(element.name(), i);
            for (PlyHeader.Property property : element.properties()) {
                skip(property);
            }
        }
    }

    private void skip(PlyHeader.Property property) throws IOException, MeshException {
        int count = property.isList() ? body.listLength(property) : 1;
        for (int i = 0; i < count; i++) {
            body.number(property.type());
        }
    }
}
