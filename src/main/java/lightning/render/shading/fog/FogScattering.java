package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.fog.FogRays;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import org.jspecify.annotations.Nullable;

/**
 * Light that fog scatters toward the origin of a ray: single scattering of one light of weight 1 by white fog.
 *
 * <pre>
 * L = Σ lost · π·p(θ) · falloff · V
 * </pre>
 *
 * <p>The sum is over the parts of the ray, with one sample in each. {@code lost} is the share of the ray's light that a part absorbs, and in white
 * fog scatters from other directions: T(a) − T(b) for a part from a to b, so that no density is too large. The falloff of a light at a point
 * changes within a part about as the density of places does. So {@code lost} is the mean of density times transmittance, (T(a) − T(b))/(b − a), times
 * the length that the sample stands for, dt/du / n. In the last part, which has no end, it is their value at the sample.
 *
 * <p>The falloff contains the way through the fog from the light. A white surface reflects 1 under a light of weight 1, so its irradiance is π, and
 * the fog sends π·p of it per steradian, where p is the phase function of Henyey and Greenstein (Diffuse radiation in the galaxy, 1941):
 * π·p = ¼·(1 − g²)/(1 + g² − 2g·cosθ)<sup>3/2</sup>. θ is 0 where light keeps its direction.
 */
final class FogScattering {
    /** Length behind a surface, as a share of all places, in which samples do not count. */
    static final double HIDDEN = 1.0 / 16;

    private final FogRays rays;
    private final FogMedium medium;
    private final double anisotropy;
    private final FogSamples samples;
    private final FogPath path = new FogPath();
    private final ConeRange cone;
    /** By sample and phase; only the first for a light without an area. */
    private final @Nullable LightingEquation[] equations = new LightingEquation[FogGrid.SAMPLES * FogGrid.PHASES];
    /** Part whose transmittance at the start is known. */
    private int known;
    private double passed;
    /** Distance of that start. */
    private double start;
    private final FogRay ray = new FogRay();

    FogScattering(FogRays rays, FogMedium medium, double anisotropy, LightSource source) {
        this.rays = rays;
        this.medium = medium;
        this.anisotropy = anisotropy;
        samples = new FogSamples(rays.grid().scale(), source);
        cone = samples.coneRange();
    }

    private LightingEquation equation(int sample, int phase) {
        int i = samples.isPoint() ? 0 : FogGrid.PHASES * sample + phase;
        LightingEquation equation = equations[i];
        if (equation == null) {
            equation = new LightingEquation(samples.source(sample, phase));
            equations[i] = equation;
        }
        return equation;
    }

    /**
     * Writes the light of each part of a ray.
     *
     * @param visible samples that see the light
     * @param depth   distance of the ray's first surface
     * @param to      receives one value for each sample
     */
    void write(int index, int visible, float depth, float[] to, int at) {
        rays.set(index, ray);
        samples.aim(path, ray);
        int phase = ray.phase;
        double surface = path.place(depth);
        known = -1;
        cone.find(path, ray);
        Arrays.fill(to, at, at + FogGrid.SAMPLES, 0);
        for (int k = cone.from; k < cone.to; k++) {
            boolean counts = (visible >>> k & 1) != 0 && !isHidden(FogGrid.place(k, phase) - surface);
            to[at + k] = counts ? (float) scattered(k, phase) : 0;
        }
    }

    /**
     * Returns whether a sample is just behind the first surface along its ray, and may be in the light on the other side of a wall. Pixels
     * around the ray may see the wall a little farther away and would count the sample. Much deeper samples are behind an object, beside which other
     * pixels look into the depth, and count there.
     *
     * @param behind place of the sample less that of the surface
     */
    static boolean isHidden(double behind) {
        return behind > 0 && behind < HIDDEN;
    }

    private double transmittanceAt(double distance) {
        return FogMedium.transmittance(medium.depth(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, distance));
    }

    private double scattered(int sample, int phase) {
        double place = FogGrid.place(sample, phase);
        double t = path.distance(place);
        LightingEquation equation = equation(sample, phase);
        equation.moveTo((float) ray.x(t), (float) ray.y(t), (float) ray.z(t), (float) ray.dx, (float) ray.dy, (float) ray.dz);
        if (!equation.insideCone()) {
            return 0;
        }
        double from = known == sample ? start : path.distance((double) sample / FogGrid.SAMPLES);
        double before = known == sample ? passed : transmittanceAt(from);
        start = path.distance((sample + 1.0) / FogGrid.SAMPLES);
        passed = transmittanceAt(start);
        known = sample + 1;
        return before == 0 ? 0 : lost(sample, place, t, start - from, before - passed)
                * (equation.falloff() * phase(equation.towardLight(ray.dx, ray.dy, ray.dz)));
    }

    /** @param length length of the part @param ofPart what it takes */
    private double lost(int sample, double place, double t, double length, double ofPart) {
        if (!path.isPoint()) {
            return ofPart;
        }
        double stands = path.slope(place) / FogGrid.SAMPLES;
        if (sample == FogGrid.SAMPLES - 1) {
            return medium.densityAt(ray.x(t), ray.y(t), ray.z(t)) * transmittanceAt(t) * stands;
        }
        return length > 0 ? ofPart / length * stands : 0;
    }

    private double phase(double cosine) {
        double g = anisotropy;
        double square = 1 + g * g - 2 * g * cosine;
        return 0.25 * (1 - g * g) / (square * Math.sqrt(square));
    }
}
