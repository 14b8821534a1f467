package lightning.relight;

import lightning.cache.LayerStamp;
import lightning.cache.PixelCache;
import lightning.scene.Sampling;

/**
 * How far the film may be from the exact one: relative for each value, plus an absolute part.
 *
 * @param relative by which share of itself a value may be off
 * @param absolute by how much it may be off besides, linear
 * @param largest  the bound for the brightest value of the film, linear: no value is off by more
 */
record ErrorBound(double relative, double absolute, double largest) {
    private static final ErrorBound NONE = new ErrorBound(0, 0, 0);
    /** The largest slope of the display curve: sRGB near black. */
    private static final double STEEPEST = 12.92;
    /** The largest change of a displayed value for a relative change: x·d/dx of 1.055·x^(1/2.4), at 1. */
    private static final double RELATIVE_SLOPE = 1.055 / 2.4;
    /** Half an 8-bit step of the displayed value. */
    private static final double HALF_STEP = 0.5 / 255;

    static ErrorBound of(PixelCache cache) {
        if (cache == null) {
            return NONE;
        }
        LayerStamp[] top = cache.stamps();
        LayerStamp[] mirrors = cache.mirroredStamps();
        int depth = cache.mirroredScene().picture().depth();
        Sampling sampling = cache.scene().picture().sampling();
        int samples = sampling.isFine() ? sampling.perPixel() : 1;
        double relative = Math.max(RatioBound.relative(top, 0, samples), RatioBound.relative(mirrors, depth, samples));
        if (relative == 0) {
            return NONE;
        }
        double absolute = RatioBound.absolute(top, 1) + RatioBound.absolute(mirrors, depth);
        return new ErrorBound(relative, absolute, relative * cache.brightest() + absolute);
    }

    /** Whether an error of this size could change what is displayed at an exposure, in stops. */
    boolean shows(double exposure) {
        return RELATIVE_SLOPE * relative + STEEPEST * Math.pow(2, exposure) * absolute > HALF_STEP;
    }
}
