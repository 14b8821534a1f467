/**
 * Cost of accuracy: each setting measured against the full trace, on the paper's printed edits or any other.
 *
 * <pre>{@code
 * try (AccuracySweepMeter meter = new AccuracySweepMeter(WorkerPool.processorCount(), 5, 3000)) {
 *     for (PaperCase edit : PaperCases.of(scene)) {
 *         AccuracySweep sweep = meter.measure(edit.before(), edit.after(), Progress.NONE);
 *         SweepPoint exact = sweep.point(AccuracySetting.EXACT);
 *         System.out.println(edit.name() + ": " + exact.time().median() + " ms, " + exact.error().values() + " values differ");
 *     }
 * }
 * }</pre>
 */
@NullMarked
package lightning.bench.accuracy;

import lightning.render.measure.AccuracySetting;
import lightning.render.measure.SweepPoint;
import org.jspecify.annotations.NullMarked;
