package lightning.render.relight.paper;

import java.util.List;
import lightning.render.cache.CachedLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.scene.SamplingSettings;

/**
 * How far the film may be from the exact one: relative for each value, plus an absolute part.
 *
 * @param relative by which share of itself a value may be off
 * @param absolute by how much it may be off besides, linear
 */
public record ErrorBound(double relative, double absolute) {
    private static final ErrorBound NONE = new ErrorBound(0, 0);
    /** The largest slope of sRGB: near black. */
    private static final double SRGB_STEEPEST = 12.92;
    /** The largest change of a value displayed in sRGB for a relative change: x·d/dx of 1.055·x^(1/2.4), at 1. */
    private static final double SRGB_RELATIVE_SLOPE = 1.055 / 2.4;
    /** Half an 8-bit step of the displayed value. */
    private static final double HALF_STEP = 0.5 / 255;

    public static ErrorBound of(PixelCache cache) {
        LayerStamp[] top = stamps(cache.lights());
        LayerStamp[] mirrors = stamps(cache.mirroredLights());
        int depth = cache.mirroredScene().picture().depth();
        SamplingSettings sampling = cache.scene().picture().sampling();
        int samples = sampling.isSupersampled() ? sampling.samplesPerPixel() : 1;
        double relative = Math.max(RatioBound.relative(top, 0, samples), RatioBound.relative(mirrors, depth, samples));
        if (relative == 0) {
            return NONE;
        }
        return new ErrorBound(relative, RatioBound.absolute(top, 1, RatioBound.maxTermSum(cache.geometry().materials()))
                + RatioBound.absolute(mirrors, depth, RatioBound.maxTermSum(cache.mirroredGeometry().materials())));
    }

    private static LayerStamp[] stamps(List<CachedLight> lights) {
        return lights.stream().map(CachedLight::stamp).toArray(LayerStamp[]::new);
    }

    /** The bound for the brightest value of the film, linear: no value is off by more. */
    public double maxError(PixelCache cache) {
        return relative == 0 ? absolute : relative * cache.maxValue() + absolute;
    }

    /** Whether an error of this size could change what is displayed at an exposure, in stops. */
    public boolean isVisible(double exposure, DisplayCurve curve) {
        double scaled = Math.pow(2, exposure) * absolute;
        return HALF_STEP < switch (curve) {
            case SRGB -> SRGB_RELATIVE_SLOPE * relative + SRGB_STEEPEST * scaled;
            case LINEAR -> relative + scaled;
            // How steep these are is not bounded here: any error may show.
            case FILMIC, ACES, FALSE -> relative + scaled > 0 ? Double.POSITIVE_INFINITY : 0;
        };
    }
}
