package lightning.render.fog;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Rays along which fog is seen in mirrors and through clear surfaces: those that bounce from what the rays of a {@link FogGrid} hit. A ray of the
 * grid has one that is mirrored at the first surface (path 0), and one for each number of refractions in a row (path n) after which it is in the
 * air. Immutable.
 *
 * @param gridRay  ray of the grid that each ray starts from: {@code int[rays]}; must not be modified
 * @param path     path of each ray: {@code int[rays]}; must not be modified
 * @param material index of the material from which each ray bounces: {@code int[rays]}; must not be modified
 * @param lines    origin and direction of each ray, ox, oy, oz, dx, dy, dz: {@code float[6][rays]}; directions have nearly length 1; must not
 *                 be modified
 * @param index    ray by path and ray of the grid, −1 for none; null for paths without a ray
 */
public record BounceRays(FogGrid grid, int[] gridRay, int[] path, int[] material, float[][] lines, int[] @Nullable [] index)
        implements FogRays {
    /** Bytes of a ray, without its place in the index. */
    public static final int BYTES = 3 * Integer.BYTES + 6 * Float.BYTES;
    /** Path of the ray that is mirrored at the first surface; path n is refracted n times. */
    public static final int MIRRORED = 0;

    public BounceRays(FogGrid grid, int[] gridRay, int[] path, int[] material, float[][] lines) {
        this(grid, gridRay, path, material, lines, index(grid, gridRay, path));
    }

    private static int[] @Nullable [] index(FogGrid grid, int[] gridRay, int[] path) {
        int[] @Nullable [] index = new int[1 + Arrays.stream(path).max().orElse(0)][];
        for (int i = 0; i < path.length; i++) {
            int[] rays = index[path[i]];
            if (rays == null) {
                rays = new int[grid.count()];
                Arrays.fill(rays, -1);
                index[path[i]] = rays;
            }
            rays[gridRay[i]] = i;
        }
        return index;
    }

    @Override
    public int count() {
        return path.length;
    }

    /** Returns the ray of a path that starts from a ray of the grid; −1 for none. */
    public int ray(int fromGrid, int onPath) {
        int[] rays = onPath < index.length ? index[onPath] : null;
        return rays == null ? -1 : rays[fromGrid];
    }

    @Override
    public void set(int ray, FogRay to) {
        to.ox = lines[0][ray];
        to.oy = lines[1][ray];
        to.oz = lines[2][ray];
        double x = lines[3][ray];
        double y = lines[4][ray];
        double z = lines[5][ray];
        double length = Math.sqrt(x * x + y * y + z * z);
        to.dx = x / length;
        to.dy = y / length;
        to.dz = z / length;
        to.phase = phase(ray);
    }

    /** Returns the phase of a ray, 0…3. */
    public int phase(int ray) {
        return grid.phase(gridRay[ray]);
    }

    @Override
    public int groupCount() {
        return (count() + GROUP - 1) / GROUP;
    }

    @Override
    public int writeGroup(int group, int[] to) {
        int rays = Math.min(GROUP, count() - group * GROUP);
        for (int i = 0; i < rays; i++) {
            to[i] = group * GROUP + i;
        }
        return rays;
    }

    /** Returns whether both are the same rays. */
    public boolean areSame(BounceRays o) {
        return Arrays.equals(gridRay, o.gridRay) && Arrays.equals(path, o.path) && Arrays.equals(material, o.material)
                && Arrays.deepEquals(lines, o.lines);
    }

    /** Returns the same ray among others: with its path, origin and direction; −1 for none. */
    public int find(int ray, BounceRays others) {
        int found = others.ray(gridRay[ray], path[ray]);
        for (int c = 0; c < lines.length && found >= 0; c++) {
            found = lines[c][ray] == others.lines[c][found] ? found : -1;
        }
        return found;
    }

    /** Returns the bytes of all arrays. */
    public long bytes() {
        return (long) BYTES * count() + Arrays.stream(index).mapToLong(rays -> rays == null ? 0 : 4L * rays.length).sum();
    }
}
