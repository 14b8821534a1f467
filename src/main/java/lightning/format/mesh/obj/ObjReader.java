package lightning.format.mesh.obj;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.SrgbCurve;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.Notes;
import lightning.format.mesh.PartNames;
import lightning.format.mesh.Polygon;
import lightning.format.mesh.TextSource;
import lightning.format.mesh.VertexColors;
import lightning.scene.Mesh;

/**
 * Reads OBJ files: faces of any number of corners, with texture coordinates, normals, groups that are smooth together, colours of
 * vertices (as sRGB), objects, groups and materials. What else they hold is passed over and told.
 */
public final class ObjReader {
    private static final int MOST_SMOOTHING = 1 << 30;

    private final ByteSource source;
    private final TextSource text;
    private final Notes notes;
    private final ObjPoints points = new ObjPoints();
    private final ObjCorners corners;
    /** By object and material: strings, since a file may choose names that collide, which tables of strings can bear. */
    private final Map<String, ObjMesh> meshes = new LinkedHashMap<>();
    private final List<String> libraries = new ArrayList<>();
    private final Polygon polygon = new Polygon();
    private final IntList positions = new IntList();
    private final IntList vertices = new IntList();
    private final IntList cut = new IntList();
    private String object = "";
    private String material = "";
    private int smooth;
    private int triangles;
    /** The mesh of the object and material that hold now; null until a face asks for it. */
    private ObjMesh current;

    private ObjReader(ByteSource source, Notes notes) {
        this.source = source;
        this.notes = notes;
        text = new TextSource(source);
        corners = new ObjCorners(text, points, notes);
    }

    /**
     * Reads a whole file.
     *
     * @param notes hears what is left out
     * @throws MeshException if it is damaged, or has no face
     * @throws IOException   if it cannot be read
     */
    public static ObjFile read(ByteSource source, Notes notes) throws IOException, MeshException {
        return new ObjReader(source, notes).read();
    }

    private ObjFile read() throws IOException, MeshException {
        do {
            if (word()) {
                statement();
            }
        } while (text.nextLine());
        if (triangles == 0) {
            throw source.problem("", "must have faces: without them there is nothing to light");
        }
        return new ObjFile(parts(), List.copyOf(libraries));
    }

    /** The next word of this line, or of the one behind it where a backslash ends this one. */
    private boolean word() throws IOException, MeshException {
        while (text.word()) {
            if (text.at(0) == '#') {
                return false;
            }
            if (!text.is("\\")) {
                return true;
            }
            text.nextLine();
        }
        return false;
    }

    private void statement() throws IOException, MeshException {
        String keyword = text.length() <= 16 ? text.text() : Quote.of(text.text());
        switch (keyword) {
            case "v" -> position();
            case "vt" -> {
                corners.checkOrder(ObjCorners.COORDINATES);
                int count = numbers(points.coordinates, 1, 2, Mesh.MAX_TEXTURE_COORDINATE);
                if (count == 1) {
                    points.coordinates.add(0);
                }
            }
            case "vn" -> {
                corners.checkOrder(ObjCorners.NORMALS);
                numbers(points.normals, 3, 3, Double.MAX_VALUE);
            }
            case "f", "fo" -> face();
            case "o", "g" -> {
                object = text.rest();
                current = null;
            }
            case "usemtl" -> {
                material = text.rest();
                current = null;
            }
            case "mtllib" -> {
                if (libraries.size() < MeshLimits.PARTS) {
                    libraries.add(text.rest());
                }
            }
            case "s" -> smoothing();
            case "l" -> notes.add("lines");
            case "p" -> notes.add("points");
            default -> notes.add("statements " + keyword);
        }
    }

    private void position() throws IOException, MeshException {
        int before = points.positions.size();
        numbers(points.positions, 3, 3, Mesh.MAX_COORDINATE);
        // One more number is a weight, which acts on curves alone; three are a colour; four are both.
        double[] more = new double[4];
        int count = 0;
        while (count < more.length && word()) {
            more[count++] = text.numberOrNaN("a vertex");
        }
        if (count >= 3) {
            while (points.colors.size() < before) {
                points.colors.add(1);
            }
            for (int i = count - 3; i < count; i++) {
                points.colors.add((float) SrgbCurve.linear(more[i]));
            }
        }
    }

