package lightning.render.relight.paper;

import java.util.List;
import lightning.render.cache.CachedLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.scene.SamplingSettings;

/**
 * Error bound of the film: a relative part for each value, plus an absolute part.
 *
 * @param relative largest relative error of a value
 * @param absolute largest additional error, linear
 */
public record ErrorBound(double relative, double absolute) {
    /** Largest slope of sRGB, near black. */
    private static final double SRGB_STEEPEST = 12.92;
    /** Largest change of a displayed sRGB value for a relative change: x·d/dx of 1.055·x^(1/2.4), at 1. */
    private static final double SRGB_RELATIVE_SLOPE = 1.055 / 2.4;
    /** Half an 8-bit step of the displayed value. */
    private static final double HALF_STEP = 0.5 / 255;

    public static ErrorBound of(PixelCache cache) {
        LayerStamp[] top = stamps(cache.shown().lights());
        LayerStamp[] mirrors = stamps(cache.mirrored().lights());
        int depth = cache.mirrored().scene().picture().depth();
        SamplingSettings sampling = cache.scene().picture().sampling();
        int samples = sampling.isSupersampled() ? sampling.samplesPerPixel() : 1;
        double relative = Math.max(RatioBound.relative(top, 0, samples), RatioBound.relative(mirrors, depth, samples));
        return new ErrorBound(relative, RatioBound.absolute(top, 1, RatioBound.maxTermSum(cache.geometry().materials()))
                + RatioBound.absolute(mirrors, depth, RatioBound.maxTermSum(cache.mirroredGeometry().materials())));
    }

    private static LayerStamp[] stamps(List<CachedLight> lights) {
        return lights.stream().map(CachedLight::stamp).toArray(LayerStamp[]::new);
    }

    /** Returns the bound for the brightest value of the film, linear; no value has a larger error. */
    public double maxError(PixelCache cache) {
        return relative * cache.maxValue() + absolute;
    }

    /** Returns whether an error of this size could change the displayed image at an exposure, in stops. */
    public boolean isVisible(double exposure, DisplayCurve curve) {
        double scaled = Math.pow(2, exposure) * absolute;
        return HALF_STEP < switch (curve) {
            case SRGB -> SRGB_RELATIVE_SLOPE * relative + SRGB_STEEPEST * scaled;
            case LINEAR -> relative + scaled;
            // The slopes of these curves are not bounded here, so any error may be visible.
            case FILMIC, ACES, ACES2, AGX, FALSE -> relative + scaled > 0 ? Double.POSITIVE_INFINITY : 0;
        };
    }
}
