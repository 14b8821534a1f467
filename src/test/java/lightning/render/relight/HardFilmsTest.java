package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.JenScenes;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** Tests hard sums of films: very many, very bright or faint ones, and films that show almost nothing. */
@Slow
class HardFilmsTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final String ROOM = "picture { size 36 24  depth 2 }  camera { from 0 1.4 5  to 0 0.6 0 }  world { ambience 0.1 }"
            + "  material floor { diffuse 0.6 0.5 0.4  reflective 0.2 0.2 0.2 }  material ball { diffuse 0.3 0.6 0.5  specular 0.5 0.5 0.5 }"
            + "  plane ground { material floor }  sphere ball { material ball  at 0 1 0 }";

    /** Compares the picture with the reference after each edit: rendered at once, and in two steps. */
    private static void assertExact(Scene first, List<UnaryOperator<Scene>> edits) {
        try (Renderer renderer = new Renderer(OPTIONS); Renderer inSteps = new Renderer(OPTIONS)) {
            renderer.render(first, Progress.NONE);
            inSteps.render(first, Progress.NONE);
            Scene scene = first;
            for (UnaryOperator<Scene> edit : edits) {
                scene = edit.apply(scene);
                Film expected = new ReferenceTracer(scene).trace();
                renderer.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), expected, "hard-films");
                inSteps.renderCenters(inSteps.plan(scene), Progress.NONE);
                if (!inSteps.state().isFinished()) {
                    inSteps.finish(Progress.NONE);
                }
                FilmAssert.assertSameBits(inSteps.film(), expected, "hard-films-in-steps");
            }
        }
    }

    private static Scene room(String lights) {
        return JenScenes.of(ROOM + "  " + lights);
    }

    private static Scene sampled(Scene scene) {
        return scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 3)));
    }

    private static UnaryOperator<Scene> light(String name, UnaryOperator<Light> edit) {
        return scene -> scene.withLight(edit.apply(scene.light(name).orElseThrow()));
    }

    @Test
    void thousandLights_areEditedOneByOne() {
        List<Light> lights = IntStream.range(0, SceneLimits.MAX_LIGHTS)
                .mapToObj(l -> Light.of("l" + l, l % 3 == 0 ? LightType.SPOT : LightType.POINT).withIntensity(0.002 + 1e-5 * l)
                        .withPosition(new Vec3(4 * Math.sin(l), 1 + l % 7, 4 * Math.cos(1.7 * l))).withDirection(new Vec3(0, -1, 0))
                        .withAngle(5 + l % 40))
                .toList();
        assertExact(sampled(room("")).withLights(lights), List.of(light("l500", l -> l.withIntensity(3)), light("l0", l -> l.withOn(false)),
                light("l999", l -> l.withPosition(new Vec3(0.5, 2, 1))), light("l500", l -> l.withColor(new Rgb(1, 0, 0.5))),
                light("l0", l -> l.withOn(true)), scene -> scene.withLights(scene.lights().subList(0, 700))));
    }

    @Provide
    Arbitrary<Double> exponents() {
        return Arbitraries.doubles().between(-30, 30);
    }

    /** The falloff takes away nearly what the weight gives. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void weightsOfAnySize_areCanceledByFalloff(@ForAll("exponents") double first, @ForAll("exponents") double second) {
        Scene scene = room("light key point { at 1 3 2 }  light fill point { at -2 2 1  intensity 0.4 }");
        UnaryOperator<Scene> edit = light("key", l -> weighted(l, second));
        assertExact(sampled(light("key", l -> weighted(l, first)).apply(scene)), List.of(edit, light("key", l -> l.withIntensity(0)),
                light("key", l -> weighted(l, first))));
    }

    private static Light weighted(Light light, double exponent) {
        return light.withIntensity(Math.pow(10, exponent)).withAttenuation(new Attenuation(Math.pow(10, exponent), 0.1, 0.01));
    }

    @Test
    void filmsThatUnderflow_areMultipliedByLargeWeights() {
        Scene scene = room("light far point { at 0 1e5 0  intensity 1e-30  attenuation 1e30 0 1e30 }"
                + "  light near point { at 2 3 1  intensity 0.3 }");
        assertExact(sampled(scene), List.of(light("far", l -> l.withIntensity(1e30)), light("far", l -> l.withIntensity(1)),
                light("far", l -> l.withAttenuation(new Attenuation(1e30, 0, 1e25)).withIntensity(1e30)),
                light("near", l -> l.withIntensity(1e-38))));
    }

    @Test
    void lightThatReachesOnePixel_isEdited() {
        Scene scene = room("light tiny spot { at 0.31 3 0.7  direction 0 -1 0.1  angle 0.4  intensity 5 }"
                + "  light fill point { at -2 2 1  intensity 0.4 }");
        int lit = litPixels(scene);
        assertThat(lit).isBetween(1, 3);
        List<UnaryOperator<Scene>> edits =
                List.of(light("tiny", l -> l.withIntensity(1)), light("tiny", l -> l.withColor(new Rgb(0.2, 1, 0))),
                        light("tiny", l -> l.withPosition(new Vec3(0.6, 3, 0.9))), light("tiny", l -> l.withAngle(0.1)));
        assertExact(scene, edits);
        assertExact(sampled(scene), edits);
    }

    private static int litPixels(Scene scene) {
        Scene dark = light("tiny", l -> l.withOn(false)).apply(scene);
        float[] with = new ReferenceTracer(scene).trace().toScanlines();
        float[] without = new ReferenceTracer(dark).trace().toScanlines();
        return (int) IntStream.range(0, with.length / 3).filter(i -> with[3 * i] != without[3 * i]).count();
    }

    @Test
    void allLights_areSwitchedOffAndOn() {
        Scene scene = sampled(room("light a point { at 1 3 2  intensity 0.4 }  light b spot { at -1 3 1  direction 0.3 -1 0 }"));
        UnaryOperator<Scene> off = s -> s.withLights(s.lights().stream().map(l -> l.withOn(false)).toList());
        UnaryOperator<Scene> black = s -> s.withWorld(s.world().withAmbience(0));
        assertExact(scene, List.of(off, black, light("b", l -> l.withOn(true)), light("a", l -> l.withOn(true).withIntensity(2)), off,
                s -> s.withWorld(s.world().withAmbience(0.3))));
    }

    @Test
    void soloInGroups_darkensOthers() {
        Scene scene = sampled(room("bank warm { color 1 0.8 0.6  intensity 2 }  bank cold { intensity 0.5 }"
                + "  light a point { at 1 3 2  bank warm }  light b point { at -1 3 1  bank cold }"
                + "  light c point { at 0 2 3  bank warm  intensity 0.1 }  light d point { at 3 3 3  intensity 0.2 }"));
        List<UnaryOperator<Scene>> edits = new ArrayList<>(List.of(light("a", l -> l.withSolo(true)), group("cold", g -> g.withSolo(true)),
                light("a", l -> l.withSolo(false)), group("cold", g -> g.withSolo(false)), group("warm", g -> g.withOn(false)),
                group("warm", g -> g.withOn(true).withColor(new Rgb(0, 0.5, 1)))));
        assertExact(scene, edits);
    }

    private static UnaryOperator<Scene> group(String name, UnaryOperator<LightGroup> edit) {
        return scene -> scene.withRig(scene.rig().with(edit.apply(scene.rig().lightGroup(name).orElseThrow())));
    }

    @Test
    void fogGlassMirrorsTwoEnvironmentsAndGatheredLight_worksTogether() {
        Scene room = sampled(room("material glass { diffuse 0.1 0.1 0.1  clear 0.9 0.9 0.9  ior 1.4 }"
                + "  sphere drop { material glass  at 1 0.5 1.2  scale 0.5 0.5 0.5 }"
                + "  material lamp { diffuse 0.2 0.2 0.2  bulb key  shadows none }  sphere bulb { material lamp  at 1 3 2  scale 0.1 0.1 0.1 }"
                + "  light key point { at 1 3 2  intensity 0.6 }  light spot spot { at -2 3 1  direction 0.6 -1 -0.2  angle 30 }"));
        Scene scene = JenScenes.withSky(room);
        Scene all = scene.withWorld(scene.world().withOwn(own -> own.withIntensity(0.3)).withNamed(List.of(JenScenes.dome("second", 0.2)))
                .withFog(scene.world().fog().withDensity(0.05)))
                .withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(2, 16, 4, true))));
        assertExact(all, List.of(light("key", l -> l.withIntensity(2)),
                s -> s.withWorld(s.world().withDome("second", s.world().dome("second").orElseThrow().withIntensity(1.5))),
                light("spot", l -> l.withPosition(new Vec3(-1.5, 3, 1.2))),
                s -> s.withWorld(s.world().withOwn(own -> own.withIntensity(0))),
                light("key", l -> l.withPosition(new Vec3(1, 3, 1.5))), light("spot", l -> l.withOn(false)),
                s -> s.withWorld(s.world().withOwn(own -> own.withIntensity(1)).withAmbience(0))));
    }
}
