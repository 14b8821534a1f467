package lightning.render.measure;

import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.image.Flip;

/**
 * Error of an image against the full trace of the requested scene; see {@link Difference} for the definition of each measure.
 *
 * @param values       number of values (three per pixel) that are not bit-identical
 * @param of           number of values of the image
 * @param maxUlp       maximum distance in units in the last place
 * @param maxAbsolute  maximum absolute difference, linear
 * @param meanAbsolute mean absolute difference, linear
 * @param rmse         root mean square difference, linear
 * @param linearPsnr   peak signal-to-noise ratio in dB for the linear peak 1; infinite if equal
 * @param displayPsnr  peak signal-to-noise ratio as displayed in 8 bits
 * @param ssim         structural similarity as displayed, 1 if equal
 * @param flip         mean ꟻLIP error as displayed, 0…1; NaN if not measured
 */
public record PictureError(long values, long of, long maxUlp, double maxAbsolute, double meanAbsolute, double rmse,
        double linearPsnr, double displayPsnr, double ssim, double flip) {

    /**
     * Measures an image against the full trace.
     *
     * @throws IllegalArgumentException if their sizes differ
     */
    public static PictureError of(Film film, Film reference) {
        long of = 3L * reference.width() * reference.height();
        if (film.hasSameBits(reference)) {
            return new PictureError(0, of, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 0);
        }
        Difference d = Difference.of(film, reference);
        return new PictureError(d.values(), of, d.maxUlp(), d.maxAbsolute(), d.meanAbsolute(), d.rmse(), d.linearPsnr(),
                d.displayPsnr(), d.ssim(), Flip.mean(film, reference));
    }
}
