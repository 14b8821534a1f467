package lightning.render.fulltrace;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenWriter;
import lightning.render.image.FilmAssert;
import lightning.render.shading.SceneCoverage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.EdgeCaseScenes;
import lightning.sample.MixedEngineChoice;
import lightning.sample.SceneArbitraries;
import lightning.sample.Slow;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.StatisticsReport;

class TraditionalTracerTest {

    @Provide
    Arbitrary<Scene> scenes() {
        return SceneArbitraries.scenes();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void everyValue_equalsReference(@ForAll("scenes") Scene scene, @ForAll @IntRange(min = 1, max = 3) int threads,
            @ForAll long engines) {
        SceneCoverage.collect(scene);
        try (WorkerPool workers = new WorkerPool(threads)) {
            FilmAssert.assertSameBits(
                    new TraditionalTracer(scene).withEngines(new MixedEngineChoice(engines)).trace(workers, Progress.NONE).film(),
                    new ReferenceTracer(scene).trace(), "traditional-trace");
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "\nthe scene was\n" + JenWriter.write(scene), e);
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void mirrorsOfOtherScene_equalReference(@ForAll("scenes") Scene mirrored, @ForAll("scenes") Scene other,
            @ForAll long engines) {
        Scene scene = EdgeCaseScenes.withLightsOf(other, mirrored);
        try (WorkerPool workers = new WorkerPool(2)) {
            FilmAssert.assertSameBits(
                    new TraditionalTracer(scene, mirrored, Geometry.of(scene)).withEngines(new MixedEngineChoice(engines))
                            .trace(workers, Progress.NONE)
                            .film(),
                    new ReferenceTracer(scene, mirrored).trace(), "traditional-trace-stale");
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "\nthe scene was\n" + JenWriter.write(scene) + "\nits mirrors show\n"
                    + JenWriter.write(mirrored), e);
        }
    }
}
