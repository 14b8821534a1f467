package lightning.bench.accuracy;

import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.image.Flip;

/**
 * How far a picture is from the full trace of the wanted scene; see {@link Difference} for what each measure is taken of.
 *
 * @param values       how many values (three a pixel) have other bits
 * @param of           how many values the picture has
 * @param maxUlp       largest distance in units in the last place
 * @param maxAbsolute  largest absolute difference, linear
 * @param meanAbsolute mean absolute difference, linear
 * @param rmse         root mean square difference, linear
 * @param linearPsnr   peak signal-to-noise ratio in dB for the linear peak 1; infinite where equal
 * @param displayPsnr  the same as displayed in 8 bits
 * @param ssim         structural similarity as displayed, 1 where equal
 * @param flip         mean ꟻLIP error as displayed, 0…1; NaN where it was not measured
 */
public record PictureError(long values, long of, long maxUlp, double maxAbsolute, double meanAbsolute, double rmse,
        double linearPsnr, double displayPsnr, double ssim, double flip) {

    /**
     * Measures a picture against the full trace.
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
