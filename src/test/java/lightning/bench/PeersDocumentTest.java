package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.bench.report.PeerTables;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the tables of docs/peers.md match the stored results. {@code -Dlightning.write=true} writes them. */
class PeersDocumentTest {
    private static final Path DOCUMENT = Path.of("docs", "peers.md");
    private static final Pattern TABLE = Pattern.compile("(<!-- table: (.+?) -->\n)(.*?)(<!-- end -->)", Pattern.DOTALL);
    private static final String RESULTS = """
            {"date": "2026-11-29T01:02:03Z", "commit": "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "processor": "Sample",
             "processors": 2, "system": "Linux, x86_64", "width": 320, "height": 180, "bounces": 2, "programs": [
              {"name": "Lightning", "version": "1", "samples": null, "error": 0.02, "mean": 1, "difference": 0,
               "cold": [4, 2, 3], "warm": [1, 2], "edits": [{"name": "intensity", "seconds": [0.02, 0.01, 0.03]}]},
              {"name": "Cycles", "version": "5", "samples": 200, "error": 0.021, "mean": 0.99, "difference": 0.03,
               "cold": [12], "warm": [9], "edits": [{"name": "intensity", "seconds": [9, 11]}]}]}
            """;

    @Test
    void document_matchesStoredResults() throws IOException {
        assumeThat(StoredRuns.PEERS).exists();
        PeerTables results = new PeerTables(StoredRuns.PEERS);
        String wanted = regenerate(Files.readString(DOCUMENT), results.tables());
        if (Boolean.getBoolean("lightning.write")) {
            Files.writeString(DOCUMENT, wanted);
        }
        assertThat(Files.readString(DOCUMENT)).isEqualTo(wanted).contains(results.commit());
    }

    private static String regenerate(String text, Map<String, String> tables) {
        return TABLE.matcher(text).replaceAll(m -> Matcher.quoteReplacement(m.group(1) + tables.get(m.group(2)) + m.group(4)));
    }

    @Test
    void document_hasAllTables(@TempDir Path folder) throws IOException {
        Map<String, String> tables = new PeerTables(Files.writeString(folder.resolve("peers.json"), RESULTS)).tables();
        assertThat(TABLE.matcher(Files.readString(DOCUMENT)).results().map(m -> m.group(2))).containsExactlyElementsOf(tables.keySet());
    }

    @Test
    void times_areMediansAndRatiosToLightning(@TempDir Path folder) throws IOException {
        Map<String, String> tables = new PeerTables(Files.writeString(folder.resolve("peers.json"), RESULTS)).tables();
        assertThat(tables.get("peer times")).isEqualTo("""
                | seconds | Lightning | Cycles | Cycles / Lightning |
                |---|---|---|---|
                | first picture, whole process | 3.00 | 12.0 | 4.00 |
                | picture again, warm | 1.50 | 9.00 | 6.00 |
                | intensity | 0.020 | 10.0 | 500 |
                """);
        assertThat(tables.get("peer pictures")).contains("| Lightning 1 | – | 2.0\u00a0% |",
                "| Cycles 5 | 200 | 2.1\u00a0% | 0.990 | 3.0\u00a0% |");
    }
}
