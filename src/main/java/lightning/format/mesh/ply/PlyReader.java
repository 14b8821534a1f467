package lightning.format.mesh.ply;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.IntList;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.Notes;
import lightning.format.mesh.Polygon;
import lightning.format.mesh.TextSource;
import lightning.scene.Mesh;

/**
 * Reads PLY files: vertices with positions, normals, texture coordinates and colours; faces of any number of corners; strips of
 * triangles. What else they hold is passed over and told.
 */
public final class PlyReader {
    private static final byte[] MAGIC = "ply".getBytes(StandardCharsets.US_ASCII);
    /** In lists of strips: the next vertex begins a new one. */
    private static final int RESTART = -1;

    private final ByteSource source;
    private final Notes notes;
    private final IntList triangles = new IntList();
    private final Polygon polygon = new Polygon();
    private final IntList corners = new IntList();
    private final IntList cut = new IntList();
    private PlyBody body;
    private PlyVertices vertices;

    private PlyReader(ByteSource source, Notes notes) {
        this.source = source;
        this.notes = notes;
    }

    /** Whether a file begins as PLY files do. */
    public static boolean isPly(ByteSource source) throws IOException {
        return source.startsWith(MAGIC);
    }

    /**
     * Reads a whole file.
     *
     * @param notes hears what is left out
     * @throws MeshException if it is damaged, says more than it holds, or has no triangle
     * @throws IOException   if it cannot be read
     */
    public static Mesh read(ByteSource source, Notes notes) throws IOException, MeshException {
        return new PlyReader(source, notes).read();
    }

    private Mesh read() throws IOException, MeshException {
        var text = new TextSource(source);
        PlyHeader header = PlyHeader.read(text, source, notes);
        body = new PlyBody(header.format(), text, source, notes);
        for (PlyHeader.Element element : header.elements()) {
            switch (element.name()) {
                case "vertex" -> vertices = PlyVertices.read(element, body, source, notes);
                case "face" -> faces(element, list(element, "vertex_indices", "vertex_index"), false);
                case "tristrips" -> faces(element, list(element, "vertex_indices", "vertex_index"), true);
                default -> {
                    notes.add("elements " + element.name(), (int) element.count());
                    pass(element);
                }
            }
        }
        if (vertices == null || triangles.size() == 0) {
            throw source.problem("", "must have vertices and faces: without them there is nothing to light");
        }
        return vertices.mesh(triangles.toArray());
    }

    private PlyHeader.Property list(PlyHeader.Element element, String... names) throws MeshException {
        for (String name : names) {
            var property = element.property(name);
            if (property.isPresent() && property.get().isList()) {
                return property.get();
            }
        }
        throw source.problem("element " + element.name(), "must have a list vertex_indices");
    }

    private void faces(PlyHeader.Element element, PlyHeader.Property indices, boolean strips) throws IOException, MeshException {
        if (vertices == null) {
            throw source.problem("element " + element.name(), "must stand behind the element vertex");
        }
        for (PlyHeader.Property property : element.properties()) {
            if (property != indices) {
                notes.add("properties " + property.name() + " of faces");
            }
        }
        for (long i = 0; i < element.count(); i++) {
            body.enter(element.name(), i);
            for (PlyHeader.Property property : element.properties()) {
                if (property != indices) {
                    pass(property);
                } else if (strips) {
                    strip(property);
                } else {
                    face(property);
                }
            }
            if (triangles.size() > 3 * MeshLimits.TRIANGLES) {
                throw body.problem("a file must have at most " + MeshLimits.TRIANGLES + " triangles");
            }
        }
    }

    private void face(PlyHeader.Property list) throws IOException, MeshException {
        int count = body.length(list);
        corners.clear();
        for (int i = 0; i < count; i++) {
            corners.add(vertex(list.type(), 0));
        }
        if (count < 3) {
            notes.add("faces of fewer than three corners");
            return;
        }
        if (count > Polygon.MOST_CORNERS) {
            notes.add("outlines of faces with more than " + Polygon.MOST_CORNERS + " corners, which are cut as if they were convex");
        }
        cut.clear();
        polygon.triangulate(corners.array(), count, vertices.positions(), cut);
        for (int i = 0; i < cut.size(); i++) {
            triangles.add(corners.get(cut.get(i)));
        }
    }

    private void strip(PlyHeader.Property list) throws IOException, MeshException {
        int count = body.length(list);
        int before = RESTART;
        int last = RESTART;
        boolean turned = false;
        for (int i = 0; i < count; i++) {
            int v = vertex(list.type(), RESTART);
            if (v == RESTART) {
                before = RESTART;
                turned = false;
            } else if (before != RESTART) {
                triangles.add(turned ? last : before);
                triangles.add(turned ? before : last);
                triangles.add(v);
                before = last;
                turned = !turned;
            } else {
                before = last;
            }
            last = v;
        }
    }

    private int vertex(PlyType type, int least) throws IOException, MeshException {
        double v = body.number(type);
        if (!(v >= least && v < vertices.count() && v == Math.rint(v))) {
            throw body.problem("a vertex must be a whole number from " + least + " to " + (vertices.count() - 1) + ", was "
                    + (v == Math.rint(v) ? Long.toString((long) v) : Double.toString(v)));
        }
        return (int) v;
    }

    private void pass(PlyHeader.Element element) throws IOException, MeshException {
        for (long i = 0; i < element.count() && !element.properties().isEmpty(); i++) {
            body.enter(element.name(), i);
            for (PlyHeader.Property property : element.properties()) {
                pass(property);
            }
        }
    }

    private void pass(PlyHeader.Property property) throws IOException, MeshException {
        int count = property.isList() ? body.length(property) : 1;
        for (int i = 0; i < count; i++) {
            body.number(property.type());
        }
    }
}
