package lightning.render.shading.fog;

import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogPath;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import org.jspecify.annotations.Nullable;

/**
 * Light that fog scatters toward the camera along a ray: single scattering of one light of weight 1 by white fog.
 *
 * <pre>
 * L = Σ (T(a) − T(b)) · π·4p(θ)/4π … = Σ (T(a) − T(b)) · phase · falloff · V
 * </pre>
 *
 * <p>The sum is over the parts of the ray from a to b, each with one sample between. T(a) − T(b) is the share of the ray's light that is lost in a
 * part and, in white fog, scattered into it from elsewhere; no density is too large for it. The falloff contains the way through the
 * fog from the light. A white surface reflects 1 under a light of weight 1, so its irradiance is π, and the fog sends π·p of it per
 * steradian, where p is the phase function of Henyey and Greenstein (Diffuse radiation in the galaxy, 1941):
 * π·p = ¼·(1 − g²)/(1 + g² − 2g·cosθ)<sup>3/2</sup>. θ is 0 where light keeps its direction.
 */
final class FogScattering {
    private final FogGrid grid;
    private final FogMedium medium;
    private final double anisotropy;
    private final FogSamples samples;
    private final FogPath path = new FogPath();
    /** By sample and phase; only the first for a light without an area. */
    private final @Nullable LightingEquation[] equations = new LightingEquation[FogGrid.SAMPLES * FogGrid.PHASES];
    private final double[] dx = new double[1];
    private final double[] dy = new double[1];
    private final double[] dz = new double[1];

    FogScattering(FogGrid grid, FogMedium medium, double anisotropy, LightSource source) {
        this.grid = grid;
        this.medium = medium;
        this.anisotropy = anisotropy;
        samples = new FogSamples(grid, source);
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
     * @param to      receives one value for each sample
     */
    void write(int ray, int visible, float[] to, int at) {
        grid.writeDirection(ray, dx, dy, dz, 0);
        samples.aim(path, dx[0], dy[0], dz[0]);
        int phase = grid.phase(ray);
        int known = -1;
        double passed = 1;
        for (int k = 0; k < FogGrid.SAMPLES; k++) {
            if ((visible >>> k & 1) == 0) {
                to[at + k] = 0;
                continue;
            }
            double before = known == k ? passed : transmittance(k);
            passed = transmittance(k + 1);
            known = k + 1;
            to[at + k] = before == 0 ? 0 : (float) ((before - passed) * scattered(k, phase));
        }
    }

    /** Returns what passes from the start of a part to the eye. */
    private double transmittance(int part) {
        Vec3 eye = grid.eye();
        double distance = path.distance((double) part / FogGrid.SAMPLES);
        return FogMedium.transmittance(medium.depth(eye.x(), eye.y(), eye.z(), dx[0], dy[0], dz[0], distance));
    }

    private double scattered(int sample, int phase) {
        double t = path.distance(grid.place(sample, phase));
        float x = (float) (grid.eye().x() + t * dx[0]);
        float y = (float) (grid.eye().y() + t * dy[0]);
        float z = (float) (grid.eye().z() + t * dz[0]);
        LightingEquation equation = equation(sample, phase);
        equation.moveTo(x, y, z, (float) dx[0], (float) dy[0], (float) dz[0]);
        return equation.insideCone() ? equation.falloff() * phase(equation.towardLight(dx[0], dy[0], dz[0])) : 0;
    }

    private double phase(double cosine) {
        double g = anisotropy;
        double square = 1 + g * g - 2 * g * cosine;
        return 0.25 * (1 - g * g) / (square * Math.sqrt(square));
    }
}
