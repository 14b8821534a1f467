package lightning.bench;

import java.util.List;

/**
 * All that a run of the harness measured. Times are milliseconds; where a number does not exist it is NaN.
 *
 * @param run      how it was made
 * @param scenes   one for each scene and size, in the order in which they were measured
 * @param drift    what becomes of pictures after many edits
 * @param growth   how times grow, one curve for each thing that grows
 * @param editing  what editing large scenes costs below the editor
 * @param meshes   how fast rays are traced against meshes
 * @param problems what could not be measured
 */
public record BenchResults(BenchRun run, List<SceneResult> scenes, List<DriftCurve> drift, List<GrowthCurve> growth,
        List<EditingCost> editing,
        List<MeshPoint> meshes, List<MeasurementFailure> problems) {
    public BenchResults {
        scenes = List.copyOf(scenes);
        drift = List.copyOf(drift);
        growth = List.copyOf(growth);
        editing = List.copyOf(editing);
        meshes = List.copyOf(meshes);
        problems = List.copyOf(problems);
    }
}
