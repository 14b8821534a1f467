/**
 * The report of a run: one self-contained HTML file, made from {@link lightning.bench.Results} and the pictures beside them.
 *
 * <pre>{@code
 * Report.write(results, folder);
 * }</pre>
 *
 * <p>{@link lightning.bench.report.Markup} is the only way to the page: it closes what it opens and escapes every text, so that
 * the page is well-formed XML whatever names a scene holds. Charts are drawn by JFreeChart in the colours of
 * {@link lightning.bench.report.Ink}, which the style sheet gives anew for dark screens.
 */
package lightning.bench.report;
