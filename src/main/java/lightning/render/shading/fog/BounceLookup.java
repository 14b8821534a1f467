package lightning.render.shading.fog;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import org.jspecify.annotations.Nullable;

/**
 * Looks up the light of lamps in the fog along bounced rays, between the sampled rays around their places in the image. Of these 4×4 rays, those
 * count that bounced in the same way, with the weights of {@link FogSums}; and most those from the same material in a similar direction, so that edges
 * of mirrors and facets stay sharp. Casts no ray. Holds scratch memory: use one instance per thread.
 */
final class BounceLookup {
    /** Rays along a side of the filter. */
    private static final int SIDE = 4;
    private static final int NEIGHBORS = SIDE * SIDE;
    private static final int PLACES = FogGrid.SAMPLES * FogGrid.PHASES;
    /** Weight of a ray in another direction, and factor of one from another material: such a ray counts if there is no better one. */
    private static final double OTHER_WEIGHT = 1.0 / 64;
    /** Sum of weights below which light fades out. */
    private static final float MIN_WEIGHT = 1f / 8192;

    private final BounceRays rays;
    private final @Nullable FogLight[] lights;
    private final @Nullable FogSamples[] samples;
    private final FogPath path = new FogPath();
    private final FogRay sampled = new FogRay();
    /** Rays to look up: of some of the present rows. */
    private final FogRay[] lines = new FogRay[TermKernel.MAX_ROWS];
    private final double[] distance = new double[TermKernel.MAX_ROWS];
    /** Slots and weights of the sampled rays around each ray. */
    private final int[] neighbor = new int[NEIGHBORS * TermKernel.MAX_ROWS];
    private final float[] weight = new float[NEIGHBORS * TermKernel.MAX_ROWS];
    private int count;
    /** Slot of each sampled ray, −1 for none; and the ray of each slot with its direction. */
    private final int[] slot;
    private int[] slotRay = new int[0];
    private double[] slotX = new double[0];
    private double[] slotY = new double[0];
    private double[] slotZ = new double[0];
    private int slotCount;
    /** Sums of the samples before each one, by slot. */
    private float[] sums = new float[0];

    /** @param fog fog along bounced rays */
    BounceLookup(PictureFog fog) {
        rays = (BounceRays) fog.rays();
        lights = fog.lights();
        samples = new FogSamples[lights.length];
        slot = new int[rays.count()];
        Arrays.fill(slot, -1);
        Arrays.setAll(lines, _ -> new FogRay());
    }

    /** Removes all rays to look up. */
    void clear() {
        for (int s = 0; s < slotCount; s++) {
            slot[slotRay[s]] = -1;
        }
        slotCount = 0;
        count = 0;
    }

    /** Adds a ray that no light in fog is seen along. */
    void addNone() {
        distance[count] = -1;
        count++;
    }

    /** Returns the ray to set before it is added. */
    FogRay next() {
        return lines[count];
    }

    /**
     * Adds the ray that was set.
     *
     * @param x      image coordinates of the pixel or sample that shows it, as {@code y}
     * @param onPath its path, as in {@link BounceRays}
     * @param material index of the material from which it bounces
     * @param length distance of what it hits; infinite for none
     */
    void add(double x, double y, int onPath, int material, double length) {
        FogRay line = lines[count];
        FogGrid grid = rays.grid();
        int column = Math.clamp((int) grid.position(x), 1, grid.columns() - 3);
        int row = Math.clamp((int) grid.position(y), 1, grid.lines() - 3);
        double u = Math.clamp(grid.position(x) - column, 0, 1);
        double v = Math.clamp(grid.position(y) - row, 0, 1);
        for (int n = 0; n < NEIGHBORS; n++) {
            int at = NEIGHBORS * count + n;
            int ray = rays.ray((row + n / SIDE - 1) * grid.columns() + column + n % SIDE - 1, onPath);
            weight[at] = 0;
            if (ray >= 0) {
                int s = slot(ray);
                double cosine = line.dx * slotX[s] + line.dy * slotY[s] + line.dz * slotZ[s];
                double similar = similarity(cosine) * (rays.material()[ray] == material ? 1 : OTHER_WEIGHT);
                weight[at] = (float) (filter(n % SIDE, u) * filter(n / SIDE, v) * similar);
                neighbor[at] = s;
            }
        }
        distance[count] = length;
        count++;
    }

    /** Returns the weight of a ray at an angle: cos<sup>16</sup> of its half. */
    private static double similarity(double cosine) {
        double square = 0.5 + 0.5 * cosine;
        double fourth = square * square;
        double eighth = fourth * fourth;
        return Math.clamp(eighth * eighth, OTHER_WEIGHT, 1);
    }

