package lightning.format.mesh.obj;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.SrgbCurve;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.mesh.BadLineException;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.PolygonTriangulator;
import lightning.format.mesh.TextTokenizer;
import lightning.format.mesh.UniqueNames;
import lightning.format.mesh.VertexColors;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Reader for OBJ files: polygons with texture coordinates, normals, smoothing groups, vertex colors (as sRGB), objects,
 * groups and materials. Skips and notes all other content.
 */
public final class ObjReader {
    private static final int MAX_SMOOTHING_GROUP = 1 << 30;

    private final ByteSource source;
    private final TextTokenizer text;
    private final ConversionNotes notes;
    private final ObjVertexData points = new ObjVertexData();
    private final ObjCornerParser corners;
    /**
     * Meshes by object and material. Strings as keys, since hash maps handle colliding strings well even if a file contains
     * them on purpose.
     */
    private final Map<String, ObjMeshBuilder> meshes = new LinkedHashMap<>();
    private final List<String> libraries = new ArrayList<>();
    private final PolygonTriangulator polygon = new PolygonTriangulator();
    private final IntList positions = new IntList();
    private final IntList vertices = new IntList();
    private final IntList faceTriangles = new IntList();
    /** Values of a line. */
    private final float[] values = new float[3];
    private String object = "";
    private String material = "";
    private int smoothingGroup;
    /** Positions that are no numbers. */
    private final BitSet unreadable = new BitSet();
    private int triangles;
    /** Mesh of the current object and material; null until a face needs it. */
    private @Nullable ObjMeshBuilder current;

    private ObjReader(ByteSource source, ConversionNotes notes) {
        this.source = source;
        this.notes = notes;
        text = new TextTokenizer(source);
        corners = new ObjCornerParser(text, points, notes);
    }

    /**
     * Reads a whole file.
     *
     * @param notes receives omitted features
     * @throws MeshException if it is invalid, or has no face
     * @throws IOException if it cannot be read
     */
    public static ObjFile read(ByteSource source, ConversionNotes notes) throws IOException, MeshException {
        return new ObjReader(source, notes).read();
    }

    private ObjFile read() throws IOException, MeshException {
        text.skipByteOrderMark();
        BadLineException first = null;
        do {
            try {
                if (nextToken()) {
                    readStatement();
                }
            } catch (BadLineException e) {
                first = first == null ? e : first;
                notes.add(e.note());
            }
        } while (text.nextLine());
        if (triangles == 0) {
            throw first != null ? first : source.problem("", "must have faces");
        }
        return new ObjFile(parts(), List.copyOf(libraries));
    }

    /** Reads the next token of this line, or of the next line after a trailing backslash. */
    private boolean nextToken() throws IOException, MeshException {
        while (text.readToken()) {
            if (text.byteAt(0) == '#') {
                return false;
            }
            if (!text.continueLine() || text.length() > 0) {
                return true;
            }
        }
        return false;
    }

    private void readStatement() throws IOException, MeshException {
        String keyword = text.length() <= 16 ? text.text() : Quote.of(text.text());
        switch (keyword) {
            case "v" -> readPosition();
            case "vt" -> {
                corners.checkOrder(ObjCornerParser.COORDINATES);
                readValues(points.coordinates, 1, 2, Mesh.MAX_TEXTURE_COORDINATE, 0);
            }
            case "vn" -> {
                corners.checkOrder(ObjCornerParser.NORMALS);
                // Normals that are no numbers are replaced by those of the faces.
                readValues(points.normals, 3, 3, Double.MAX_VALUE, Float.NaN);
            }
            case "f", "fo" -> readFace();
            case "o", "g" -> {
                object = text.restOfLine();
                current = null;
            }
            case "usemtl" -> {
                material = text.restOfLine();
                current = null;
            }
            case "mtllib" -> {
                if (libraries.size() < MeshLimits.PARTS) {
                    libraries.add(text.restOfLine());
                }
            }
            case "s" -> readSmoothingGroup();
            case "l" -> notes.add("lines");
            case "p" -> notes.add("points");
            default -> notes.add("statements " + keyword);
        }
    }

    private void readPosition() throws IOException, MeshException {
        int size = points.positions.size();
        if (!readValues(points.positions, 3, 3, Mesh.MAX_COORDINATE, 0)) {
            unreadable.set(size / 3);
        }
        // One extra number is a weight for curves; three are a color; four are both.
        double[] extra = new double[4];
        int count = 0;
        while (count < extra.length && nextToken()) {
            extra[count++] = text.numberOrNaN("a vertex");
        }
        if (count >= 3) {
            while (points.colors.size() < size) {
                points.colors.add(1);
            }
            for (int i = count - 3; i < count; i++) {
                points.colors.add((float) SrgbCurve.toLinear(extra[i]));
            }
        }
    }

