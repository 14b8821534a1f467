package lightning.editor.window.measure;

import lightning.base.text.Messages;
import lightning.bench.accuracy.AccuracySetting;
import lightning.bench.accuracy.AccuracySweep;
import lightning.bench.accuracy.PictureError;
import lightning.bench.accuracy.SweepPoint;
import lightning.editor.window.model.StatusText;

/** What a grade of the ladder costs and how far it is off, in the words of a table. */
final class AccuracyText {
    private AccuracyText() {}

    static String time(SweepPoint point) {
        return StatusText.milliseconds(point.time().median());
    }

    /** Of the full trace's time; empty where Java was not warm to both. */
    static String saving(AccuracySweep sweep, SweepPoint point) {
        return point.setting() == AccuracySetting.FULL_TRACE || !sweep.isWarm() ? ""
                : StatusText.savingText(sweep.saving(point.setting()) / 100);
    }

    /** The largest error of a value, linear. */
    static String largest(PictureError error) {
        return error.values() == 0 ? Messages.tr("none") : String.format(Messages.locale(), "%.2g", error.maxAbsolute());
    }

    /** The share of values with other bits. */
    static String values(PictureError error) {
        if (error.values() == 0) {
            return Messages.tr("none");
        }
        double percent = 100.0 * error.values() / error.of();
        return percent < 0.1 ? "< 0.1 %" : String.format(Messages.locale(), "%.1f %%", percent);
    }

    /** As displayed in 8 bits. */
    static String psnr(PictureError error) {
        return Double.isInfinite(error.displayPsnr()) ? "∞" : String.format(Messages.locale(), "%.1f dB", error.displayPsnr());
    }

    static String ssim(PictureError error) {
        return error.ssim() == 1 ? "1" : String.format(Messages.locale(), "%.4f", Math.min(error.ssim(), 0.9999));
    }
}
