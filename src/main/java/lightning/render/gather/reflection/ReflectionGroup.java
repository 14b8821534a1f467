package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.point.PointGroups;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.material.Material;

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
    /** Width of the cells of directions, about radians. */
    final float step;
    public final PointGroups groups;
    public final Material material;

    private ReflectionGroup(ReflectionPoints points, int[] number, float step, Material material) {
        this.material = material;
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

    public int count() {
        return number.length;
    }
}
