package lightning.format.gltf;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.RefusalException;
import lightning.base.work.HeapBudget;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.LimitException;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.Tangents;
import lightning.format.mesh.UniqueNames;
import lightning.format.mesh.VertexColors;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Reader for the meshes of a glTF file, one part for each primitive: triangles, strips and fans. A part contains only the
 * vertices that its triangles use, because many parts often share one vertex pool.
 */
public final class GltfMeshReader {
    private static final int TRIANGLES_MODE = 4;
    private static final int FAN_MODE = 6;

    private final GltfFile file;
    private final ConversionNotes notes;
    private final AccessorReader accessors;
    private final ExpansionLimit expansionLimit;
    private final UniqueNames names = new UniqueNames();
    private final List<GltfPart> parts = new ArrayList<>();
    /** Values of accessors already read, by accessor and requested form. */
    private final Map<String, float[]> cachedValues = new HashMap<>();
    /** True for an accessor whose colors are transparent. */
    private final Map<Integer, Boolean> transparentColors = new HashMap<>();
    /** Compacted index of each vertex of a pool; all −1 between two parts. */
    private int[] vertexMap = {};
    private long bytes;

    private GltfMeshReader(GltfFile file, ConversionNotes notes) throws IOException, MeshException {
        this.file = file;
        expansionLimit = new ExpansionLimit(file);
        this.notes = notes;
        accessors = new AccessorReader(file);
    }

    /**
     * Reads all meshes.
     *
     * @param notes receives omitted features
     * @throws MeshException if the meshes are invalid, or there are none
     * @throws IOException if an external file cannot be read
     */
    public static List<GltfPart> read(GltfFile file, ConversionNotes notes) throws IOException, MeshException {
        List<GltfPart> parts = readAll(file, notes);
        if (parts.isEmpty()) {
            throw file.root().get("meshes").problem("must have triangles");
        }
        return parts;
    }

    /** Reads all meshes as {@link #read}; empty if there are none. */
    public static List<GltfPart> readAll(GltfFile file, ConversionNotes notes) throws IOException, MeshException {
        return new GltfMeshReader(file, notes).read();
    }

    private List<GltfPart> read() throws IOException, MeshException {
        JsonValue meshes = file.array("meshes");
        MeshException first = null;
        for (int i = 0; i < meshes.size(); i++) {
            JsonValue primitives = meshes.element(i).get("primitives");
            String name = meshes.element(i).get("name").text().orElse("");
            for (int j = 0; j < primitives.size(); j++) {
                file.progress().checkCanceled("canceled after " + parts.size() + " parts");
                try {
                    readPrimitive(i, j, name, primitives.element(j), primitives.size() > 1);
                } catch (LimitException e) {
                    throw e;
                } catch (MeshException e) {
                    first = first == null ? e : first;
                    notes.add("primitives that are invalid, left out");
                }
            }
        }
        if (parts.isEmpty() && first != null) {
            throw first;
        }
        return List.copyOf(parts);
    }

    private static int mode(JsonValue primitive) throws MeshException {
        return primitive.get("mode").integer(0, 6, TRIANGLES_MODE);
    }

    /** Returns whether a primitive declares triangles with positions. */
    static boolean isDrawable(JsonValue primitive) throws MeshException {
        return mode(primitive) >= TRIANGLES_MODE && primitive.get("attributes").get("POSITION").isPresent();
    }

