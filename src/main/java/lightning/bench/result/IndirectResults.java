package lightning.bench.result;

import java.util.List;

/**
 * Results of indirect light, soft shadows and blurred reflections.
 *
 * @param accuracy time against error, per scene
 * @param costs    first pass and edits, per scene
 * @param growth   costs as a function of one dimension
 * @param absence  costs of scenes without it
 * @param softShadows time against error of area lights, per scene
 * @param reflections time against error of blurred reflections, per scene
 */
public record IndirectResults(List<IndirectAccuracy> accuracy, List<IndirectCost> costs, List<IndirectGrowth> growth,
        List<IndirectAbsence> absence, List<SoftShadowAccuracy> softShadows, List<ReflectionAccuracy> reflections) {
    /** No measurement. */
    public static final IndirectResults NONE = new IndirectResults(List.of(), List.of(), List.of(), List.of(), List.of(), List.of());

    public IndirectResults {
        accuracy = List.copyOf(accuracy);
        costs = List.copyOf(costs);
        growth = List.copyOf(growth);
        absence = List.copyOf(absence);
        softShadows = List.copyOf(softShadows);
        reflections = List.copyOf(reflections);
    }

    /** Returns whether nothing was measured. */
    public boolean hasNone() {
        return equals(NONE);
    }
}
