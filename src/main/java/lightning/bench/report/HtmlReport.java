package lightning.bench.report;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonValue;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.AtomicFile;
import lightning.base.text.HtmlPage;
import lightning.bench.result.BenchResults;
import lightning.bench.result.EffectResult;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.RayThroughput;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.render.measure.AccuracySetting;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.SerializationContext;
import tools.jackson.databind.ValueSerializer;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.module.SimpleModule;
import tools.jackson.databind.node.ObjectNode;

/** Writer of a run's report as one self-contained HTML file, usable offline. Its script builds tables and charts from the results. */
public final class HtmlReport {
    /** File name of the report. */
    public static final String FILE = "report.html";

    private static final List<String> SCRIPTS = List.of("page/numbers.js", "page/elements.js", "page/axes.js", "page/charts.js",
            "page/pictures.js", "page/scenes.js", "page/curves.js", "page/start.js");

    /** Results with the numbers that their methods derive, so that the page computes none of them again. */
    private static final JsonMapper JSON = JsonMapper.builder()
            .addMixIn(EffectResult.class, Derived.class)
            .addMixIn(IndirectAccuracy.class, Derived.class)
            .addMixIn(IndirectAccuracy.Point.class, Derived.class)
            .addMixIn(IndirectGrowth.Point.class, Derived.class)
            .addMixIn(ModernSampling.class, Derived.class)
            .addMixIn(RayThroughput.class, Derived.class)
            .addMixIn(ReflectionAccuracy.Point.class, Derived.class)
            .addMixIn(SoftShadowAccuracy.Point.class, Derived.class)
            .addModule(new SimpleModule().addSerializer(Double.class, new AnyDouble()).addSerializer(Double.TYPE, new AnyDouble()))
            .build();

    private HtmlReport() {}

    /** Methods of results that the page needs; each class has some of them. */
    private abstract static class Derived {
        @JsonValue
        abstract String label();

        @JsonProperty
        abstract boolean usesDefault();

        @JsonProperty
        abstract List<IndirectAccuracy.Point> grid();

        @JsonProperty
        abstract List<IndirectAccuracy.Point> byBounces();

        @JsonProperty
        abstract double extraMs();

        @JsonProperty
        abstract double certainFirstMs();

        @JsonProperty
        abstract double certainUpdateMs();

        @JsonProperty
        abstract double millionsPerSecond();

        @JsonProperty
        abstract double rivalMillionsPerSecond();
    }

    /** Writes a number for which JSON has no word as {@code {"double": "NaN"}}, which is no text. */
    private static final class AnyDouble extends ValueSerializer<Double> {
        @Override
        public void serialize(Double v, JsonGenerator out, SerializationContext context) {
            if (Double.isFinite(v)) {
                out.writeNumber(v);
            } else {
                out.writeStartObject().writeStringProperty("double", v.toString()).writeEndObject();
            }
        }
    }

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
    public static void write(BenchResults results, Path pictures, Path folder) throws IOException {
        EmbeddedPictures embedded = EmbeddedPictures.of(results, pictures);
        ObjectNode data = JSON.createObjectNode();
        data.set("results", JSON.valueToTree(results));
        data.put("busy", results.run().load().isBusy(results.run().machine().processors()));
        data.put("usual", AccuracySetting.DEFAULT.name());
        for (AccuracySetting setting : AccuracySetting.values()) {
            data.withArray("settings").addObject().put("name", setting.name()).put("label", setting.label()).put("description",
                    setting.description());
        }
        data.set("pictures", JSON.valueToTree(embedded.blockOfFile()));
        String page =
                HtmlPage.withoutData(HtmlReport.class, "report.html", "report.css", SCRIPTS).replace("{{pictures}}", embedded.blocks());
        byte[] bytes = HtmlPage.withData(page, JSON.writeValueAsString(data)).getBytes(StandardCharsets.UTF_8);
        AtomicFile.write(folder.resolve(FILE), out -> out.write(bytes));
    }
}
