package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that all renderers add the indirect light of the reference, on all engines and any number of threads. */
@Slow
class IndirectScenesTest {
    /** Pictures of the reference by the names of their scenes. */
    private static final Map<String, Film> REFERENCES = new HashMap<>();

    static Stream<String> names() {
        return IndirectScenes.all().keySet().stream();
    }

    private static Film reference(String name) {
        return REFERENCES.computeIfAbsent(name, _ -> new ReferenceTracer(IndirectScenes.all().get(name)).trace());
    }

    @ParameterizedTest
    @MethodSource("names")
    void allRenderers_equalReference(String name) {
        Scene scene = IndirectScenes.all().get(name);
        Film expected = reference(name);
        assertEqual(scene, expected, 1, _ -> Engines.SCALAR, name);
        assertEqual(scene, expected, 3, _ -> Engines.LANES, name);
    }

    private static void assertEqual(Scene scene, Film expected, int threads, EngineChoice engines, String name) {
        try (WorkerPool workers = new WorkerPool(threads);
                Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(threads).withEngines(engines))) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).withEngines(engines).trace(workers, Progress.NONE).film(), expected,
                    "indirect " + name + ", full trace");
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), expected, "indirect " + name + ", first pass");
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void indirectLight_isVisible(String name) {
        Scene scene = IndirectScenes.all().get(name);
        Scene without = scene.withPicture(scene.picture().withIndirect(Optional.empty()));
        assertThat(reference(name).hasSameBits(new ReferenceTracer(without).trace()))
                .isEqualTo(Set.of("empty", "black").contains(name) || scene.picture().indirect().isEmpty());
    }

    /** The order in which shapes name materials decides the order of rows in a first pass, but not after an edit. */
    @Test
    void reorderedShapes_givePictureOfFirstPass() {
        Scene scene = IndirectScenes.all().get("two mirrors");
        Scene reversed = scene.withNodes(scene.nodes().reversed());
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            renderer.render(reversed, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(reversed).trace(), "indirect reordered");
        }
    }

    /** A wall without thickness separates two floors, and the lamp lights one of them. */
    @Test
    void movedLamp_recomposesOnlyWhereLightChanges() throws JenException {
        Scene direct = JenReader.read("""
                jen 1
                picture { size 128 32  depth 1 }
                camera { from 0 2 6  to 0 0 0 }
                material white { diffuse 0.8 0.8 0.8 }
                plane wall { material white  rotate 0 0 90  scale 50 1 50 }
                plane left_floor { material white  at -1.7 -1 0  scale 1.5 1 1 }
                sphere left_ball { material white  at -1.5 -0.4 0  scale 0.4 0.4 0.4 }
                plane right_floor { material white  at 1.7 -1 0  scale 1.5 1 1 }
                sphere right_ball { material white  at 1.5 -0.4 0  scale 0.4 0.4 0.4 }
                light left_lamp point { at -1.5 1 1 }
                light right_lamp point { at 1.5 1 1 }
                """, "floors.jen", Path.of("")).scene();
        Scene scene = direct.withPicture(direct.picture().withIndirect(Optional.of(new IndirectSettings(2, 16, 4, false))));
        Scene dimmed = scene.withLight(scene.light("right_lamp").orElseThrow().withIntensity(0.5));
        Scene moved = scene.withLight(scene.light("right_lamp").orElseThrow().withPosition(new Vec3(1.4, 1, 0.9)));
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            long rows = renderer.render(scene, Progress.NONE).rowsComposed();
            assertThat(renderer.render(dimmed, Progress.NONE).rowsComposed()).as("its film stays").isZero();
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(dimmed).trace(workers, Progress.NONE).film(),
                    "indirect dimmed");
            assertThat(renderer.render(moved, Progress.NONE).rowsComposed()).isPositive().isLessThan(3 * rows / 4);
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(moved).trace(workers, Progress.NONE).film(),
                    "indirect moved");
        }
    }

    /** No light and no surfel changes, only what rays meet that leave the scene. */
    @Test
    void otherBackground_changesIndirectLight() throws JenException {
        Scene direct = JenReader.read("""
                jen 1
                picture { size 32 24 }
                camera { from 0 2 6  to 0 0 0 }
                world { background 0.2 0.4 0.8 }
                material white { diffuse 0.8 0.8 0.8 }
                plane floor { material white  at 0 -1 0  scale 4 1 4 }
                sphere ball { material white  at 0 -0.4 0  scale 0.6 0.6 0.6 }
                light lamp point { at 1 2 1 }
                """, "sky.jen", Path.of("")).scene();
        Scene scene = direct.withPicture(direct.picture().withIndirect(Optional.of(new IndirectSettings(2, 16, 4, true))));
        Scene red = scene.withWorld(scene.world().withBackground(new Rgb(0.9, 0.1, 0.1)));
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            renderer.render(red, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(red).trace(workers, Progress.NONE).film(),
                    "indirect background");
        }
    }

    /** Rays through the rim of the opening are known too, unless they may meet the ball or the pane. */
    @Test
    void objectMovedInRoomWithOpening_givesPictureOfFirstPassWithFewerRays() {
        Scene scene = IndirectScenes.all().get("environment through an opening");
        Scene moved = scene.withNodes(scene.nodes().stream().map(node -> node.name().equals("ball")
                ? node.withPlacement(node.placement().withPosition(new Vec3(0.4, -0.6, -0.2))) : node).toList());
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            long first = renderer.render(scene, Progress.NONE).rays().total();
            for (Scene edited : new Scene[] {moved, scene}) {
                assertThat(renderer.render(edited, Progress.NONE).rays().total()).isLessThan(first);
                FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(edited).trace(workers, Progress.NONE).film(), "opening");
            }
        }
    }

    /** Rays stay aimed at an object that does not glow, and add nothing. */
    @Test
    void glowThatEndsAndReturns_castsNoRay() {
        Scene scene = IndirectScenes.all().get("small glows");
        Scene dark = scene.withMaterial(scene.material("flame").orElseThrow().withGlow(Rgb.BLACK));
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            for (Scene edited : new Scene[] {dark, scene}) {
                assertThat(renderer.render(edited, Progress.NONE).rays().total()).isZero();
                FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(edited).trace(workers, Progress.NONE).film(),
                        "indirect glow");
            }
        }
    }

    @Test
    void glowThatBegins_lightsLikeFirstPass() {
        Scene scene = IndirectScenes.all().get("small glows");
        Scene dark = scene.withMaterial(scene.material("flame").orElseThrow().withGlow(Rgb.BLACK));
        try (WorkerPool workers = new WorkerPool(1); Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(dark, Progress.NONE);
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), "indirect glow");
        }
    }

    /** Forced reflections are cast before and after the edit, but only rays of mirrors lead to gather points. */
    @Test
    void mirrorThatCeases_whileReflectionsAreForced_givesPictureOfFirstPass() {
        Scene scene = IndirectScenes.all().get("mirror ball");
        Scene edited = scene.withMaterial(scene.material("mirror").orElseThrow().withReflective(Rgb.BLACK));
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1,
                ViewEffects.ALL.withForced(Set.of(RenderEffect.REFLECTION)));
        try (Renderer renderer = new Renderer(options); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(scene, Progress.NONE);
            renderer.render(edited, Progress.NONE);
            assertThat(renderer.film().hasSameBits(new TraditionalTracer(edited).trace(workers, Progress.NONE).film())).isTrue();
        }
    }
}
