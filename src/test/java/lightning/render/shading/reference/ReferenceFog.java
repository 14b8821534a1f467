package lightning.render.shading.reference;

import java.util.HashMap;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightWeight;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.FogComposer;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.value.Fog;

/**
 * Fog before a surface, one camera ray after the other: each ray of the grid and each of its samples is computed when it is needed, and shadow
 * rays test every shape.
 */
final class ReferenceFog {
    /** Test of whether a light, or one sample of an area light, is visible from a point in render space. */
    interface Visibility {
        boolean isVisible(LightSource source, Vec3 point);

        /** Returns the first surface along a ray; null for none. */
        SurfacePoint surface(Ray ray);

        /** Returns the material of a surface. */
        Material material(SurfacePoint hit);
    }

    private final FogGrid grid;
    private final FogMedium medium;
    private final Fog fog;
    private final FilmParts parts;
    private final WeightedLight[] lights;
    private final ReferenceFogSamples samples;
    /** Light of the parts of each ray, by light and ray. */
    private final Map<Long, float[]> scattered = new HashMap<>();
    private final Map<Long, float[]> sums = new HashMap<>();

    ReferenceFog(FilmParts parts, Visibility visibility) {
        Scene scene = parts.scene();
        this.parts = parts;
        grid = new FogGrid(scene.camera(), scene.picture());
        medium = FogMedium.of(scene);
        fog = scene.world().fog();
        lights = parts.lights();
        samples = new ReferenceFogSamples(scene, grid.scale(), visibility);
    }

    /**
     * Returns the color of a surface behind fog.
     *
     * @param x        image coordinates, pixels from the left and the top
     * @param distance distance of the surface; infinite for none
     */
    float[] color(float[] surface, double x, double y, double distance) {
        Vec3 d = direction(x, y);
        Vec3 eye = grid.eye();
        float passed =
                (float) FogMedium.transmittance(medium.depth(eye.x(), eye.y(), eye.z(), d.x(), d.y(), d.z(), distance));
        float[] ofLight = new float[lights.length];
        for (int l = 0; l < lights.length; l++) {
            if (!lights[l].isDarkInFog()) {
                ofLight[l] = before(l, x, y, samples.path(lights[l].source(), new Ray(eye, d)).place(distance));
            }
        }
        return behind(parts, surface, passed, ofLight);
    }

    /**
     * Returns the films of a surface behind fog.
     *
     * @param ofLight light of each lamp of weight 1 in white fog
     */
    static float[] behind(FilmParts parts, float[] surface, float passed, float[] ofLight) {
        Fog fog = parts.scene().world().fog();
        float[] films = new float[surface.length];
        for (int channel = 0; channel < films.length; channel++) {
            int c = channel % 3;
            FilmPart part = channel / 3 < parts.count() ? parts.get(channel / 3) : null;
            float scattered = 0;
            for (int l = part == null ? 0 : part.from(); part != null && l < part.to(); l++) {
                scattered += parts.lights()[l].fog().channel(c) * ofLight[l];
            }
            boolean isRest = part != null && part.kind() == FilmPart.Kind.REST;
            films[channel] = FogComposer.color(surface[channel], passed, LightWeight.channel(fog.color(), c),
                    isRest ? LightWeight.channel(fog.ambient(), c) : 0, scattered);
        }
        return films;
    }

    private Vec3 direction(double x, double y) {
        double[] dx = new double[1];
        double[] dy = new double[1];
        double[] dz = new double[1];
        grid.writeDirection(x, y, dx, dy, dz, 0);
        return new Vec3(dx[0], dy[0], dz[0]);
    }

    /** Returns the light before a place, between the four rays around a point of the image. */
    private float before(int light, double x, double y, double place) {
        double column = x / grid.step() + 1;
        double line = y / grid.step() + 1;
        int c = Math.min(Math.max((int) column, 1), grid.columns() - 3);
        int r = Math.min(Math.max((int) line, 1), grid.lines() - 3);
        float u = (float) Math.min(Math.max(column - c, 0), 1);
        float v = (float) Math.min(Math.max(line - r, 0), 1);
        float top = before(light, c, r, place) * (1 - u) + before(light, c + 1, r, place) * u;
        float bottom = before(light, c, r + 1, place) * (1 - u) + before(light, c + 1, r + 1, place) * u;
        return top * (1 - v) + bottom * v;
    }

    private float before(int light, int column, int line, double place) {
        float[] sum = sums.computeIfAbsent(key(light, column, line), _ -> sums(light, column, line));
        int places = FogGrid.SAMPLES * FogGrid.PHASES;
        double counted = place >= 1 ? places : Math.max(0, place * places - 0.5);
        int k = Math.min((int) counted, places - 1);
        float share = (float) (counted - k);
        return sum[k] * (1 - share) + sum[k + 1] * share;
    }

    private long key(int light, int column, int line) {
        return ((long) light * grid.lines() + line) * grid.columns() + column;
    }

    /** Returns the sums before each place, of the samples of 3×3 rays with weights 1, 2, 1. */
    private float[] sums(int light, int column, int line) {
        float[] sum = new float[FogGrid.SAMPLES * FogGrid.PHASES + 1];
        for (int y = line - 1; y <= line + 1; y++) {
            for (int x = column - 1; x <= column + 1; x++) {
                float weight = (x == column ? 0.5f : 0.25f) * (y == line ? 0.5f : 0.25f);
                for (int k = 0; k < FogGrid.SAMPLES; k++) {
                    sum[1 + FogGrid.PHASES * k + grid.phase(y * grid.columns() + x)] += weight * parts(light, x, y)[k];
                }
            }
        }
        for (int i = 1; i < sum.length; i++) {
            sum[i] += sum[i - 1];
        }
        return sum;
    }

    private float[] parts(int light, int column, int line) {
        return scattered.computeIfAbsent(key(light, column, line), _ -> traceParts(light, column, line));
    }

    private float[] traceParts(int light, int column, int line) {
        Vec3 d = direction(grid.step() * (column - 1), grid.step() * (line - 1));
        return samples.parts(lights[light].source(), new Ray(grid.eye(), d), grid.phase(line * grid.columns() + column));
    }

    /** Returns the distance of a surface from the eye. */
    double distance(float x, float y, float z) {
        double dx = x - grid.eye().x();
        double dy = y - grid.eye().y();
        double dz = z - grid.eye().z();
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }
}
