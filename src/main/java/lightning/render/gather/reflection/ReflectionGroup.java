package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.cell.TangentColumns;
import lightning.render.gather.point.PointGroups;
import lightning.render.lobe.RoughLobes;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Reflection points of one material. */
public final class ReflectionGroup {
    /** Number of each point among all. */
    public final int[] number;
    public final SurfaceColumns surface;
    public final float[] radius;
    /** Mirrored views. */
    final float[] rx;
    final float[] ry;
    final float[] rz;
    /** Roughness with its map. */
    final float[] roughness;
    private final TangentColumns tangents = new TangentColumns();
    /** Largest sine of the angle between tangents, 0…1. */
    private final double twist;
    /** Width of the cells of directions, about radians. */
    final float step;
    public final PointGroups groups;
    public final Material material;
    /** Lobes of the material; null if it does not blur reflections. */
    final @Nullable RoughLobes lobes;

    private ReflectionGroup(ReflectionPoints points, int[] number, float step, Material material) {
        this.material = material;
        lobes = RoughLobes.of(material);
        twist = lobes == null ? 1 : lobes.twist();
        this.number = number;
        this.step = step;
        surface = new SurfaceColumns(number.length);
        radius = new float[number.length];
        rx = new float[number.length];
        ry = new float[number.length];
        rz = new float[number.length];
        roughness = new float[number.length];
        for (int i = 0; i < number.length; i++) {
            int p = number[i];
            surface.add(points.surface(), p);
            radius[i] = points.radius[p];
            rx[i] = points.rx[p];
            ry[i] = points.ry[p];
            rz[i] = points.rz[p];
            roughness[i] = points.seen.roughness[p];
            tangents.set(i, points.seen.tangents, p);
        }
        groups = new PointGroups(surface, radius);
    }

    /**
     * Returns the groups by material.
     *
     * @param steps     width of the cells of directions by material; 0 for materials without reflection points
     * @param materials all materials
     */
    public static ReflectionGroup[] of(ReflectionPoints points, float[] steps, List<Material> materials) {
        int[][] numbers = new int[steps.length][];
        int[] count = new int[steps.length];
        for (int p = 0; p < points.count(); p++) {
            count[points.material[p]]++;
        }
        Arrays.setAll(numbers, m -> new int[count[m]]);
        Arrays.fill(count, 0);
        for (int p = 0; p < points.count(); p++) {
            numbers[points.material[p]][count[points.material[p]]++] = p;
        }
        ReflectionGroup[] groups = new ReflectionGroup[steps.length];
        Arrays.setAll(groups, m -> new ReflectionGroup(points, numbers[m], steps[m], materials.get(m)));
        return groups;
    }

    /** Returns the roughness of a row of a material, with its map. */
    public static float roughness(Material material, HitRows rows, int row) {
        return (float) (material.surfaceMaps().roughness().isEmpty() ? material.roughness()
                : material.mappedRoughness(requireNonNull(rows.texel(ColumnGroup.ROUGHNESS_TEXEL, 0))[row]));
    }

    /**
     * Returns the share of its weight that a point of an anisotropic material has at a place with another tangent: 1 for the same tangent, or none.
     *
     * @param tx tangent at the place, with {@code ty} and {@code tz}
     */
    public float alignment(int p, float tx, float ty, float tz) {
        if (tx == 0 && ty == 0 && tz == 0) {
            return 1;
        }
        double along = tx * tangents.x(p) + ty * tangents.y(p) + tz * tangents.z(p);
        double left = 1 - Math.sqrt(Math.max(0, 1 - along * along)) / twist;
        return left > 0 ? (float) (left * left) : 0;
    }

    /** Returns the share of its weight that point {@code q} has at the place of point {@code p}. */
    float alignment(int p, int q) {
        return alignment(q, tangents.x(p), tangents.y(p), tangents.z(p));
    }

    public int count() {
        return number.length;
    }
}
