package lightning.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.result.IndirectAbsence;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SoftShadowAccuracy;

/** Collector of the results of indirect light, blurred reflections and soft shadows so far. */
final class IndirectCollector {
    private final List<IndirectAccuracy> accuracy = new ArrayList<>();
    private final List<IndirectCost> costs = new ArrayList<>();
    private final Map<String, IndirectGrowth> growths = new LinkedHashMap<>();
    private final List<IndirectAbsence> absence = new ArrayList<>();
    private final List<ReflectionAccuracy> reflections = new ArrayList<>();
    private final List<SoftShadowAccuracy> softShadows = new ArrayList<>();

    void add(IndirectAccuracy measured) {
        accuracy.add(measured);
    }

    void add(IndirectCost measured) {
        costs.add(measured);
    }

    void add(IndirectAbsence measured) {
        absence.add(measured);
    }

    void add(ReflectionAccuracy measured) {
        reflections.add(measured);
    }

    void add(SoftShadowAccuracy measured) {
        softShadows.add(measured);
    }

    /** Adds a point to a growth curve. */
    void add(String along, String scene, IndirectGrowth.Point point) {
        List<IndirectGrowth.Point> points = new ArrayList<>(growths.containsKey(along) ? growths.get(along).points() : List.of());
        points.add(point);
        growths.put(along, new IndirectGrowth(along, scene, points));
    }

    IndirectResults result() {
        return new IndirectResults(accuracy, costs, List.copyOf(growths.values()), absence, softShadows, reflections);
    }
}
