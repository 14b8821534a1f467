package lightning.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.ColdStart;
import lightning.bench.result.DriftCurve;
import lightning.bench.result.EditResult;
import lightning.bench.result.EditingCost;
import lightning.bench.result.EffectResult;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.GrowthPoint;
import lightning.bench.result.MeasurementFailure;
import lightning.bench.result.MeshPoint;
import lightning.bench.result.PeerResult;
import lightning.bench.result.SceneResult;
import lightning.render.measure.AccuracySetting;
import org.jspecify.annotations.Nullable;

/** Collector of a run's results so far. */
final class ResultCollector {
    /** Collector for one scene at one size. */
    static final class SceneCollector {
        private final NamedScene scene;
        private final PictureSize size;
        private final List<EditResult> edits = new ArrayList<>();
        private List<EffectResult> effects = List.of();
        private @Nullable FirstPassCost firstPass;
        private @Nullable String pictureBefore;
        private @Nullable PeerResult peer;
        private @Nullable ColdStart coldStart;

        private SceneCollector(NamedScene scene, PictureSize size) {
            this.scene = scene;
            this.size = size;
        }

        void setFirstPass(FirstPassCost cost) {
            firstPass = cost;
        }

        /** @param file image before all edits, relative to the results */
        void setPictureBefore(String file) {
            pictureBefore = file;
        }

        void addEdit(EditResult edit) {
            edits.add(edit);
        }

        void setEffects(List<EffectResult> v) {
            effects = v;
        }

        void setPeer(PeerResult v) {
            peer = v;
        }

        void setColdStart(ColdStart v) {
            coldStart = v;
        }

        private SceneResult result() {
            return new SceneResult(scene.name(), size.width(), size.height(), scene.scene().picture().depth(),
                    scene.scene().stage().shapeCount(), scene.scene().lights().size(), pictureBefore,
                    firstPass == null ? null : FirstPassResult.of(firstPass, size.pixels(), averageSavedMs()), edits, effects,
                    peer, coldStart);
        }

        /** Returns the mean saving of edits at the default setting. */
        private double averageSavedMs() {
            return edits.stream().flatMap(edit -> edit.values().stream()).mapToDouble(result -> result.rungs().getLast().time().median()
                    - result.point(AccuracySetting.DEFAULT).time().median()).average().orElse(0);
        }
    }

    private final List<SceneCollector> scenes = new ArrayList<>();
    private final List<DriftCurve> drifts = new ArrayList<>();
    private final Map<String, GrowthCurve> growths = new LinkedHashMap<>();
    private final List<EditingCost> editing = new ArrayList<>();
    private final List<MeshPoint> meshes = new ArrayList<>();
    private final List<ModernCollector> modern = new ArrayList<>();
    private final IndirectCollector indirect = new IndirectCollector();
    private final List<MeasurementFailure> problems = new ArrayList<>();

    SceneCollector addScene(NamedScene scene, PictureSize size) {
        scenes.add(new SceneCollector(scene, size));
        return scenes.getLast();
    }

    void addDrift(DriftCurve drift) {
        drifts.add(drift);
    }

    void addGrowth(String along, String scene, GrowthPoint point) {
        List<GrowthPoint> points = new ArrayList<>(growths.containsKey(along) ? growths.get(along).points() : List.of());
        points.add(point);
        growths.put(along, new GrowthCurve(along, scene, points));
    }

    void addEditing(EditingCost measured) {
        editing.add(measured);
    }

    void addMesh(MeshPoint measured) {
        meshes.add(measured);
    }

    /** @param losses features that POV-Ray does not support exactly */
    ModernCollector addModern(String scene, List<String> losses) {
        modern.add(new ModernCollector(scene, losses));
        return modern.getLast();
    }

    IndirectCollector indirect() {
        return indirect;
    }

    void addProblem(MeasurementFailure problem) {
        problems.add(problem);
    }

    void addUnmeasured(String where, @Nullable String what) {
        addProblem(new MeasurementFailure(MeasurementFailure.Kind.UNMEASURED, where, what));
    }

    void addBroken(String where, @Nullable String what) {
        addProblem(new MeasurementFailure(MeasurementFailure.Kind.BROKEN, where, what));
    }

    /** Returns all results of a run. */
    BenchResults results(BenchRun run) {
        return new BenchResults(run, scenes.stream().map(SceneCollector::result).toList(), drifts, List.copyOf(growths.values()), editing,
                meshes, modern.stream().map(ModernCollector::result).toList(), indirect.result(), problems);
    }
}
