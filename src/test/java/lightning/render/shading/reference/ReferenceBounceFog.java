package lightning.render.shading.reference;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.shading.FilmParts;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.value.Fog;

/** Fog along reflected and refracted rays, one after the other: each ray that bounces from the grid is computed when it is needed. */
final class ReferenceBounceFog {
    private final FogGrid grid;
    private final Fog fog;
    private final int depth;
    private final FilmParts parts;
    private final WeightedLight[] lights;
    private final ReferenceFog.Visibility visibility;
    private final ReferenceFogSamples samples;
    private final Map<Long, Optional<NearRay>> rays = new HashMap<>();
    /** Sums of the samples before each one, by ray and light. */
    private final Map<Long, float[]> sums = new HashMap<>();

    /** Ray that bounces from the grid, and the material from which it bounces. */
    private record NearRay(Ray ray, Material from) {}

    ReferenceBounceFog(FilmParts parts, ReferenceFog.Visibility visibility) {
        Scene scene = parts.scene();
        this.parts = parts;
        grid = new FogGrid(scene.camera(), scene.picture());
        fog = scene.world().fog();
        depth = scene.picture().depth();
        lights = parts.lights();
        this.visibility = visibility;
        samples = new ReferenceFogSamples(scene, grid.scale(), visibility);
    }

    /**
     * Returns the color of what a bounced ray shows, behind fog.
     *
     * @param distance distance of what it hits; infinite for none
     * @param place    image coordinates; null if it shows no light in fog
     * @param path     number of refractions; 0 for a ray that is mirrored at the first surface
     * @param material name of the material from which it bounces
     */
    float[] color(Ray ray, float[] color, double distance, double[] place, int path, String material) {
        float passed = (float) samples.transmittance(ray, distance);
        float[] ofLight = new float[lights.length];
        for (int l = 0; l < lights.length && place != null; l++) {
            if (!lights[l].isDarkInFog()) {
                ofLight[l] = light(l, ray, distance, place, path, material);
            }
        }
        return ReferenceFog.behind(parts, color, passed, ofLight);
    }

    /** Returns the mean of what the 4×4 rays around a place see, in the filter 1, 2, 1 between the two next to it, by material and direction. */
    private float light(int l, Ray ray, double distance, double[] place, int path, String material) {
        double column = place[0] / grid.step() + 1;
        double line = place[1] / grid.step() + 1;
        int left = Math.min(Math.max((int) column, 1), grid.columns() - 3) - 1;
        int top = Math.min(Math.max((int) line, 1), grid.lines() - 3) - 1;
        double[] across = filter(Math.min(Math.max(column - left - 1, 0), 1));
        double[] down = filter(Math.min(Math.max(line - top - 1, 0), 1));
        double end = samples.path(lights[l].source(), ray).place(distance);
        double counted = end >= 1 ? FogGrid.SAMPLES * FogGrid.PHASES : Math.max(0, end * (FogGrid.SAMPLES * FogGrid.PHASES) - 0.5);
        float sum = 0;
        float weights = 0;
        for (int y = 0; y < 4; y++) {
            for (int x = 0; x < 4; x++) {
                int from = (top + y) * grid.columns() + left + x;
                NearRay near = ray(from, path);
                if (near != null) {
                    Vec3 a = ray.direction();
                    Vec3 b = near.ray.direction();
                    double cosine = a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
                    double square = 0.5 + 0.5 * cosine;
                    double fourth = square * square;
                    double similar = Math.min(Math.max(fourth * fourth * (fourth * fourth), 1.0 / 64), 1);
                    similar *= near.from.name().equals(material) ? 1 : 1.0 / 64;
                    float weight = (float) (across[x] * down[y] * similar);
                    weights += weight;
                    sum += weight * before(l, from, path, near.ray, counted);
                }
            }
        }
        return sum / Math.max(weights, 1f / 8192);
    }

    private static double[] filter(double u) {
        return new double[] {0.25 * (1 - u), 0.5 * (1 - u) + 0.25 * u, 0.25 * (1 - u) + 0.5 * u, 0.25 * u};
    }

    /** Returns the light of the samples along a ray that are before a place: each counts fully once it is four numbers of samples before. */
    private float before(int l, int from, int path, Ray ray, double counted) {
        float[] sum = sums.computeIfAbsent(key(from, path) * lights.length + l, _ -> sums(l, ray, grid.phase(from)));
        double rest = counted - grid.phase(from);
        int k = 0;
        while (k < FogGrid.SAMPLES && rest - FogGrid.PHASES * k >= 1) {
            k++;
        }
        if (k == FogGrid.SAMPLES) {
            return sum[k];
        }
        float share = (float) Math.min(Math.max(rest - FogGrid.PHASES * k, 0), 1);
        return sum[k] + (sum[k + 1] - sum[k]) * share;
    }

    private float[] sums(int l, Ray ray, int phase) {
        float[] parts = samples.parts(lights[l].source(), ray, phase);
        float[] sum = new float[parts.length + 1];
        for (int k = 0; k < parts.length; k++) {
            sum[k + 1] = sum[k] + parts[k];
        }
        return sum;
    }

    private long key(int from, int path) {
        return (long) path * grid.count() + from;
    }

    /** Returns the ray of a path that starts from a ray of the grid; null if there is none in the air. */
    private NearRay ray(int from, int path) {
        return rays.computeIfAbsent(key(from, path), _ -> Optional.ofNullable(trace(from, path))).orElse(null);
    }

    private NearRay trace(int from, int path) {
        double[] dx = new double[1];
        double[] dy = new double[1];
        double[] dz = new double[1];
        grid.writeDirection(grid.step() * (from % grid.columns() - 1), grid.step() * (from / grid.columns() - 1), dx, dy, dz, 0);
        Ray ray = new Ray(grid.eye(), new Vec3(dx[0], dy[0], dz[0]));
        SurfacePoint hit = visibility.surface(ray);
        Material material = hit == null ? null : visibility.material(hit);
        if (material == null || depth == 0 || path > depth) {
            return null;
        }
        if (path == 0) {
            boolean mirrors = material.isClear() ? !hit.backSide().isInside() : material.isMirror();
            return mirrors ? new NearRay(rounded(hit.reflectedRay(material)), material) : null;
        }
        for (int n = 1; n <= path; n++) {
            if (hit == null || !visibility.material(hit).isClear()) {
                return null;
            }
            ray = hit.refractedRay();
            if (ray == null) {
                return null;
            }
            boolean isInAir = hit.backSide().isInside() || hit.backSide().transmission().thin();
            if (n == path) {
                return isInAir ? new NearRay(rounded(ray), visibility.material(hit)) : null;
            }
            hit = visibility.surface(ray);
        }
        return null;
    }

    /** Returns a ray with the accuracy in which rays are stored. */
    private static Ray rounded(Ray ray) {
        Vec3 o = ray.origin();
        double x = (float) ray.direction().x();
        double y = (float) ray.direction().y();
        double z = (float) ray.direction().z();
        double length = Math.sqrt(x * x + y * y + z * z);
        return new Ray(new Vec3((float) o.x(), (float) o.y(), (float) o.z()), new Vec3(x / length, y / length, z / length));
    }
}
