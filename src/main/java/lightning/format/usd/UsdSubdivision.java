package lightning.format.usd;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Arrays;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.subdivision.ControlMesh;
import lightning.format.mesh.subdivision.RefinedMesh;
import lightning.format.mesh.subdivision.SubdivisionSurface;
import org.jspecify.annotations.Nullable;

/** Refinement of a stage's subdivision surfaces. */
public final class UsdSubdivision {
    /** Largest number of levels that can be asked for. */
    public static final int MAX_LEVELS = 4;
    /** Levels if not asked for. */
    public static final int DEFAULT_LEVELS = 2;
    /** Triangles of one refined mesh, beyond which it gets fewer levels. */
    static final long MESH_TRIANGLES = 1_000_000;
    /** Triangles of all refined meshes of a stage, beyond which all get fewer levels. */
    static final long STAGE_TRIANGLES = 8_000_000;
    private static final int POSITION = 3;
    private static final int QUAD = 4;

    private UsdSubdivision() {}

    /** Returns whether a mesh is a subdivision surface that can be refined. */
    public static boolean isSurface(JsonValue mesh) throws MeshException {
        return mesh.get("subdivision").isPresent();
    }

    /**
     * Returns the levels of each mesh: as many as requested, but so few that each mesh, and all together, stay within their budget.
     *
     * @param meshes all meshes of a stage
     */
    public static int[] levels(JsonValue meshes, int requested) throws MeshException {
        int[] levels = new int[meshes.size()];
        long[] corners = new long[levels.length];
        for (int i = 0; i < levels.length; i++) {
            if (isSurface(meshes.element(i))) {
                corners[i] = meshes.element(i).get("indices").element(1).integer(0, Integer.MAX_VALUE) / Integer.BYTES;
                levels[i] = requested;
                while (triangles(corners[i], levels[i]) > MESH_TRIANGLES) {
                    levels[i]--;
                }
            }
        }
        for (int most = requested; most > 0 && total(corners, levels) > STAGE_TRIANGLES; most--) {
            for (int i = 0; i < levels.length; i++) {
                levels[i] = Math.min(levels[i], most - 1);
            }
        }
        return levels;
    }

    private static long total(long[] corners, int[] levels) {
        long sum = 0;
        for (int i = 0; i < levels.length; i++) {
            sum += triangles(corners[i], levels[i]);
        }
        return sum;
    }

    /** Returns the triangles of a mesh with a number of corners; none at level 0, where it is not refined. */
    private static long triangles(long corners, int level) {
        return level == 0 ? 0 : 2 * corners << 2 * (level - 1);
    }

    /**
     * Returns the refined faces of a mesh.
     *
     * @param in description of the surface
     */
    static UsdFaces refine(UsdFaces faces, UsdStage stage, JsonValue in, int levels) throws IOException, MeshException {
        boolean hasSmoothCoordinates = faces.coordinates() != null && faces.coordinates().isSmooth();
        boolean hasSmoothColors = faces.colors() != null && faces.colors().isSmooth();
        int[] counts = Arrays.stream(faces.counts()).map(Math::abs).toArray();
        var points = new NumberColumns(faces.points().length / POSITION);
        points.add(POSITION, faces.points());
        int pointCoordinates = hasSmoothCoordinates ? points.add(requireNonNull(faces.coordinates()).ofPoints(points.rows())) : -1;
        int pointColors = hasSmoothColors ? points.add(requireNonNull(faces.colors()).ofPoints(points.rows())) : -1;
        var corners = new NumberColumns(faces.corners().length);
        int coordinates = faces.coordinates() == null || hasSmoothCoordinates ? -1
                : corners.add(faces.coordinates().ofCorners(counts, faces.corners()));
        int colors = faces.colors() == null || hasSmoothColors ? -1 : corners.add(faces.colors().ofCorners(counts, faces.corners()));
        var control = new ControlMesh(points.numbers(), points.stride(), counts, faces.corners());
        boolean[] isHole = sharpen(control, stage, in, faces.counts());
        RefinedMesh fine = SubdivisionSurface.refine(control, corners.numbers(), corners.stride(), levels);
        int[] fineCounts = new int[fine.origin().length];
        Arrays.setAll(fineCounts, face -> isHole[fine.origin()[face]] ? -QUAD : QUAD);
        return new UsdFaces(NumberColumns.column(fine.points(), points.stride(), 0, POSITION), fineCounts, fine.corners(),
                faces.isLeftHanded(),
                CornerValues.indexed(faces.isLeftHanded() ? negated(fine.normals()) : fine.normals(), POSITION, fine.normalOf()),
                values(fine, points, pointCoordinates, corners, coordinates, 2),
                values(fine, points, pointColors, corners, colors, 3), fine.origin());
    }

    /** Sets creases and corners; returns for each face if it is not drawn. */
    private static boolean[] sharpen(ControlMesh control, UsdStage stage, JsonValue in, int[] counts) throws IOException, MeshException {
        String boundary = in.get("boundary").text().orElse("");
        boolean[] isHole = boundary.equals("none") ? control.boundaryFaces(counts.length) : new boolean[counts.length];
        for (int face = 0; face < counts.length; face++) {
            isHole[face] |= counts[face] < 0;
        }
        if (!boundary.equals("none") && !boundary.equals("edgeOnly")) {
            control.sharpenBoundaryCorners();
        }
        int[] cornerPoints = stage.ints(in.get("cornerIndices"));
        float[] cornerSharpness = stage.floats(in.get("cornerSharpnesses"));
        for (int i = 0; i < Math.min(cornerPoints.length, cornerSharpness.length); i++) {
            if (control.hasPoint(cornerPoints[i])) {
                control.setCorner(cornerPoints[i], cornerSharpness[i]);
            }
        }
        int[] creases = stage.ints(in.get("creaseIndices"));
        int[] lengths = stage.ints(in.get("creaseLengths"));
        float[] sharpness = stage.floats(in.get("creaseSharpnesses"));
        boolean isForCreases = sharpness.length == lengths.length;
        for (int crease = 0, at = 0, edge = 0; crease < lengths.length; crease++, at++) {
            // The last point of a crease has no edge of its own.
            for (int i = 1; i < lengths[crease] && at + 1 < creases.length; i++, at++, edge++) {
                int value = isForCreases ? crease : edge;
                if (value < sharpness.length) {
                    control.setCrease(creases[at], creases[at + 1], sharpness[value]);
                }
            }
        }
        return isHole;
    }

    private static float[] negated(float[] values) {
        float[] result = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            result[i] = -values[i];
        }
        return result;
    }

    /** Returns a refined column of points or corners; null if there is none. */
    private static @Nullable CornerValues values(RefinedMesh fine, NumberColumns points, int pointColumn, NumberColumns corners,
            int cornerColumn, int width) {
        if (pointColumn >= 0) {
            return CornerValues.ofPoints(NumberColumns.column(fine.points(), points.stride(), pointColumn, width), width);
        }
        return cornerColumn < 0 ? null
                : CornerValues.ofCorners(NumberColumns.column(fine.cornerValues(), corners.stride(), cornerColumn, width), width);
    }
}
