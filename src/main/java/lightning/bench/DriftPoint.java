package lightning.bench;

import lightning.bench.accuracy.PictureError;
import lightning.render.relight.plan.Accuracy;

/**
 * A picture after so many edits.
 *
 * @param edits     how many
 * @param error     how far it is from a full trace
 * @param bound     how far any value may be off by the engine's own account, linear; 0 at grade exact
 * @param refreshes how often contributions were computed anew until then because that bound had grown too large
 */
public record DriftPoint(Accuracy accuracy, int edits, PictureError error, double bound, int refreshes) {}
