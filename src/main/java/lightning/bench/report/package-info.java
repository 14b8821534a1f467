/**
 * The report of a run: one self-contained HTML file, made from {@link lightning.bench.BenchResults} and the pictures beside them.
 *
 * <pre>{@code
 * HtmlReport.write(results, folder);
 * }</pre>
 *
 * <p>{@link lightning.bench.report.HtmlWriter} is the only way to the page: it closes what it opens and escapes every text, so that
 * the page is well-formed XML whatever names a scene holds. Charts are drawn by JFreeChart in the colors of
 * {@link lightning.bench.report.PlotColor}, which the style sheet gives anew for dark screens.
 */
package lightning.bench.report;
