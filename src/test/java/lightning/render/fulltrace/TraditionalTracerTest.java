package lightning.render.fulltrace;

import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.format.jen.JenWriter;
import lightning.render.image.FilmAssert;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.SceneCoverage;
import lightning.render.trace.Geometry;
import lightning.sample.CornerScenes;
import lightning.sample.EngineMix;
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
    void everyValueEqualsTheReferenceTrace(@ForAll("scenes") Scene scene, @ForAll @IntRange(min = 1, max = 3) int threads,
            @ForAll long engines) {
        SceneCoverage.collect(scene);
        try (Workers workers = new Workers(threads)) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).by(new EngineMix(engines)).trace(workers, Progress.NONE).film(),
                    new ReferenceTracer(scene).trace(), "traditional-trace");
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "\nthe scene was\n" + JenWriter.write(scene), e);
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void mirrorsOfAnotherScene_equalTheReferenceTrace(@ForAll("scenes") Scene mirrored, @ForAll("scenes") Scene other,
            @ForAll long engines) {
        Scene scene = CornerScenes.bright(mirrored, mirrored.rig().withLights(other.rig().actingLights())).withWorld(other.world());
        try (Workers workers = new Workers(2)) {
            FilmAssert.assertSameBits(
                    new TraditionalTracer(scene, mirrored, new Geometry(scene)).by(new EngineMix(engines)).trace(workers, Progress.NONE)
                            .film(),
                    new ReferenceTracer(scene, mirrored).trace(), "traditional-trace-stale");
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "\nthe scene was\n" + JenWriter.write(scene) + "\nits mirrors show\n"
                    + JenWriter.write(mirrored), e);
        }
    }
}
