package lightning.render.relight;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests edits that show nothing while mirrors are updated on demand: mirrors then show an equal picture of a scene with other lights. */
class DarkLightsInStaleMirrorsTest {
    private final Scene scene = solo(StudioScene.of(LightType.POINT));

    private static Scene solo(Scene scene) {
        return scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withSolo(true));
    }

    private static Scene withDarkLight(Scene scene, int at) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(at, Light.of("dark", LightType.POINT).withPosition(new Vec3(1, 2, 3)));
        return scene.withLights(lights);
    }

    private static Scene moved(Scene scene) {
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        return scene.withLight(key.withPosition(key.position().plus(new Vec3(0, 0.5, 0))));
    }

    private void assertExact(MirrorStorage storage, Scene... edits) {
        try (var studio = new StudioRenderer(ReflectionMode.STALE, storage, scene)) {
            for (Scene edit : edits) {
                studio.render(edit);
                FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(edit, scene).trace(), "stale");
            }
            studio.renderer().updateReflections(Progress.NONE);
            Scene last = edits[edits.length - 1];
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(last).trace(), "updated");
            Scene brighter = last.withLight(last.light(StudioScene.KEY).orElseThrow().withColor(new Rgb(1, 0.5, 0.25)));
            studio.render(brighter);
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(brighter, last).trace(), "stale again");
        }
    }

    @ParameterizedTest
    @EnumSource
    void addedDarkLight_keepsThePicture(MirrorStorage storage) {
        assertExact(storage, withDarkLight(scene, scene.lights().size()));
        assertExact(storage, withDarkLight(scene, 0));
    }

    @ParameterizedTest
    @EnumSource
    void lightThatMovesBack_showsEqualMirrorsAgain(MirrorStorage storage) {
        for (int at : new int[] {0, scene.lights().size()}) {
            Scene dark = withDarkLight(scene, at);
            assertExact(storage, dark, moved(dark), dark);
            assertExact(storage, moved(scene), moved(dark), dark);
        }
    }

    @ParameterizedTest
    @EnumSource
    void removedDarkLight_keepsThePicture(MirrorStorage storage) {
        List<Light> others = scene.lights().stream().filter(l -> l.name().equals(StudioScene.KEY)).toList();
        Scene one = scene.withLights(others);
        assertExact(storage, one);
        assertExact(storage, one, moved(one), one);
    }

    /** An update of the reflections leaves a level without rows, which has no layer of a light that comes later. */
    @Test
    void addedLight_isExact_whereNothingMirrors() throws JenException {
        Scene matt = JenReader.read("""
                jen 1
                picture { size 8 8  depth 2 }
                plane floor { at 0 -1 0  scale 14 1 14 }
                light key point { at 0 3 0 }
                """, "matt.jen", Path.of("")).scene();
        Scene other = matt.withLight(matt.lights().getFirst().withPosition(new Vec3(0, 2, 0)));
        Scene two = other.withLights(List.of(other.lights().getFirst().withName("fill").withIntensity(0.3), other.lights().getFirst()));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflectionsOnRequest().withThreads(1))) {
            for (Scene edit : List.of(matt, other, two)) {
                renderer.render(edit, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edit).trace(), "matt");
                renderer.updateReflections(Progress.NONE);
            }
        }
    }
}
