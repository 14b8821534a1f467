package lightning.bench.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.render.measure.ParetoFront;

/** Charts of indirect light as files for documents. */
public final class IndirectDocumentCharts {
    static final String BOUNCES = "indirect-bounces.svg";

    private IndirectDocumentCharts() {}

    /** Returns the labels of charts in the report by file name. */
    public static Map<String, String> labels(BenchResults results) {
        Map<String, String> labels = new LinkedHashMap<>();
        IndirectResults indirect = results.indirect();
        indirect.accuracy().forEach(scene -> labels.put(fileName(scene), meanError("indirect light", scene.scene())));
        if (!indirect.accuracy().isEmpty()) {
            labels.put(BOUNCES, "Missing light against bounces");
        }
        indirect.reflections().stream().filter(scene -> !scene.points().isEmpty())
                .forEach(scene -> labels.put(fileName(scene), meanError("blurred reflections", scene.scene())));
        indirect.softShadows().forEach(scene -> labels.put(fileName(scene), meanError("area lights", scene.scene())));
        indirect.growth().forEach(growth -> labels.put(fileName(growth), "Time (ms) of indirect light against " + growth.along()));
        return labels;
    }

    private static String meanError(String what, String scene) {
        return "Mean error of " + what + " against time (ms), " + scene;
    }

    static String fileName(IndirectAccuracy scene) {
        return "indirect-error-" + word(scene.scene()) + ".svg";
    }

    static String fileName(ReflectionAccuracy scene) {
        return "indirect-reflections-" + word(scene.scene()) + ".svg";
    }

    static String fileName(SoftShadowAccuracy scene) {
        return "indirect-shadows-" + word(scene.scene()) + ".svg";
    }

    static String fileName(IndirectGrowth growth) {
        return "indirect-growth-" + word(growth.along()) + ".svg";
    }

    private static String word(String text) {
        return text.replaceAll("[^\\p{Alnum}]+", "-");
    }

    /** Returns the settings on the Pareto front, fastest first. */
    static List<IndirectAccuracy.Point> front(IndirectAccuracy scene) {
        return ParetoFront.of(scene.grid(), point -> point.time().median(), point -> point.error().mean());
    }
}
