package lightning.scene.asset;

/**
 * Limit between the smooth light of an environment map, which rays collect from all directions, and its small bright parts, which are
 * lights. Few of the rays of a gather point meet a sun, so its light would be noise.
 *
 * <p>A part of solid angle Ω takes n = 16 · 64 · Ω / π of the rays of a gather point and its neighbors, in strata. The relative error of its share
 * is about 0.8 n^(−3/4), because only strata at its rim are uncertain, or n^(−1/2) for less than one ray. The limit is the largest
 * radiance at which no brighter part of the remaining image adds more than {@value #NOISE} of all light as noise.
 */
final class BrightParts {
    private static final double NOISE = 0.02;
    private static final double RAYS_PER_STERADIAN = 16 * 64 / Math.PI;
    private static final int STEPS_PER_OCTAVE = 8;
    /** Steps from the brightest pixel down, over 32 octaves. */
    private static final int STEPS = 32 * STEPS_PER_OCTAVE;

    private BrightParts() {}

    /** Returns the luminance above which light belongs to bright parts. */
    static double limit(EnvironmentMap map) {
        double max = 0;
        for (int y = 0; y < map.height(); y++) {
            for (int x = 0; x < map.width(); x++) {
                max = Math.max(max, map.luminance(x, y));
            }
        }
        if (max == 0) {
            return 0;
        }
        double[] solidAngle = solidAngles(map, max);
        // The light below each step: the integral of the solid angles.
        double[] below = new double[STEPS];
        below[STEPS - 1] = level(max, STEPS - 1) * solidAngle[STEPS - 1];
        for (int i = STEPS - 2; i >= 0; i--) {
            below[i] = below[i + 1] + (level(max, i) - level(max, i + 1)) * solidAngle[i + 1];
        }
        int limit = 0;
        while (limit < STEPS - 1 && noise(limit, solidAngle, below) > NOISE) {
            limit++;
        }
        return level(max, limit);
    }

    private static double level(double max, int step) {
        return max * StrictMath.pow(2, -(double) step / STEPS_PER_OCTAVE);
    }

    /** Returns the solid angle that is brighter than each step. */
    private static double[] solidAngles(EnvironmentMap map, double max) {
        double[] solidAngle = new double[STEPS];
        for (int y = 0; y < map.height(); y++) {
            double ofPixel = map.solidAngle(y);
            for (int x = 0; x < map.width(); x++) {
                double luminance = map.luminance(x, y);
                if (luminance > 0) {
                    double octaves = StrictMath.log(max / luminance) / StrictMath.log(2);
                    int step = (int) Math.ceil(octaves * STEPS_PER_OCTAVE + 1e-9);
                    if (step < STEPS) {
                        solidAngle[step] += ofPixel;
                    }
                }
            }
        }
        for (int i = 1; i < STEPS; i++) {
            solidAngle[i] += solidAngle[i - 1];
        }
        return solidAngle;
    }

    /** Returns the noise of an image without what exceeds a step. */
    private static double noise(int limit, double[] solidAngle, double[] below) {
        double worst = 0;
        for (int i = limit + 1; i < STEPS; i++) {
            double rays = solidAngle[i] * RAYS_PER_STERADIAN;
            double error = rays < 1 ? 1 / Math.sqrt(Math.max(rays, 1e-6)) : 0.8 * StrictMath.pow(rays, -0.75);
            worst = Math.max(worst, (below[limit] - below[i]) / below[limit] * error);
        }
        return worst;
    }
}
