package lightning.bench.result;

import java.util.Locale;
import lightning.render.measure.PictureError;
import lightning.render.relight.paper.Accuracy;

/**
 * Image error after a number of edits.
 *
 * @param edits     number of edits
 * @param error     difference from a full trace
 * @param bound     the engine's error bound of any value, linear; 0 at setting exact
 * @param refreshes number of recomputations so far because the bound was exceeded
 */
public record DriftPoint(Accuracy accuracy, int edits, PictureError error, double bound, int refreshes) {
    /** Returns the name of its accuracy in files and tables. */
    public String setting() {
        return accuracy.name().toLowerCase(Locale.ROOT);
    }
}
