package lightning.render.shading.explanation;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.NormalSteps;
import lightning.sample.IndirectScenes;
import lightning.sample.SceneArbitraries;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeLinks;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PixelExplainerTest {
    @Provide
    Arbitrary<Scene> scenes() {
        return SceneArbitraries.scenes();
    }

    /** A trace skips rays of an area light where one shape certainly hides all of it. */
    @ParameterizedTest
    @EnumSource(LightType.class)
    void raysOfAllPixels_areThoseOfFullTrace_andHiddenOnes(LightType type) {
        Scene scene = StudioScene.of(type);
        scene = scene.withLight(StudioScene.key(type).withArea(StudioScene.key(type).area().withWidth(1).withHeight(0.5)));
        PictureSettings picture = scene.picture();
        var explainer = new PixelExplainer(scene);
        RayCounts sum = RayCounts.NONE;
        for (int i = 0; i < picture.width() * picture.height(); i++) {
            sum = sum.plus(explainer.explainPixel(i % picture.width(), i / picture.width()).rays());
        }
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            RayCounts cast = renderer.render(scene, Progress.NONE).rays();
            assertThat(sum.minus(cast)).isEqualTo(RayCounts.ofShadows(Map.of(StudioScene.KEY, sum.shadow() - cast.shadow())));
            boolean hasSize = !Set.of(LightType.POINT, LightType.SPOT, LightType.DIRECTIONAL).contains(type);
            assertThat(sum.shadow()).isBetween(cast.shadow(), hasSize ? Long.MAX_VALUE : cast.shadow());
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void color_matchesReferenceBits(@ForAll("scenes") Scene scene, @ForAll Random pixels) {
        var reference = new ReferenceTracer(scene);
        var explainer = withGatheredLight(new PixelExplainer(scene), scene);
        for (int i = 0; i < 30; i++) {
            int x = pixels.nextInt(scene.picture().width());
            int y = pixels.nextInt(scene.picture().height());
            assertThat(explainer.explainPixel(x, y).color()).as("pixel %d,%d of\n%s", x, y, JenWriter.write(scene))
                    .containsExactly(reference.pixel(x, y));
        }
    }

    private static PixelExplainer withGatheredLight(PixelExplainer explainer, Scene scene) {
        try (WorkerPool workers = new WorkerPool(1)) {
            TraditionalTracer tracer = new TraditionalTracer(scene, explainer.geometry());
            return explainer.withIndirect(tracer.traceIndirect(workers, Progress.NONE)).withFog(tracer.traceFog(workers, Progress.NONE),
                    tracer.traceBounceFog(workers, Progress.NONE));
        }
    }

    /** Mirrors, transparent surfaces and the background show it too. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void colorWithIndirectLight_matchesFullTraceBits(@ForAll("scenes") Scene drawn, @ForAll Random pixels) {
        Scene scene = IndirectScenes.withBackground(drawn.withPicture(drawn.picture().withSampling(SamplingSettings.DEFAULT)));
        var explainer = new PixelExplainer(scene);
        var tracer = new TraditionalTracer(scene, explainer.geometry());
        try (WorkerPool workers = new WorkerPool(1)) {
            Film film = tracer.trace(workers, Progress.NONE).film();
            explainer =
                    explainer.withIndirect(tracer.traceIndirect(workers, Progress.NONE)).withFog(tracer.traceFog(workers, Progress.NONE),
                            tracer.traceBounceFog(workers, Progress.NONE));
            for (int i = 0; i < 30; i++) {
                int x = pixels.nextInt(scene.picture().width());
                int y = pixels.nextInt(scene.picture().height());
                PointReport report = explainer.explainPixel(x, y);
                assertThat(report.color()).as("pixel %d,%d of\n%s", x, y, JenWriter.write(scene)).containsExactly(film.red(x, y),
                        film.green(x, y), film.blue(x, y));
                assertThat(report.indirect() == null).isEqualTo(report.isBackground());
            }
        }
    }

    /** Lights change their order in the scene, and every second one its position. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void colorAfterEdit_matchesReferenceBits(@ForAll("scenes") Scene scene, @ForAll Random pixels) {
        List<Light> lights = scene.lights().reversed().stream()
                .map(l -> pixels.nextBoolean() ? l : l.withPosition(l.position().plus(new Vec3(0.25, 0.5, 0.125)))).toList();
        Scene edited = scene.withLights(lights);
        var reference = new ReferenceTracer(edited);
        var before = new PixelExplainer(scene);
        PixelExplainer explainer = null;
        for (int i = 0; i < 30; i++) {
            int x = pixels.nextInt(scene.picture().width());
            int y = pixels.nextInt(scene.picture().height());
            before.explainPixel(x, y);
            explainer = explainer == null ? withGatheredLight(before.forScene(edited, before.geometry()), edited) : explainer;
            assertThat(explainer.explainPixel(x, y).color()).as("pixel %d,%d of\n%s", x, y, JenWriter.write(edited))
                    .containsExactly(reference.pixel(x, y));
        }
    }

    @Test
    void birdScene_reportsEveryStateAndMirror() throws Exception {
        Scene bird = JenReader.read(Path.of("scenes/bird.jen")).scene();
        Light sun = bird.light("sun").orElseThrow();
        Light source = bird.light("lamp").orElseThrow().withIlluminates(ShapeLinks.only("floor"));
        var explainer =
                new PixelExplainer(bird.withLight(sun.withOn(false)).withLight(source).withPicture(bird.picture().withSize(40, 40)));
        Set<LightReport.State> seen = EnumSet.noneOf(LightReport.State.class);
        boolean mirrored = false;
        for (int pixel = 0; pixel < 1600; pixel++) {
            PointReport report = explainer.explainPixel(pixel % 40, pixel / 40);
            report.lights().forEach(light -> seen.add(light.state()));
            mirrored |= report.reflected() != null;
        }
        assertThat(seen).containsExactlyInAnyOrder(LightReport.State.values());
        assertThat(mirrored).isTrue();
    }

    /** For every kind of normal, the last step is the shading normal, unless it was bent. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void lastNormalStep_isShadingNormal(@ForAll("scenes") Scene scene, @ForAll Random pixels) {
        var explainer = new PixelExplainer(scene);
        for (int i = 0; i < 30; i++) {
            PointReport report = explainer.explainPixel(pixels.nextInt(scene.picture().width()), pixels.nextInt(scene.picture().height()));
            NormalSteps steps = report.normals();
            if (steps != null) {
                Vec3 last = steps.bumped() == null ? steps.smooth() : steps.bumped();
                var shades = new Vec3(report.hit().nx(), report.hit().ny(), report.hit().nz());
                assertThat(shades.minus(last).maxAbs() < 1e-7).isEqualTo(!steps.isBent());
                assertThat(shades.dot(steps.geometric())).isPositive();
            }
        }
    }

    /** Bumps on the sphere's unlit side face the light in places; the sphere itself is in between. */
    @Test
    void lightBelowBumpySurface_isReported() {
        float[] gray = new float[3 * 8 * 8];
        for (int i = 0; i < gray.length; i++) {
            gray[i] = (i / 6 + i / 48) % 2;
        }
        var bumps = new TextureMap("a.png", 4, 4, new Texture(8, 8, gray));
        Scene scene =
                new Scene(new PictureSettings(40, 40, 0), new Camera(new Vec3(0, 0, 9), Vec3.ZERO, Vec3.Y, 14), new World(0, Rgb.BLACK),
                        List.of(Material.of("m").withBumpMapping(BumpMapping.NONE.withBump(Optional.of(bumps)).withHeight(0.1))),
                        List.of(new Shape(Solid.SPHERE, "ball", "m", Placement.IDENTITY)),
                        List.of(Light.of("key", LightType.POINT).withPosition(new Vec3(-9, 3, -3))));
        var explainer = new PixelExplainer(scene);
        int below = 0;
        for (int pixel = 0; pixel < 1600; pixel++) {
            PointReport report = explainer.explainPixel(pixel % 40, pixel / 40);
            for (LightReport light : report.lights()) {
                Vec3 toTarget = new Vec3(-9, 3, -3).minus(explainer.geometry().toScene(new Vec3(report.hit().px(), report.hit().py(),
                        report.hit().pz()))).normalized();
                double own = report.normals() == null ? 1 : report.normals().geometric().dot(toTarget);
                if (Math.abs(own) > 1e-6) {
                    assertThat(light.samplesBelowSurface()).isEqualTo(own < 0 && light.cosine() > 0 ? 1 : 0);
                }
                assertThat(light.samplesBelowSurface() == 1 && light.state() != LightReport.State.SHADOWED).isFalse();
                below += light.samplesBelowSurface();
            }
        }
        assertThat(below).isGreaterThan(50);
    }

    /** Two cards whose left halves are opaque, in front of a sphere, which is fully cut out where its image is transparent. */
    @Test
    void passedCutouts_areReportedOnce() {
        var left = new TextureMap("left.png", 1, 1, new Texture(2, 1, new float[] {1, 1, 1, 0, 0, 0}));
        Material cut = Material.of("cut").withCutout(AlphaCutout.NONE.withMap(Optional.of(left)));
        Vec3 upright = new Vec3(90, 0, 0);
        Scene scene = new Scene(new PictureSettings(2, 1, 0), new Camera(new Vec3(0, 0, 9), Vec3.ZERO, Vec3.Y, 10), new World(0, Rgb.BLACK),
                List.of(cut), List.of(
                        new Shape(Solid.SPHERE, "ball", "default", Placement.IDENTITY),
                        new Shape(Solid.PLANE, "far", "cut", new Placement(new Vec3(0, 0, -5), upright, new Vec3(9, 1, 9))),
                        new Shape(Solid.PLANE, "near", "cut", new Placement(new Vec3(0, 0, 5), upright, new Vec3(9, 1, 9)))),
                List.of());
        var explainer = new PixelExplainer(scene);
        assertThat(explainer.explainPixel(0, 0).passedCutouts()).isEmpty();
        assertThat(explainer.explainPixel(1, 0).passedCutouts()).containsExactly(2);
        assertThat(explainer.geometry().shape(explainer.explainPixel(1, 0).hit().primitive()).name()).isEqualTo("ball");
    }

    /** A sphere over a floor with a light above: the floor below is in the sphere's shadow. */
    @Test
    void shadow_reportsNearestBlocker() {
        Scene scene = new Scene(new PictureSettings(1, 1, 0), new Camera(new Vec3(0, 1, 9), Vec3.ZERO, Vec3.Y, 20),
                new World(0, Rgb.BLACK), List.of(), List.of(
                        new Shape(Solid.PLANE, "floor", "default", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9))),
                        new Shape(Solid.SPHERE, "high", "default", new Placement(new Vec3(0, 8, 0), Vec3.ZERO, Vec3.ONE)),
                        new Shape(Solid.SPHERE, "low", "default", new Placement(new Vec3(0, 5, 0), Vec3.ZERO, Vec3.ONE))),
                List.of(Light.of("top", LightType.POINT).withPosition(new Vec3(0, 20, 0)),
                        Light.of("between", LightType.POINT).withPosition(new Vec3(0, 3, 0))));
        var explainer = new PixelExplainer(scene);
        PointReport report = explainer.explainPixel(0, 0);
        assertThat(explainer.geometry().shape(report.hit().primitive()).name()).isEqualTo("floor");
        LightReport top = report.lights().getFirst();
        assertThat(top.state()).isEqualTo(LightReport.State.SHADOWED);
        assertThat(explainer.geometry().shape(top.blocker()).name()).isEqualTo("low");
        assertThat(report.lights().getLast().state()).isEqualTo(LightReport.State.LIT);
    }

    @Test
    void surfaceThatReceivesNothing_hasBlackIndirectLight() {
        Scene drawn = StudioScene.of(LightType.POINT);
        Scene scene = IndirectScenes.with(drawn.withLights(drawn.lights().stream().map(light -> light.withOn(false)).toList())
                .withWorld(new World(0, Rgb.BLACK)));
        PointReport report = withGatheredLight(new PixelExplainer(scene), scene).explainPixel(15, 12);
        assertThat(report.isBackground()).isFalse();
        assertThat(report.indirect()).containsOnly(0);
    }
}
