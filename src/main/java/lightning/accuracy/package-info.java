/**
 * What an update is measured by: the paper's printed edits, as named cases.
 *
 * <pre>{@code
 * for (PaperCase edit : PaperCases.of(scene)) {
 *     renderer.render(edit.before(), Progress.NONE);
 *     Update update = renderer.render(edit.after(), Progress.NONE);
 * }
 * }</pre>
 */
package lightning.accuracy;
