package lightning.bench.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.StreamSupport;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Tables of the document that compares Lightning with path tracers, made from the results of {@code benchmarks/peers} only. */
public final class PeerTables {
    private final JsonNode results;

    /** @param file results, which exist */
    public PeerTables(Path file) {
        results = new JsonMapper().readTree(file.toFile());
    }

    /** Returns the commit that was measured, 40 digits. */
    public String commit() {
        return results.get("commit").asString();
    }

    /** Returns all tables by name, with lines that end with line feeds. */
    public Map<String, String> tables() {
        Map<String, String> tables = new LinkedHashMap<>();
        tables.put("peer build",
                "Measured at commit `" + commit() + "` on " + results.get("date").asString() + ", " + results.get("processors").asInt()
                        + " processors (" + results.get("processor").asString() + "), " + results.get("system").asString() + ": "
                        + results.get("width").asInt() + "×" + results.get("height").asInt() + " pixels, "
                        + results.get("bounces").asInt() + " bounces.\n");
        tables.put("peer pictures", pictures());
        tables.put("peer times", times());
        return tables;
    }

    private List<JsonNode> programs() {
        return StreamSupport.stream(results.get("programs").spliterator(), false).toList();
    }

    private String pictures() {
        return MarkdownTables.table(List.of("program", "samples a pixel", "error", "mean brightness", "difference from Lightning"),
                programs().stream().map(p -> List.of(p.get("name").asString() + " " + p.get("version").asString(),
                        p.get("samples").isNull() ? "–" : p.get("samples").asString(), percent(p.get("error")),
                        NumberText.threeDigits(p.get("mean").asDouble()),
                        percent(p.get("difference")))));
    }

    private static String percent(JsonNode share) {
        return NumberText.percent(100 * share.asDouble());
    }

    private String times() {
        List<JsonNode> programs = programs();
        List<List<String>> rows = new ArrayList<>();
        rows.add(row("first picture, whole process", programs.stream().map(p -> p.get("cold")).toList()));
        rows.add(row("picture again, warm", programs.stream().map(p -> p.get("warm")).toList()));
        JsonNode edits = programs.getFirst().get("edits");
        for (int i = 0; i < edits.size(); i++) {
            int edit = i;
            rows.add(
                    row(edits.get(i).get("name").asString(), programs.stream().map(p -> p.get("edits").get(edit).get("seconds")).toList()));
        }
        List<String> head = new ArrayList<>(List.of("seconds"));
        programs.forEach(p -> head.add(p.get("name").asString()));
        programs.stream().skip(1).forEach(p -> head.add(p.get("name").asString() + " / " + programs.getFirst().get("name").asString()));
        return MarkdownTables.table(head, rows.stream());
    }

    /** Returns medians, and their ratios to the first. */
    private static List<String> row(String name, List<JsonNode> samples) {
        double[] medians = samples.stream().mapToDouble(PeerTables::median).toArray();
        List<String> row = new ArrayList<>(List.of(name));
        for (double median : medians) {
            row.add(NumberText.threeDigits(median));
        }
        for (int i = 1; i < medians.length; i++) {
            row.add(NumberText.threeDigits(medians[i] / medians[0]));
        }
        return row;
    }

    private static double median(JsonNode samples) {
        double[] sorted =
                StreamSupport.stream(samples.spliterator(), false).flatMapToDouble(v -> DoubleStream.of(v.asDouble())).sorted().toArray();
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }
}
