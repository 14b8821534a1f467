package lightning.editor.window.measure;

import lightning.base.text.Texts;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.Ladder;
import lightning.bench.accuracy.PictureError;
import lightning.bench.accuracy.Rung;
import lightning.editor.window.model.StatusText;

/** What a grade of the ladder costs and how far it is off, in the words of a table. */
final class RungText {
    private RungText() {}

    static String time(Rung rung) {
        return StatusText.milliseconds(rung.time().median());
    }

    /** Of the full trace's time; empty where Java was not warm to both. */
    static String saving(Ladder ladder, Rung rung) {
        return rung.grade() == Grade.FULL_TRACE || !ladder.warm() ? "" : StatusText.saving(ladder.saving(rung.grade()) / 100);
    }

    /** The largest error of a value, linear. */
    static String largest(PictureError error) {
        return error.values() == 0 ? Texts.of("none") : String.format(Texts.locale(), "%.2g", error.maxAbsolute());
    }

    /** The share of values with other bits. */
    static String values(PictureError error) {
        if (error.values() == 0) {
            return Texts.of("none");
        }
        double percent = 100.0 * error.values() / error.of();
        return percent < 0.1 ? "< 0.1 %" : String.format(Texts.locale(), "%.1f %%", percent);
    }

    /** As displayed in 8 bits. */
    static String psnr(PictureError error) {
        return Double.isInfinite(error.displayPsnr()) ? "∞" : String.format(Texts.locale(), "%.1f dB", error.displayPsnr());
    }

    static String ssim(PictureError error) {
        return error.ssim() == 1 ? "1" : String.format(Texts.locale(), "%.4f", Math.min(error.ssim(), 0.9999));
    }
}
