package lightning.render.shading.fog;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogRay;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Traces the rays of a grid and makes the rays that bounce from what they hit, as far as they are in the air. Runs on all threads. */
public record BounceTracer(FogGrid grid, Geometry geometry, int depth) {
    /** Returns the maximum number of bounced rays for each ray of the grid. */
    static long maxPaths(Scene scene) {
        int depth = scene.picture().depth();
        return depth == 0 || scene.materials().stream().noneMatch(Material::spawnsSecondaryRays) ? 0
                : 1 + (scene.materials().stream().anyMatch(Material::isClear) ? depth : 0);
    }

    private static boolean bounces(MaterialTable materials) {
        return IntStream.range(0, materials.count()).anyMatch(m -> materials.material(m).spawnsSecondaryRays());
    }

    /**
     * Returns whether rays bounce from surfaces of other materials in the same way. Those of geometry that cannot serve both scenes may differ
     * nevertheless.
     */
    public static boolean haveSameBounces(MaterialTable a, MaterialTable b) {
        boolean same = a.count() == b.count();
        for (int m = 0; m < a.count() && same && a != b; m++) {
            same = a.material(m) == b.material(m) || a.material(m).isClear() == b.material(m).isClear()
                    && a.material(m).spawnsSecondaryRays() == b.material(m).spawnsSecondaryRays()
                    && a.material(m).coatNormals().mirrors() == b.material(m).coatNormals().mirrors();
        }
        return same;
    }

    /**
     * Traces the rays of a scene.
     *
     * @param geometry geometry with the scene's materials
     * @return null if no material mirrors or is clear
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public static @Nullable BounceRays trace(FogGrid grid, Geometry geometry, Scene scene, WorkerPool workers, Progress progress) {
        if (scene.picture().depth() == 0 || !bounces(geometry.materials())) {
            return null;
        }
        var tracer = new BounceTracer(grid, geometry, scene.picture().depth());
        Found[] found = new Found[grid.groupCount()];
        workers.run(found.length, (_, group) -> found[group] = tracer.trace(group), progress.cancellationOnly());
        return join(grid, found, Arrays.stream(found).mapToInt(f -> f.count).sum());
    }

    private static BounceRays join(FogGrid grid, Found[] found, int count) {
        int[] gridRay = new int[count];
        int[] path = new int[count];
        int[] material = new int[count];
        float[][] lines = new float[6][count];
        int at = 0;
        for (Found part : found) {
            System.arraycopy(part.gridRay, 0, gridRay, at, part.count);
            System.arraycopy(part.path, 0, path, at, part.count);
            System.arraycopy(part.material, 0, material, at, part.count);
            for (int c = 0; c < lines.length; c++) {
                System.arraycopy(part.lines[c], 0, lines[c], at, part.count);
            }
            at += part.count;
        }
        return new BounceRays(grid, gridRay, path, material, lines);
    }

    /** Rays that start from a group of the grid. */
    private static final class Found {
        private int[] gridRay = new int[16];
        private int[] path = new int[16];
        private int[] material = new int[16];
        private final float[][] lines = new float[6][16];
        private int count;

        void add(int from, int onPath, int ofMaterial, Ray ray) {
            if (count == path.length) {
                gridRay = Arrays.copyOf(gridRay, 2 * count);
                path = Arrays.copyOf(path, 2 * count);
                material = Arrays.copyOf(material, 2 * count);
                Arrays.setAll(lines, c -> Arrays.copyOf(lines[c], 2 * count));
            }
            gridRay[count] = from;
            path[count] = onPath;
            material[count] = ofMaterial;
            Vec3 o = ray.origin();
            Vec3 d = ray.direction();
            double[] line = {o.x(), o.y(), o.z(), d.x(), d.y(), d.z()};
            for (int c = 0; c < line.length; c++) {
                lines[c][count] = (float) line[c];
            }
            count++;
        }
    }

    private Found trace(int group) {
        Found found = new Found();
        int[] rays = new int[FogGrid.GROUP];
        int count = grid.writeGroup(group, rays);
        FogRay line = new FogRay();
        for (int i = 0; i < count; i++) {
            grid.set(rays[i], line);
            trace(rays[i], new Ray(new Vec3(line.ox, line.oy, line.oz), new Vec3(line.dx, line.dy, line.dz)), found);
        }
        return found;
    }

    private void trace(int from, Ray ray, Found found) {
        SurfacePoint hit = bouncingSurface(ray);
        if (hit == null) {
            return;
        }
        Material material = geometry.materials().material(hit.material());
        if (!material.isClear() || !isInside(hit)) {
            found.add(from, BounceRays.MIRRORED, hit.material(), hit.reflectedRay(material));
        }
        for (int n = 1; n <= depth && hit != null && hit.clearSide() != null; n++) {
            Ray through = hit.refractedRay();
            if (through == null) {
                return;
            }
            if (hit.isInAirBehind()) {
                found.add(from, n, hit.material(), through);
            }
            hit = n < depth ? bouncingSurface(through) : null;
        }
    }

    private static boolean isInside(SurfacePoint hit) {
        return requireNonNull(hit.clearSide()).isInside();
    }

    /** Returns the surface that a ray hits if other rays bounce from it; null otherwise. */
    private @Nullable SurfacePoint bouncingSurface(Ray ray) {
        int primitive = geometry.nearest(ray);
        return primitive >= 0 && geometry.material(primitive).spawnsSecondaryRays() ? geometry.surface(primitive, ray) : null;
    }
}
