package lightning.bench.report;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.sample.Browser;

/** Report of results, open in a browser. */
final class ReportPage implements AutoCloseable {
    private final Browser browser;

    private ReportPage(Browser browser) {
        this.browser = browser;
    }

    /** Writes and opens a report in a window of usual width. */
    static ReportPage open(BenchResults results, Path folder) throws IOException {
        HtmlReport.write(results, folder);
        return new ReportPage(Browser.open(folder.resolve(HtmlReport.FILE), folder, 1280, 900));
    }

    Browser browser() {
        return browser;
    }

    /** Runs a script in the page and returns its value. */
    Object run(String script, Object... arguments) {
        return browser.run(script, arguments);
    }

    /** Returns the value of an expression that uses functions of the page's script: of its numbers, elements, axes and charts. */
    Object evaluate(String expression, Object... arguments) {
        String functions = Stream.of("numbers", "elements", "axes", "charts").map(ReportPage::script).collect(Collectors.joining());
        return browser.run(functions + "return " + expression + ";", arguments);
    }

    private static String script(String name) {
        try (InputStream in = HtmlReport.class.getResourceAsStream("page/" + name + ".js")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Opens all edits and waits until they show their charts. */
    void openEdits() {
        run("document.querySelectorAll('details').forEach(edit => { edit.open = true; })");
        browser.waitFor("return [...document.querySelectorAll('details')].every(edit => edit.children.length > 1)");
    }

    /** Returns the texts of the elements that a selector finds, in order. */
    List<String> texts(String selector) {
        return strings("return [...document.querySelectorAll(arguments[0])].map(element => element.textContent)", selector);
    }

    /** Returns the cells of the row of a table, found by the beginning of the table's caption and the row's name. */
    List<String> row(String caption, String name) {
        return strings("""
                const table = [...document.querySelectorAll("table")].find(t => t.caption.textContent.startsWith(arguments[0]));
                const row = [...table.rows].find(r => r.cells[0].textContent === arguments[1]);
                return [...row.cells].slice(1).map(cell => cell.textContent);""", caption, name);
    }

    /** Returns the value of a script as strings. */
    List<String> strings(String script, Object... arguments) {
        return ((List<?>) run(script, arguments)).stream().map(Object::toString).toList();
    }

    /** Returns all visible texts. */
    String text() {
        return (String) run("return document.querySelector('header').textContent + document.querySelector('main').textContent");
    }

    @Override
    public void close() {
        browser.close();
    }
}
