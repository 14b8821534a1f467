package lightning.bench.report;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import lightning.base.file.AtomicFile;
import lightning.bench.result.BenchResults;
import org.jspecify.annotations.Nullable;

/** Writer of a run's report as one self-contained HTML file, usable offline. */
public final class HtmlReport {
    /** File name of the report. */
    public static final String FILE = "report.html";

    private static final String TITLE = "Lightning benchmark: savings of re-rendering, cost of accuracy";

    private HtmlReport() {}

    /**
     * Writes {@value #FILE}.
     *
     * @param results complete or partial results
     * @param folder  output folder and base of the results' image names; missing images are omitted
     * @throws IOException if the file cannot be written
     */
    public static void write(BenchResults results, Path folder) throws IOException {
        write(results, folder, folder);
    }

    /**
     * Writes the report with images of another folder.
     *
     * @param pictures base folder of the results' image names
     */
    public static void write(BenchResults results, @Nullable Path pictures, Path folder) throws IOException {
        byte[] page = html(results, pictures).getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(folder.resolve(FILE), out -> out.write(page));
    }

    /** Returns the page as well-formed XML. */
    static String html(BenchResults results, @Nullable Path pictures) {
        EmbeddedPictures embeddedPictures = new EmbeddedPictures(pictures);
        HtmlWriter body = new HtmlWriter();
        RunSection.write(body, TITLE, results);
        for (int i = 0; i < results.scenes().size(); i++) {
            SceneSection.write(body, "scene-" + (i + 1), results.scenes().get(i), embeddedPictures);
        }
        CurveSections.write(body, results);
        EditingTable.write(body, results);
        MeshTable.write(body, results);
        ModernSection.write(body, results);
        IndirectSection.write(body, results);
        RunSection.writeMethod(body, results.run());
        HtmlWriter page = new HtmlWriter();
        page.open("html", "xmlns", "http://www.w3.org/1999/xhtml", "lang", "en").open("head");
        page.emptyElement("meta", "charset", "utf-8").emptyElement("meta", "name", "viewport", "content",
                "width=device-width, initial-scale=1");
        page.element("title", TITLE);
        page.open("style").raw(resource("report.css")).raw(embeddedPictures.styleRules()).close();
        page.close().open("body").raw(body.finish());
        page.open("script").raw(resource("report.js")).close();
        return "<!DOCTYPE html>\n" + page.close().close().finish();
    }

    private static String resource(String name) {
        try (var in = HtmlReport.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException("missing resource of the program: " + name, e);
        }
    }
}
