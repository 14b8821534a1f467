package lightning.format.gltf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import lightning.base.work.Memory;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import lightning.format.mesh.Normals;
import lightning.format.mesh.Notes;
import lightning.format.mesh.PartNames;
import lightning.format.mesh.Tangents;
import lightning.format.mesh.VertexColors;
import lightning.scene.Mesh;

/**
 * The meshes of a glTF file, a part for each primitive: triangles, strips and fans. A part keeps the vertices that its triangles
 * name: many parts of one pool of vertices are common, and no vertex is kept twice for them.
 */
public final class GltfMeshes {
    private static final int TRIANGLES = 4;
    private static final int FAN = 6;

    private final GltfFile file;
    private final Notes notes;
    private final Accessors accessors;
    private final Unfolding unfolding;
    private final PartNames names = new PartNames();
    private final List<GltfPart> parts = new ArrayList<>();
    /** The numbers of accessors that were read, by accessor and what they are read as. */
    private final Map<String, float[]> read = new HashMap<>();
    /** The new number of each vertex of a pool; −1 between two parts. */
    private int[] now = {};
    private long bytes;

    private GltfMeshes(GltfFile file, Notes notes) throws IOException, MeshException {
        this.file = file;
        unfolding = new Unfolding(file);
        this.notes = notes;
        accessors = new Accessors(file);
    }

    /**
     * Reads all meshes.
     *
     * @param notes hears what is left out
     * @throws MeshException if anything of them is wrong, or there are none
     * @throws IOException   if a file beside it cannot be read
     */
    public static List<GltfPart> read(GltfFile file, Notes notes) throws IOException, MeshException {
        return new GltfMeshes(file, notes).read();
    }

    private List<GltfPart> read() throws IOException, MeshException {
        Json meshes = file.array("meshes");
        for (int i = 0; i < meshes.size(); i++) {
            Json primitives = meshes.at(i).get("primitives");
            String name = meshes.at(i).get("name").text().orElse("");
            for (int j = 0; j < primitives.size(); j++) {
                if (file.progress().isCancelled()) {
                    throw new CancellationException("cancelled after " + parts.size() + " parts");
                }
                primitive(i, name, primitives.at(j), primitives.size() > 1);
            }
            if (meshes.at(i).get("weights").isThere()) {
                notes.add("meshes with morph targets");
            }
        }
        if (parts.isEmpty()) {
            throw file.root().get("meshes").problem("must have triangles: without them there is nothing to light");
        }
        return List.copyOf(parts);
    }

    private static int mode(Json primitive) throws MeshException {
        return primitive.get("mode").whole(0, 6, TRIANGLES);
    }

    /** Whether a primitive is one of triangles with positions, as far as its own words say. */
    static boolean mayShow(Json primitive) throws MeshException {
        return mode(primitive) >= TRIANGLES && primitive.get("attributes").get("POSITION").isThere();
    }

    private void primitive(int mesh, String name, Json primitive, boolean several) throws IOException, MeshException {
        int mode = mode(primitive);
        if (mode < TRIANGLES) {
            notes.add(mode == 0 ? "primitives of points" : "primitives of lines");
            return;
        }
        Json position = primitive.get("attributes").get("POSITION");
        if (!position.isThere()) {
            notes.add("primitives without positions, or in a compressed form");
            return;
        }
        // Read first: from here on there are as many vertices as it says.
        int vertices = all(position, 3).length / 3;
        Json indices = primitive.get("indices");
        int[] triangles = triangles(mode, indices.isThere() ? accessors.indices(indices, vertices) : null, vertices);
        if (triangles.length == 0) {
            notes.add("primitives without triangles");
            return;
        }
        if (parts.size() == MeshLimits.PARTS) {
            throw primitive.problem("a file must have at most " + MeshLimits.PARTS + " primitives");
        }
        Json material = primitive.get("material");
        int number = material.isThere() ? material.index(file.array("materials")) : -1;
        String look = number < 0 ? "" : file.array("materials").at(number).get("name").text().orElse("");
        String wanted = several && !look.isEmpty() ? (name.isEmpty() ? look : name + " (" + look + ")") : name;
        Mesh made = mesh(primitive, triangles, vertices, number);
        parts.add(new GltfPart(mesh, names.unique(wanted, "mesh"), number, made));
    }

    private static int[] triangles(int mode, int[] indices, int vertices) {
        int corners = indices == null ? vertices : indices.length;
        int count = mode == TRIANGLES ? corners / 3 : Math.max(0, corners - 2);
        int[] triangles = new int[3 * Math.min(count, MeshLimits.TRIANGLES)];
        for (int t = 0; t < triangles.length / 3; t++) {
            // glTF 2.0, §3.7.2.1.
            int a = mode == TRIANGLES ? 3 * t : mode == FAN ? t + 1 : t;
            int b = mode == TRIANGLES ? 3 * t + 1 : mode == FAN ? t + 2 : t + 1 + t % 2;
            int c = mode == TRIANGLES ? 3 * t + 2 : mode == FAN ? 0 : t + 2 - t % 2;
            triangles[3 * t] = indices == null ? a : indices[a];
            triangles[3 * t + 1] = indices == null ? b : indices[b];
            triangles[3 * t + 2] = indices == null ? c : indices[c];
        }
        return triangles;
    }

