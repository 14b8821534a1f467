/**
 * Benchmark harness: savings of re-rendering and cost of accuracy on any scenes, with result files.
 * Single measurements belong to {@code render.measure}; the editor is not known here.
 *
 * <pre>{@code
 * BenchResults results = ResultsFile.readJson(Path.of("results.json"));
 * for (SceneResult scene : results.scenes()) {
 *     for (EditResult edit : scene.edits()) {
 *         System.out.println(scene.scene() + ", " + edit.edit() + ": saves " + edit.saving() + " %");
 *     }
 * }
 * }</pre>
 *
 * <p>Times are milliseconds and keep every raw sample. Compared tasks are measured in turns.
 */
@NullMarked
package lightning.bench;

import lightning.bench.result.EditResult;
import lightning.bench.result.SceneResult;
import org.jspecify.annotations.NullMarked;