    private void readPrimitive(int mesh, int index, String name, JsonValue primitive, boolean hasSiblings)
            throws IOException, MeshException {
        int mode = mode(primitive);
        if (mode < TRIANGLES_MODE) {
            notes.add(mode == 0 ? "primitives of points" : "primitives of lines");
            return;
        }
        JsonValue position = primitive.get("attributes").get("POSITION");
        if (!position.isPresent()) {
            notes.add("primitives without positions, or compressed");
            return;
        }
        new DracoPrimitive(file, accessors).decode(primitive);
        // Read positions first: they define the number of vertices.
        int vertices = readValues(position, 3).length / 3;
        JsonValue indices = primitive.get("indices");
        int[] triangles = triangles(mode, indices.isPresent() ? accessors.indices(indices, vertices) : null, vertices);
        if (triangles.length == 0) {
            notes.add("primitives without triangles");
            return;
        }
        if (parts.size() == MeshLimits.PARTS) {
            throw primitive.limit("a file must have at most " + MeshLimits.PARTS + " primitives");
        }
        JsonValue material = primitive.get("material");
        int materialIndex = material.isPresent() ? material.index(file.array("materials")) : -1;
        String materialName = materialIndex < 0 ? "" : file.array("materials").element(materialIndex).get("name").text().orElse("");
        String requestedName =
                hasSiblings && !materialName.isEmpty() ? (name.isEmpty() ? materialName : name + " (" + materialName + ")") : name;
        int[] used = compact(triangles, vertices);
        Mesh triangleMesh = mesh(primitive, triangles, used, vertices, materialIndex);
        boolean canBePosed = primitive.get("targets").isPresent() || primitive.get("attributes").get("JOINTS_0").isPresent();
        parts.add(new GltfPart(mesh, index, names.unique(requestedName, "mesh"), materialIndex, triangleMesh,
                canBePosed ? used : new int[0]));
    }

    private static int[] triangles(int mode, int @Nullable [] indices, int vertices) {
        int corners = indices == null ? vertices : indices.length;
        int count = mode == TRIANGLES_MODE ? corners / 3 : Math.max(0, corners - 2);
        int[] triangles = new int[3 * Math.min(count, MeshLimits.TRIANGLES)];
        for (int t = 0; t < triangles.length / 3; t++) {
            // glTF 2.0, §3.7.2.1.
            int a = mode == TRIANGLES_MODE ? 3 * t : mode == FAN_MODE ? t + 1 : t;
            int b = mode == TRIANGLES_MODE ? 3 * t + 1 : mode == FAN_MODE ? t + 2 : t + 1 + t % 2;
            int c = mode == TRIANGLES_MODE ? 3 * t + 2 : mode == FAN_MODE ? 0 : t + 2 - t % 2;
            triangles[3 * t] = indices == null ? a : indices[a];
            triangles[3 * t + 1] = indices == null ? b : indices[b];
            triangles[3 * t + 2] = indices == null ? c : indices[c];
        }
        return triangles;
    }

    private Mesh mesh(JsonValue primitive, int[] triangles, int[] used, int vertices, int material) throws IOException, MeshException {
        JsonValue attributes = primitive.get("attributes");
        TextureTransform textureCoordinates = TextureTransform.of(file, material);
        JsonValue uvAccessor = attributes.get("TEXCOORD_" + textureCoordinates.set());
        reserveBytes(triangles.length
                + (long) used.length * (3 + (attributes.get("NORMAL").isPresent() ? 3 : 0) + (uvAccessor.isPresent() ? 2 : 0)
                        + (attributes.get("COLOR_0").isPresent() ? 3 : 0) + (hasTangents(attributes) ? 4 : 0)),
                primitive);
        float[] positions = requireNonNull(gather(attributes.get("POSITION"), 3, vertices, used));
        float[] normals = gather(attributes.get("NORMAL"), 3, vertices, used);
        float[] coordinates = gather(uvAccessor, 2, vertices, used);
        float[] colors = gather(attributes.get("COLOR_0"), 3, vertices, used);
        float[] tangents = hasTangents(attributes) ? gather(attributes.get("TANGENT"), 4, vertices, used) : null;
        if (tangents != null) {
            Tangents.normalizeAll(tangents, notes);
        }
        if (colors != null) {
            VertexColors.clamp(colors, used.length, notes);
            notes.add("vertex colors with an alpha below 1, imported as opaque", hasAlpha(attributes.get("COLOR_0")) ? 1 : 0);
        }
        noteUnusedAttributes(primitive, textureCoordinates.set());
        if (normals != null) {
            VertexNormals.normalizeAll(normals, positions, triangles);
        }
        if (coordinates != null) {
            textureCoordinates.apply(coordinates);
        }
        try {
            return new Mesh(positions, triangles, normals, coordinates, colors, tangents);
        } catch (RefusalException e) {
            throw primitive.problem(e.getMessage());
        }
    }

