package lightning.format.mesh.ply;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import lightning.base.math.SrgbCurve;
import lightning.base.text.RefusalException;
import lightning.format.mesh.ByteSource;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.VertexColors;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Vertices of a PLY file. Integer colors are interpreted as sRGB, as scanners and vertex painting tools write them;
 * floating-point colors as linear.
 */
final class PlyVertices {
    private static final List<List<String>> POSITION = List.of(List.of("x"), List.of("y"), List.of("z"));
    private static final List<List<String>> NORMAL = List.of(List.of("nx"), List.of("ny"), List.of("nz"));
    private static final List<List<String>> TEXTURE_COORDINATE = List.of(List.of("u", "s", "texture_u"), List.of("v", "t", "texture_v"));
    private static final List<List<String>> COLOR =
            List.of(List.of("red", "r", "diffuse_red"), List.of("green", "g", "diffuse_green"), List.of("blue", "b", "diffuse_blue"));

    private final ByteSource source;
    private final int count;
    /** Targets of the properties; null for skipped ones. */
    private final @Nullable Target[] targets;
    private final float @Nullable [] positions;
    private final float @Nullable [] normals;
    private final float @Nullable [] textureCoordinates;
    private final float @Nullable [] colors;

    /**
     * Target of a property.
     *
     * @param index component of the vertex attribute
     * @param linearTable linear values of integer colors; null for values without conversion
     */
    private record Target(float[] values, int components, int index, float @Nullable [] linearTable) {}

    private PlyVertices(PlyHeader.Element element, ByteSource source) {
        this.source = source;
        count = (int) element.count();
        targets = new Target[element.properties().size()];
        positions = bindProperties(element, POSITION);
        normals = bindProperties(element, NORMAL);
        textureCoordinates = bindProperties(element, TEXTURE_COORDINATE);
        colors = bindProperties(element, COLOR);
    }

    /**
     * Reads all vertices.
     *
     * @param notes receives omitted properties
     */
    static PlyVertices read(PlyHeader.Element element, PlyBodyReader body, ByteSource source, ConversionNotes notes)
            throws IOException, MeshException {
        if (element.count() > MeshLimits.VERTICES) {
            throw source.problem("element vertex", "must be at most " + MeshLimits.VERTICES + ", was " + element.count());
        }
        var vertices = new PlyVertices(element, source);
        if (vertices.positions == null) {
            throw source.problem("element vertex", "must have the properties x, y and z");
        }
        for (int i = 0; i < vertices.targets.length; i++) {
            if (vertices.targets[i] == null) {
                notes.add("properties " + element.properties().get(i).name() + " of vertices");
            }
        }
        for (int i = 0; i < vertices.count; i++) {
            body.startElement("vertex", i);
            vertices.read(i, element.properties(), body);
        }
        if (vertices.colors != null) {
            VertexColors.clamp(vertices.colors, vertices.count, notes);
        }
        return vertices;
    }

    int count() {
        return count;
    }

    float[] positions() {
        return requireNonNull(positions);
    }

    Mesh mesh(int[] triangles) throws MeshException {
        if (normals != null) {
            VertexNormals.normalizeAll(normals, positions(), triangles);
        }
        try {
            return new Mesh(positions(), triangles, normals, textureCoordinates, colors);
        } catch (RefusalException e) {
            throw source.problem("", e.getMessage());
        }
    }

    private void read(int vertex, List<PlyHeader.Property> properties, PlyBodyReader body) throws IOException, MeshException {
        for (int i = 0; i < targets.length; i++) {
            PlyHeader.Property property = properties.get(i);
            Target target = targets[i];
            int numbers = property.isList() ? body.listLength(property) : 1;
            for (int j = 0; j < numbers; j++) {
                double v = mayBeNaN(target) ? body.numberOrNaN(property.type()) : body.number(property.type());
                if (target != null) {
                    v = target.values == textureCoordinates && Double.isNaN(v) ? 0 : v;
                    target.values[target.components * vertex + target.index] =
                            target.linearTable == null ? (float) v : target.linearTable[colorCode(v, target.linearTable.length, body)];
                }
            }
        }
    }

    /** Returns whether a missing value may be written as {@code nan}: of colors without conversion, normals and texture coordinates. */
    private boolean mayBeNaN(@Nullable Target target) {
        return target != null && target.linearTable == null && target.values != positions;
    }

    private static int colorCode(double v, int codeCount, PlyBodyReader body) throws MeshException {
        if (!(v >= 0 && v < codeCount && v == Math.rint(v))) {
            throw body.problem("a color must be a whole number from 0 to " + (codeCount - 1) + ", was " + v);
        }
        return (int) v;
    }

    /** Allocates an attribute of several components, each with alternative property names; null if any is missing. */
    private float @Nullable [] bindProperties(PlyHeader.Element element, List<List<String>> names) {
        List<Integer> found = new ArrayList<>();
        for (List<String> aliases : names) {
            for (int i = 0; i < targets.length; i++) {
                PlyHeader.Property property = element.properties().get(i);
                if (aliases.contains(property.name()) && !property.isList()
                        && (names != COLOR || isColor(property.type()))) {
                    found.add(i);
                    break;
                }
            }
        }
        if (found.size() < names.size()) {
            return null;
        }
        float[] values = new float[names.size() * count];
        for (int i = 0; i < found.size(); i++) {
            PlyType type = element.properties().get(found.get(i)).type();
            targets[found.get(i)] =
                    new Target(values, names.size(), i, names == COLOR && type.isInteger() ? linearTable((int) type.maxValue) : null);
        }
        return values;
    }

    private static boolean isColor(PlyType type) {
        return !type.isInteger() || type == PlyType.UINT8 || type == PlyType.UINT16;
    }

    private static float[] linearTable(int maxValue) {
        float[] linear = new float[maxValue + 1];
        for (int i = 0; i <= maxValue; i++) {
            linear[i] = (float) SrgbCurve.toLinear((double) i / maxValue);
        }
        return linear;
    }
}
