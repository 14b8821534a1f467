package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.foreign.MemorySegment;
import java.nio.channels.Channels;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.CacheMetadata;
import lightning.render.cache.CacheSerializer;
import lightning.render.cache.PixelCache;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.EditSession;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Fog;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests that an image that was stored and read between two edits continues as if it had stayed in memory. */
class StoredCacheTest {
    @Provide
    Arbitrary<EditSession> sessions() {
        return Arbitraries.oneOf(EditSession.indirectSessions(), EditSession.indirectObjectSessions(), EditSession.mixedSessions());
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void storedImage_continuesWithoutADifference(@ForAll("sessions") EditSession session, @ForAll ReflectionMode reflections,
            @ForAll @IntRange(min = 1, max = 7) int refreshEach) throws IOException {
        RenderOptions options = new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, 1);
        try (Renderer kept = new Renderer(options); Renderer stored = new Renderer(options)) {
            int step = 0;
            for (Scene scene : session.timedScenes()) {
                UpdateResult expected = kept.render(scene, Progress.NONE);
                UpdateResult update = stored.render(scene, Progress.NONE);
                if (++step % refreshEach == 0) {
                    kept.updateReflections(Progress.NONE);
                    stored.updateReflections(Progress.NONE);
                }
                assertThat(update.plan().description()).isEqualTo(expected.plan().description());
                assertThat(update.rays().total()).isEqualTo(expected.rays().total());
                assertThat(stored.film().hasSameBits(kept.film())).as("picture %d", step).isTrue();
                PixelCache read = throughFile(stored.cache());
                assertThat(read.film().hasSameBits(kept.film())).isTrue();
                assertThat(read.indirectBytes()).isLessThanOrEqualTo(stored.cache().indirectBytes());
                stored.restore(read);
            }
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "\nthe session was\n" + session, e);
        }
    }

    private static PixelCache throughFile(PixelCache cache) throws IOException {
        var rows = new ByteArrayOutputStream();
        CacheSerializer.writeRows(cache, new ColumnWriter(Channels.newChannel(rows)));
        var colors = new ByteArrayOutputStream();
        CacheSerializer.writeColors(cache, new ColumnWriter(Channels.newChannel(colors)));
        return CacheSerializer.read(CacheMetadata.of(cache), new ColumnReader(MemorySegment.ofArray(rows.toByteArray())),
                new ColumnReader(MemorySegment.ofArray(colors.toByteArray())));
    }

    @Test
    void storedIndirectLight_ofEveryKindOfScene_isRelitWithoutRays() throws IOException {
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            for (Scene scene : IndirectScenes.all().values()) {
                renderer.clear();
                renderer.render(scene, Progress.NONE);
                renderer.restore(throughFile(renderer.cache()));
                Scene brighter = scene.withLights(scene.lights().stream().map(l -> l.withIntensity(0.7 * l.intensity())).toList());
                UpdateResult update = renderer.render(brighter, Progress.NONE);
                assertThat(update.rays().total()).isZero();
                Film full = new TraditionalTracer(brighter, Geometry.of(brighter)).trace(workers, Progress.NONE).film();
                assertThat(renderer.film().hasSameBits(full)).isTrue();
            }
        }
    }

    /** What memory keeps of the fog of a dark light, a file keeps too. */
    @Test
    void darkLight_keepsItsFog_inMemoryAndInFile() throws IOException {
        Scene studio = StudioScene.of(LightType.POINT);
        Scene lit = studio.withWorld(studio.world().withFog(Fog.NONE.withDensity(0.1)));
        Light light = lit.lights().getFirst();
        Scene dark = lit.withLight(light.withOn(false));
        Scene moved = lit.withLight(light.withOn(false).withPosition(light.position().plus(new Vec3(0.5, 0.25, 0))));
        for (List<Scene> scenes : List.of(List.of(lit, dark, lit), List.of(lit, dark, moved, dark, lit))) {
            try (Renderer kept = new Renderer(RenderOptions.DEFAULT.withThreads(1));
                    Renderer stored = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
                for (Scene scene : scenes) {
                    long rays = kept.render(scene, Progress.NONE).rays().total();
                    assertThat(stored.render(scene, Progress.NONE).rays().total()).isEqualTo(rays);
                    stored.restore(throughFile(stored.cache()));
                }
            }
        }
    }

    /** Mirrors that are not updated look current again when the settings of indirect light return, but know the points of other paths. */
    @Test
    void mirrorsOfEarlierPaths_showLightOfCurrentOnes() throws IOException {
        Scene scene = IndirectScenes.all().get("mirror ball");
        Light lamp = scene.lights().getFirst();
        Scene brighter = scene.withLight(lamp.withIntensity(1.01 * lamp.intensity()));
        RenderOptions options = RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1);
        try (Renderer renderer = new Renderer(options)) {
            for (Scene step : List.of(scene, IndirectScenes.without(scene), scene, brighter, scene)) {
                renderer.render(step, Progress.NONE);
                renderer.restore(throughFile(renderer.cache()));
            }
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(scene).trace())).isTrue();
        }
    }

    /** Samples of pixels that edits needed one after the other lie in many blocks, which are joined when pixels change again. */
    @Test
    void weightEditAfterManyMoves_castsNoRay_fromMemoryAndFromFile() throws IOException {
        Scene studio = StudioScene.of(LightType.SPOT);
        Scene scene = studio.withPicture(studio.picture().withSize(70, 50).withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)));
        Light key = scene.lights().getFirst();
        try (Renderer kept = new Renderer(RenderOptions.DEFAULT.withThreads(1));
                Renderer stored = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            for (int i = 0; i < 40; i++) {
                Light moved = key.withPosition(key.position().plus(new Vec3(0.03 * i, 0, 0.01 * i)));
                for (Light light : List.of(moved, moved.withIntensity(1.01 * moved.intensity()))) {
                    long rays = kept.render(scene.withLight(light), Progress.NONE).rays().total();
                    assertThat(stored.render(scene.withLight(light), Progress.NONE).rays().total()).isEqualTo(rays);
                    stored.restore(throughFile(stored.cache()));
                }
            }
        }
    }
}