    /** Adds to the memory estimate, and rejects the file if it is too large. */
    private void reserveBytes(long count, JsonValue primitive) throws MeshException {
        bytes += 4 * count;
        expansionLimit.checkBytes(bytes, primitive);
        if (bytes > HeapBudget.availableBytes() / 2) {
            throw primitive.limit("the meshes up to here take " + (bytes >> 20) + " MiB, more than half of the available memory");
        }
    }

    private void noteUnusedAttributes(JsonValue primitive, int set) throws MeshException {
        boolean tangents = hasTangents(primitive.get("attributes"));
        primitive.get("attributes").node().propertyNames().forEach(name -> {
            if (!name.equals("POSITION") && !name.equals("NORMAL") && !name.equals("COLOR_0") && !name.equals("TEXCOORD_" + set)
                    && !name.startsWith("JOINTS_") && !name.startsWith("WEIGHTS_")
                    && !(tangents && name.equals("TANGENT"))) {
                notes.add("attributes " + name + " of primitives");
            }
        });
    }

    /** Returns whether any vertex color is transparent. */
    private boolean hasAlpha(JsonValue colors) throws IOException, MeshException {
        int index = colors.index(file.array("accessors"));
        Boolean known = transparentColors.get(index);
        if (known == null) {
            known = readAlpha(colors);
            transparentColors.put(index, known);
        }
        return known;
    }

    private boolean readAlpha(JsonValue colors) throws IOException, MeshException {
        if (!colors.resolve(file.array("accessors")).get("type").text().orElse("").equals("VEC4")) {
            return false;
        }
        float[] values = accessors.floats(colors, 4);
        for (int i = 3; i < values.length; i += 4) {
            if (values[i] < 1) {
                return true;
            }
        }
        return false;
    }

    /** Returns whether tangents apply; those without normals must be ignored: glTF 2.0, §3.7.2.1. */
    private static boolean hasTangents(JsonValue attributes) throws MeshException {
        return attributes.get("TANGENT").isPresent() && attributes.get("NORMAL").isPresent();
    }

    /** Renumbers the used vertices in place, and returns their original indices. */
    private int[] compact(int[] triangles, int vertices) {
        if (vertexMap.length < vertices) {
            vertexMap = new int[vertices];
            Arrays.fill(vertexMap, -1);
        }
        int[] used = new int[Math.min(vertices, triangles.length)];
        int count = 0;
        for (int i = 0; i < triangles.length; i++) {
            int v = triangles[i];
            if (vertexMap[v] < 0) {
                used[count] = v;
                vertexMap[v] = count++;
            }
            triangles[i] = vertexMap[v];
        }
        for (int i = 0; i < count; i++) {
            vertexMap[used[i]] = -1;
        }
        return Arrays.copyOf(used, count);
    }

    /** Returns the values of the used vertices; null if the accessor is absent. */
    private float @Nullable [] gather(JsonValue accessor, int components, int vertices, int[] used) throws IOException, MeshException {
        if (!accessor.isPresent()) {
            return null;
        }
        if (accessors.count(accessor) != vertices) {
            throw accessor.problem("must have one value per position, " + vertices + ", has " + accessors.count(accessor));
        }
        float[] values = readValues(accessor, components);
        float[] result = new float[components * used.length];
        for (int i = 0; i < used.length; i++) {
            System.arraycopy(values, components * used[i], result, components * i, components);
        }
        return result;
    }

    /** Returns all values of an accessor, read once. */
    private float[] readValues(JsonValue accessor, int components) throws IOException, MeshException {
        String key = accessor.index(file.array("accessors")) + " " + components;
        float[] values = cachedValues.get(key);
        if (values == null) {
            values = accessors.floats(accessor, components);
            reserveBytes(values.length, accessor);
            cachedValues.put(key, values);
        }
        return values;
    }
}
