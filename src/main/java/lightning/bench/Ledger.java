package lightning.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.accuracy.Grade;

/** What was measured until now. */
final class Ledger {
    /** One scene at one size. */
    static final class Page {
        private final NamedScene scene;
        private final PictureSize size;
        private final List<EditResult> edits = new ArrayList<>();
        private List<EffectResult> effects = List.of();
        private FirstPassCost firstPass;
        private String before;
        private Peer peer;
        private Cold cold;

        private Page(NamedScene scene, PictureSize size) {
            this.scene = scene;
            this.size = size;
        }

        void firstPass(FirstPassCost cost) {
            firstPass = cost;
        }

        /** @param file the picture before all edits, relative to the results */
        void before(String file) {
            before = file;
        }

        void edit(EditResult edit) {
            edits.add(edit);
        }

        void effects(List<EffectResult> v) {
            effects = v;
        }

        void peer(Peer v) {
            peer = v;
        }

        void cold(Cold v) {
            cold = v;
        }

        private SceneResult result() {
            return new SceneResult(scene.name(), size.width(), size.height(), scene.scene().picture().depth(),
                    scene.scene().stage().shapeCount(), scene.scene().lights().size(), before,
                    firstPass == null ? null : FirstPass.of(firstPass, size.pixels(), averageSavedMs()), edits, effects,
                    peer, cold);
        }

        /** What an edit at the default grade saves, the average of all. */
        private double averageSavedMs() {
            return edits.stream().flatMap(edit -> edit.values().stream()).mapToDouble(value -> value.rungs().getLast().time().median()
                    - value.rung(Grade.DEFAULT).time().median()).average().orElse(0);
        }
    }

    private final List<Page> pages = new ArrayList<>();
    private final List<Drift> drifts = new ArrayList<>();
    private final Map<String, Growth> growths = new LinkedHashMap<>();
    private final List<Editing> editing = new ArrayList<>();
    private final List<MeshPoint> meshes = new ArrayList<>();
    private final List<Failure> problems = new ArrayList<>();

    Page page(NamedScene scene, PictureSize size) {
        pages.add(new Page(scene, size));
        return pages.getLast();
    }

    void drift(Drift drift) {
        drifts.add(drift);
    }

    void growth(String along, String scene, GrowthPoint point) {
        List<GrowthPoint> points = new ArrayList<>(growths.containsKey(along) ? growths.get(along).points() : List.of());
        points.add(point);
        growths.put(along, new Growth(along, scene, points));
    }

    void editing(Editing measured) {
        editing.add(measured);
    }

    void mesh(MeshPoint measured) {
        meshes.add(measured);
    }

    void problem(Failure problem) {
        problems.add(problem);
    }

    /** Everything, as a run's results. */
    Results results(Run run) {
        return new Results(run, pages.stream().map(Page::result).toList(), drifts, List.copyOf(growths.values()), editing, meshes,
                problems);
    }
}
