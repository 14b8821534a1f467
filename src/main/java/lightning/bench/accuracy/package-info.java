/**
 * What accuracy costs: each grade measured beside the full trace, on the paper's printed edits or any other.
 *
 * <pre>{@code
 * try (LadderMeter meter = new LadderMeter(Workers.available(), 5, 3000)) {
 *     for (PaperCase edit : PaperCases.of(scene)) {
 *         Ladder ladder = meter.measure(edit.before(), edit.after(), Progress.NONE);
 *         Rung exact = ladder.rung(Grade.EXACT);
 *         System.out.println(edit.name() + ": " + exact.time().median() + " ms, " + exact.error().values() + " values differ");
 *     }
 * }
 * }</pre>
 */
package lightning.bench.accuracy;
