package lightning.format.usd;

import java.io.IOException;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import org.jspecify.annotations.Nullable;

/**
 * Polygons of a stage's mesh.
 *
 * @param points       x, y, z of each point
 * @param counts       corners of each face; negative for holes, which keep the corners in place
 * @param corners      point of each corner, face by face
 * @param isLeftHanded true if faces are clockwise
 * @param normals      null if absent
 * @param coordinates  texture coordinates; null if absent
 * @param colors       null if absent
 * @param origin       face of the stage's mesh that each face is a part of; null if they are the same
 */
record UsdFaces(float[] points, int[] counts, int[] corners, boolean isLeftHanded, @Nullable CornerValues normals,
        @Nullable CornerValues coordinates, @Nullable CornerValues colors, int @Nullable [] origin) {
    static UsdFaces read(UsdStage stage, JsonValue in) throws IOException, MeshException {
        float[] points = stage.floats(in.get("points"));
        int[] counts = stage.ints(in.get("counts"));
        int[] corners = stage.ints(in.get("indices"));
        check(in, points, counts, corners);
        int pointCount = points.length / 3;
        CornerValues normals = CornerValues.read(stage, in.get("normals"), 3, counts.length, pointCount, corners.length);
        CornerValues coordinates = CornerValues.read(stage, in.get("uv"), 2, counts.length, pointCount, corners.length);
        CornerValues colors = CornerValues.read(stage, in.get("colors"), 3, counts.length, pointCount, corners.length);
        for (int hole : stage.ints(in.get("holes"))) {
            if (hole >= 0 && hole < counts.length) {
                counts[hole] = -Math.abs(counts[hole]);
            }
        }
        return new UsdFaces(points, counts, corners, in.get("left").bool(false), normals, coordinates, colors, null);
    }

    private static void check(JsonValue in, float[] points, int[] counts, int[] corners) throws MeshException {
        long sum = 0;
        for (int count : counts) {
            if (count < 0) {
                throw in.problem("must have faces of at least 0 corners, was " + count);
            }
            sum += count;
        }
        if (sum != corners.length || points.length % 3 != 0) {
            throw in.problem("must have " + sum + " corners by its faces, has " + corners.length);
        }
        for (int corner : corners) {
            if (corner < 0 || corner >= points.length / 3) {
                throw in.problem("must have corners from 0 to " + (points.length / 3 - 1) + ", was " + corner);
            }
        }
    }

    /** Returns the part of a face from the parts of the stage's faces. */
    int part(int[] parts, int face) {
        return parts[origin == null ? face : origin[face]];
    }
}
