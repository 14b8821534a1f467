/**
 * Report of a run: one self-contained HTML file, made from {@link lightning.bench.result.BenchResults} and its images.
 *
 * <pre>{@code
 * HtmlReport.write(results, folder);
 * }</pre>
 *
 * <p>All output goes through {@link lightning.bench.report.HtmlWriter}, which closes elements and escapes text, so that the page is
 * well-formed XML for any scene names. JFreeChart draws the charts in the colors of {@link lightning.bench.report.PlotColor}, which the
 * style sheet redefines for dark screens.
 */
@NullMarked
package lightning.bench.report;

import org.jspecify.annotations.NullMarked;
