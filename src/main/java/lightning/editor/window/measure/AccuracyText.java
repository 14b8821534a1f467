package lightning.editor.window.measure;

import lightning.base.text.Messages;
import lightning.editor.window.model.StatusText;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.AccuracySweep;
import lightning.render.measure.PictureError;
import lightning.render.measure.SweepPoint;

/** Formats the time and error of an accuracy setting. */
final class AccuracyText {
    private AccuracyText() {}

    static String time(SweepPoint point) {
        return StatusText.milliseconds(point.time().median());
    }

    /** Returns the saving compared to a full trace; empty if the JVM was not warm for both. */
    static String saving(AccuracySweep sweep, SweepPoint point) {
        return point.setting() == AccuracySetting.FULL_TRACE || !sweep.isWarm() ? ""
                : StatusText.savingText(sweep.saving(point.setting()) / 100);
    }

    /** Returns the largest absolute error of a value, linear. */
    static String largest(PictureError error) {
        return error.values() == 0 ? Messages.tr("none") : String.format(Messages.locale(), "%.2g", error.maxAbsolute());
    }

    /** Returns the share of values that differ in any bit. */
    static String values(PictureError error) {
        if (error.values() == 0) {
            return Messages.tr("none");
        }
        double percent = 100.0 * error.values() / error.of();
        return percent < 0.1 ? "< 0.1 %" : String.format(Messages.locale(), "%.1f %%", percent);
    }

    /** Returns the PSNR of the displayed 8-bit values. */
    static String psnr(PictureError error) {
        return Double.isInfinite(error.displayPsnr()) ? "∞" : String.format(Messages.locale(), "%.1f dB", error.displayPsnr());
    }

    static String ssim(PictureError error) {
        return error.ssim() == 1 ? "1" : String.format(Messages.locale(), "%.4f", Math.min(error.ssim(), 0.9999));
    }
}