    /** Takes from {@code least} to {@code most} numbers of this line, each of at most {@code largest} in absolute value. */
    private int numbers(FloatList to, int least, int most, double largest) throws IOException, MeshException {
        if (to.size() >= 3 * MeshLimits.VERTICES) {
            throw text.problem("a file must have at most " + MeshLimits.VERTICES + " vertices, normals and texture coordinates each");
        }
        int count = 0;
        while (count < most && word()) {
            double v = text.number("a coordinate");
            if (Math.abs(v) > largest) {
                throw text.problem(
                        "a coordinate must be at most " + Decimal.text(largest) + " in absolute value, was " + Quote.of(text.text()));
            }
            to.add((float) v);
            count++;
        }
        if (count < least) {
            throw text.problem("expected " + least + " numbers, found " + count);
        }
        return count;
    }

    private void smoothing() throws IOException, MeshException {
        if (!word()) {
            throw text.problem("expected the number of a smoothing group, or off");
        }
        smooth = text.is("off") ? 0 : (int) text.whole("a smoothing group", 0, MOST_SMOOTHING);
    }

    private void face() throws IOException, MeshException {
        ObjMesh mesh = mesh();
        positions.clear();
        vertices.clear();
        while (word()) {
            vertices.add(corners.vertex(mesh, smooth));
            positions.add(corners.position());
        }
        int count = vertices.size();
        if (count < 3) {
            notes.add("faces of fewer than three corners");
            return;
        }
        if (count > Polygon.MOST_CORNERS) {
            notes.add("outlines of faces with more than " + Polygon.MOST_CORNERS + " corners, which are cut as if they were convex");
        }
        triangles += count - 2;
        if (triangles > MeshLimits.TRIANGLES) {
            throw text.problem("a file must have at most " + MeshLimits.TRIANGLES + " triangles");
        }
        cut.clear();
        polygon.triangulate(positions.array(), count, points.positions.array(), cut);
        for (int i = 0; i < cut.size(); i += 3) {
            mesh.triangle(vertices.get(cut.get(i)), vertices.get(cut.get(i + 1)), vertices.get(cut.get(i + 2)));
        }
    }

    private ObjMesh mesh() throws MeshException {
        if (current == null) {
            if (meshes.size() == MeshLimits.PARTS) {
                throw text.problem("a file must have at most " + MeshLimits.PARTS + " objects with a material each");
            }
            current = meshes.computeIfAbsent(object + '\n' + material, _ -> new ObjMesh(object, material));
        }
        return current;
    }

    private List<ObjFile.ObjPart> parts() throws MeshException {
        if (points.colors.size() > 0) {
            points.whiten();
            VertexColors.cut(points.colors.array(), points.positionCount(), notes);
        }
        Map<String, Integer> materials = new HashMap<>();
        meshes.values().forEach(mesh -> materials.merge(mesh.object, 1, Integer::sum));
        var names = new PartNames();
        List<ObjFile.ObjPart> parts = new ArrayList<>();
        for (ObjMesh mesh : meshes.values().stream().filter(ObjMesh::hasTriangles).toList()) {
            boolean alone = mesh.material.isEmpty() || !mesh.object.isEmpty() && materials.get(mesh.object) == 1;
            String wanted = alone ? mesh.object : mesh.object.isEmpty() ? mesh.material : mesh.object + " (" + mesh.material + ")";
            try {
                parts.add(new ObjFile.ObjPart(names.unique(wanted, "mesh"), mesh.material, mesh.mesh(points)));
            } catch (IllegalArgumentException e) {
                throw source.problem(mesh.object.isEmpty() ? "" : "object " + Quote.of(mesh.object), e.getMessage());
            }
        }
        return List.copyOf(parts);
    }
}