    private Mesh mesh(Json primitive, int[] triangles, int vertices, int material) throws IOException, MeshException {
        Json attributes = primitive.get("attributes");
        TextureCoordinates texture = TextureCoordinates.of(file, material);
        int[] used = compact(triangles, vertices);
        Json uv = attributes.get("TEXCOORD_" + texture.set());
        take(triangles.length + (long) used.length * (3 + (attributes.get("NORMAL").isThere() ? 3 : 0) + (uv.isThere() ? 2 : 0)
                + (attributes.get("COLOR_0").isThere() ? 3 : 0) + (hasTangents(attributes) ? 4 : 0)), primitive);
        float[] positions = picked(attributes.get("POSITION"), 3, vertices, used);
        float[] normals = picked(attributes.get("NORMAL"), 3, vertices, used);
        float[] coordinates = picked(uv, 2, vertices, used);
        float[] colors = picked(attributes.get("COLOR_0"), 3, vertices, used);
        float[] tangents = hasTangents(attributes) ? picked(attributes.get("TANGENT"), 4, vertices, used) : null;
        if (tangents != null) {
            Tangents.makeUnit(tangents, notes);
        }
        if (colors != null) {
            VertexColors.cut(colors, used.length, notes);
        }
        tell(primitive, texture.set());
        if (normals != null) {
            Normals.makeUnit(normals, positions, triangles);
        }
        if (coordinates != null) {
            texture.apply(coordinates);
        }
        try {
            return new Mesh(positions, triangles, normals, coordinates, colors, tangents);
        } catch (IllegalArgumentException e) {
            throw primitive.problem(e.getMessage());
        }
    }

    /** Reckons with so many numbers more. */
    private void take(long numbers, Json primitive) throws MeshException {
        bytes += 4 * numbers;
        unfolding.checkBytes(bytes, primitive);
        if (bytes > Memory.available() / 2) {
            throw primitive.problem("the meshes up to here take " + (bytes >> 20) + " MiB, more than half of the memory that there is");
        }
    }

    private void tell(Json primitive, int set) throws MeshException {
        boolean tangents = hasTangents(primitive.get("attributes"));
        primitive.get("attributes").node().propertyNames().forEach(name -> {
            if (!name.equals("POSITION") && !name.equals("NORMAL") && !name.equals("COLOR_0") && !name.equals("TEXCOORD_" + set)
                    && !(tangents && name.equals("TANGENT"))) {
                notes.add("attributes " + name + " of primitives");
            }
        });
        if (primitive.get("targets").isThere()) {
            notes.add("primitives with morph targets");
        }
    }

    /** Tangents without normals must be ignored: glTF 2.0, §3.7.2.1. */
    private static boolean hasTangents(Json attributes) throws MeshException {
        return attributes.get("TANGENT").isThere() && attributes.get("NORMAL").isThere();
    }

    /** Renumbers the vertices that are named, and tells which they were. */
    private int[] compact(int[] triangles, int vertices) {
        if (now.length < vertices) {
            now = new int[vertices];
            Arrays.fill(now, -1);
        }
        int[] used = new int[Math.min(vertices, triangles.length)];
        int count = 0;
        for (int i = 0; i < triangles.length; i++) {
            int v = triangles[i];
            if (now[v] < 0) {
                used[count] = v;
                now[v] = count++;
            }
            triangles[i] = now[v];
        }
        for (int i = 0; i < count; i++) {
            now[used[i]] = -1;
        }
        return Arrays.copyOf(used, count);
    }

    /** The numbers of the named vertices; null where there are none. */
    private float[] picked(Json accessor, int each, int vertices, int[] used) throws IOException, MeshException {
        if (!accessor.isThere()) {
            return null;
        }
        if (accessors.count(accessor) != vertices) {
            throw accessor.problem("must have as many as there are positions, " + vertices + ", has " + accessors.count(accessor));
        }
        float[] all = all(accessor, each);
        float[] some = new float[each * used.length];
        for (int i = 0; i < used.length; i++) {
            System.arraycopy(all, each * used[i], some, each * i, each);
        }
        return some;
    }

    /** All numbers of an accessor, read once. */
    private float[] all(Json accessor, int each) throws IOException, MeshException {
        String key = accessor.index(file.array("accessors")) + " " + each;
        float[] all = read.get(key);
        if (all == null) {
            all = accessors.floats(accessor, each);
            take(all.length, accessor);
            read.put(key, all);
        }
        return all;
    }
}
