package lightning.render.fulltrace;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenWriter;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.EdgeCaseScenes;
import lightning.sample.IndirectArbitraries;
import lightning.sample.MixedEngineChoice;
import lightning.sample.Slow;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Tests that full traces with indirect light have the bits of the reference. */
class IndirectTraceTest {

    @Provide
    Arbitrary<Scene> scenes() {
        return IndirectArbitraries.scenes();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void everyValue_equalsReference(@ForAll("scenes") Scene scene, @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll long engines) {
        assertEqualsReference(scene, scene, threads, engines);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void mirrorsOfOtherScene_equalReference(@ForAll("scenes") Scene mirrored, @ForAll("scenes") Scene other, @ForAll long engines) {
        Scene scene = EdgeCaseScenes.withLightsOf(other, mirrored);
        assertEqualsReference(scene.withPicture(scene.picture().withIndirect(other.picture().indirect())), mirrored, 2, engines);
    }

    private static void assertEqualsReference(Scene scene, Scene mirrored, int threads, long engines) {
        try (WorkerPool workers = new WorkerPool(threads)) {
            FilmAssert.assertSameBits(
                    new TraditionalTracer(scene, mirrored, Geometry.of(scene)).withEngines(new MixedEngineChoice(engines))
                            .trace(workers, Progress.NONE).film(),
                    new ReferenceTracer(scene, mirrored).trace(), "indirect-trace");
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "\nwith " + scene.picture().indirect() + " the scene was\n" + JenWriter.write(scene)
                    + "\nits mirrors show\n" + JenWriter.write(mirrored), e);
        }
    }
}
