package lightning.bench.result;

import java.util.List;

/**
 * Results of a benchmark run. Times are milliseconds; missing numbers are NaN.
 *
 * @param run      settings and circumstances of the run
 * @param scenes   results per scene and size, in the order of measurement
 * @param drift    image errors after many edits
 * @param growth   times as a function of size, one curve per dimension
 * @param editing  costs of editing large scenes without rendering
 * @param meshes   ray throughput on meshes
 * @param modern   results per modern scene
 * @param indirect results of indirect light
 * @param problems failed measurements
 */
public record BenchResults(BenchRun run, List<SceneResult> scenes, List<DriftCurve> drift, List<GrowthCurve> growth,
        List<EditingCost> editing,
        List<MeshPoint> meshes, List<ModernScene> modern, IndirectResults indirect,
        List<MeasurementFailure> problems) {
    public BenchResults {
        scenes = List.copyOf(scenes);
        drift = List.copyOf(drift);
        growth = List.copyOf(growth);
        editing = List.copyOf(editing);
        meshes = List.copyOf(meshes);
        modern = List.copyOf(modern);
        problems = List.copyOf(problems);
    }

    /** Creates results without indirect light. */
    public BenchResults(BenchRun run, List<SceneResult> scenes, List<DriftCurve> drift, List<GrowthCurve> growth,
            List<EditingCost> editing, List<MeshPoint> meshes, List<ModernScene> modern, List<MeasurementFailure> problems) {
        this(run, scenes, drift, growth, editing, meshes, modern, IndirectResults.NONE, problems);
    }
}