    /** Returns the weight of a ray of four in a line: the mean of the filters 1, 2, 1 around the second and the third. */
    private static double filter(int i, double share) {
        return switch (i) {
            case 0 -> 0.25 * (1 - share);
            case 1 -> 0.5 * (1 - share) + 0.25 * share;
            case 2 -> 0.25 * (1 - share) + 0.5 * share;
            default -> 0.25 * share;
        };
    }

    private int slot(int ray) {
        if (slot[ray] < 0) {
            if (slotCount == slotRay.length) {
                int length = Math.max(256, 2 * slotCount);
                slotRay = Arrays.copyOf(slotRay, length);
                slotX = Arrays.copyOf(slotX, length);
                slotY = Arrays.copyOf(slotY, length);
                slotZ = Arrays.copyOf(slotZ, length);
            }
            rays.set(ray, sampled);
            slotRay[slotCount] = ray;
            slotX[slotCount] = sampled.dx;
            slotY[slotCount] = sampled.dy;
            slotZ[slotCount] = sampled.dz;
            slot[ray] = slotCount++;
        }
        return slot[ray];
    }

    /** Returns the light in the fog of each light that shines in it; null for others. */
    @Nullable
    FogLight[] sources(WeightedLight[] of) {
        @Nullable
        FogLight[] sources = new FogLight[of.length];
        Arrays.setAll(sources, l -> of[l].isDarkInFog() ? null : lights[l]);
        return sources;
    }

    /**
     * Looks up the light of a light of weight 1 along the rays that were added.
     *
     * @param l index of the light
     * @return light by ray: {@code float[rays]}; null if it is dark there
     */
    float @Nullable [] lookUp(int l, WeightedLight of) {
        FogLight light = requireNonNull(lights[l]);
        if (!setSums(light)) {
            return null;
        }
        float[] column = new float[count];
        lookUp(samples(l, of), light, column);
        return column;
    }

    /** Sums the samples of the rays in all slots; returns false if none has light. */
    private boolean setSums(FogLight light) {
        boolean any = false;
        for (int s = 0; s < slotCount; s++) {
            any |= light.shines(slotRay[s]);
        }
        if (!any) {
            return false;
        }
        int stride = FogGrid.SAMPLES + 1;
        if (sums.length < slotCount * stride) {
            sums = new float[slotRay.length * stride];
        }
        float[] parts = light.parts();
        for (int s = 0; s < slotCount; s++) {
            sums[s * stride] = 0;
            for (int k = 0; k < FogGrid.SAMPLES; k++) {
                sums[s * stride + k + 1] = sums[s * stride + k] + parts[slotRay[s] * FogGrid.SAMPLES + k];
            }
        }
        return true;
    }

    private FogSamples samples(int l, WeightedLight light) {
        FogSamples known = samples[l];
        if (known == null) {
            known = new FogSamples(rays.grid().scale(), light.source());
            samples[l] = known;
        }
        return known;
    }

    private void lookUp(FogSamples of, FogLight light, float[] to) {
        for (int i = 0; i < count; i++) {
            if (distance[i] < 0) {
                continue;
            }
            double counted = -1;
            float sum = 0;
            float weights = 0;
            for (int n = NEIGHBORS * i; n < NEIGHBORS * (i + 1); n++) {
                weights += weight[n];
                if (weight[n] != 0 && light.shines(slotRay[neighbor[n]])) {
                    if (counted < 0) {
                        of.aim(path, lines[i]);
                        double place = path.place(distance[i]);
                        counted = place >= 1 ? PLACES : Math.max(0, place * PLACES - 0.5);
                    }
                    sum += weight[n] * before(neighbor[n], counted);
                }
            }
            to[i] = sum / Math.max(weights, MIN_WEIGHT);
        }
    }

    /**
     * Returns the light of the samples of a sampled ray that count. As in {@link FogSums}, a sample counts once it is before a surface, and fully a
     * 128th of all places later.
     *
     * @param counted place of the surface, in 128ths of all places, less one half
     */
    private float before(int of, double counted) {
        double rest = counted - rays.phase(slotRay[of]);
        int full = Math.clamp((int) Math.floor((rest + FogGrid.PHASES - 1) / FogGrid.PHASES), 0, FogGrid.SAMPLES);
        int at = of * (FogGrid.SAMPLES + 1) + full;
        if (full == FogGrid.SAMPLES) {
            return sums[at];
        }
        float share = (float) Math.clamp(rest - FogGrid.PHASES * full, 0, 1);
        return sums[at] + (sums[at + 1] - sums[at]) * share;
    }
}
