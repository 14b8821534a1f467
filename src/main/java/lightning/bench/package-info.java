/**
 * The harness: what re-rendering saves and what accuracy costs, measured on any scenes and left behind as results.
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
 * <p>Times are milliseconds and come with every raw sample. What is measured with each other is measured in turns.
 */
package lightning.bench;