    /**
     * Adds {@code maxCount} values of this line. Later lines count on them, so a line that is bad adds the fallback for each.
     *
     * @param minCount minimum number of values in the line; absent ones are 0
     * @param maxValue largest absolute value
     * @return false if a value is no number
     */
    private boolean readValues(FloatList out, int minCount, int maxCount, double maxValue, float fallback)
            throws IOException, MeshException {
        if (out.size() >= 3 * MeshLimits.VERTICES) {
            throw text.problem("a file must have at most " + MeshLimits.VERTICES + " vertices, normals and texture coordinates each");
        }
        int count = 0;
        boolean isNumeric = true;
        boolean isComplete = false;
        try {
            while (count < maxCount && nextToken()) {
                double v = text.numberOrNaN("a coordinate");
                if (Math.abs(v) > maxValue) {
                    throw text.badLine("a coordinate must be at most " + DecimalNumber.format(maxValue) + " in absolute value, was "
                            + Quote.of(text.text()));
                }
                isNumeric &= !Double.isNaN(v);
                values[count++] = (float) v;
            }
            if (count < minCount) {
                throw text.badLine("expected " + minCount + " numbers, found " + count);
            }
            isComplete = true;
        } finally {
            for (int i = 0; i < maxCount; i++) {
                out.add(!isComplete || !isNumeric ? fallback : i < count ? values[i] : 0);
            }
            if (!isComplete && out == points.positions) {
                unreadable.set(out.size() / 3 - 1);
            }
        }
        return isNumeric;
    }

    private void readSmoothingGroup() throws IOException, MeshException {
        if (!nextToken()) {
            throw text.badLine("expected the number of a smoothing group, or off");
        }
        smoothingGroup = text.isToken("off") ? 0 : (int) text.integer("a smoothing group", 0, MAX_SMOOTHING_GROUP);
    }

    private void readFace() throws IOException, MeshException {
        ObjMeshBuilder mesh = currentMesh();
        positions.clear();
        vertices.clear();
        while (nextToken()) {
            vertices.add(corners.readVertex(mesh, smoothingGroup));
            positions.add(corners.position());
        }
        int count = vertices.size();
        for (int i = 0; i < count && !unreadable.isEmpty(); i++) {
            if (unreadable.get(positions.get(i))) {
                notes.add("faces with vertices that are no numbers");
                return;
            }
        }
        if (!PolygonTriangulator.isFace(count, notes)) {
            return;
        }
        triangles += count - 2;
        if (triangles > MeshLimits.TRIANGLES) {
            throw text.problem("a file must have at most " + MeshLimits.TRIANGLES + " triangles");
        }
        faceTriangles.clear();
        polygon.triangulate(positions.array(), count, points.positions.array(), faceTriangles);
        for (int i = 0; i < faceTriangles.size(); i += 3) {
            mesh.addTriangle(vertices.get(faceTriangles.get(i)), vertices.get(faceTriangles.get(i + 1)),
                    vertices.get(faceTriangles.get(i + 2)));
        }
    }

    private ObjMeshBuilder currentMesh() throws MeshException {
        if (current == null) {
            if (meshes.size() == MeshLimits.PARTS) {
                throw text.problem("a file must have at most " + MeshLimits.PARTS + " objects with a material each");
            }
            current = meshes.computeIfAbsent(object + '\n' + material, _ -> new ObjMeshBuilder(object, material));
        }
        return current;
    }

    private List<ObjFile.ObjPart> parts() throws MeshException {
        if (points.colors.size() > 0) {
            points.padColors();
            VertexColors.clamp(points.colors.array(), points.positionCount(), notes);
        }
        Map<String, Integer> materials = new HashMap<>();
        meshes.values().forEach(mesh -> materials.merge(mesh.object, 1, Integer::sum));
        var names = new UniqueNames();
        List<ObjFile.ObjPart> parts = new ArrayList<>();
        for (ObjMeshBuilder mesh : meshes.values().stream().filter(ObjMeshBuilder::hasTriangles).toList()) {
            boolean usesObjectName = mesh.material.isEmpty() || !mesh.object.isEmpty() && requireNonNull(materials.get(mesh.object)) == 1;
            String requestedName =
                    usesObjectName ? mesh.object : mesh.object.isEmpty() ? mesh.material : mesh.object + " (" + mesh.material + ")";
            try {
                parts.add(new ObjFile.ObjPart(names.unique(requestedName, "mesh"), mesh.material, mesh.build(points)));
            } catch (RefusalException e) {
                throw source.problem(mesh.object.isEmpty() ? "" : "object " + Quote.of(mesh.object), e.getMessage());
            }
        }
        return List.copyOf(parts);
    }
}
