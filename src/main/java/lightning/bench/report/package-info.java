/**
 * Report of a run: one self-contained HTML file, made from {@link lightning.bench.result.BenchResults} and its images.
 *
 * <pre>{@code
 * HtmlReport.write(results, folder);
 * }</pre>
 *
 * <p>The results and images are data of the page. Its script builds tables and charts from them in the browser, and shows all names as
 * text.
 */
@NullMarked
package lightning.bench.report;

import org.jspecify.annotations.NullMarked;
