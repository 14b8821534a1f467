package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Lights that the camera sees. */
class VisibleLightTest {
    /** The camera looks at a rectangle, a farther disc, and a mirror that shows the back of a ball light. */
    private static final String ROOM = """
            jen 1
            picture { size 40 30  depth 2  %s }
            camera { from 0 1 6  to 0 1 0 }
            world { ambience 0 }
            material chrome { diffuse 0 0 0  specular 0 0 0  reflective 1 1 1 }
            plane floor { at 0 -1 0  scale 20 1 20 }
            sphere globe { material chrome  at 1.5 0 0 }
            light key rect { at 0 1 0  direction 0 0 1  width 1  height 1  falloff inverse_square  intensity 0.5  samples 4  visible yes }
            light ring disc { at -1.4 1 0  direction 0 0 1  radius 0.5  intensity 0.75  color 1 0.5 0.25  samples 4  visible yes }
            light lamp point { at 1.5 2.4 1  radius 0.2  intensity 0.25  samples 4  visible yes }
            """;

    private static Scene room(String indirect) throws Exception {
        return JenReader.read(ROOM.replace("%s", indirect), "room", Path.of("")).scene();
    }

    private static Scene edited(Scene scene, String edit) {
        return PropertyEdit.apply(scene, edit);
    }

    private static float[] pixel(Scene scene, int x, int y) {
        return new ReferenceTracer(scene).pixel(x, y);
    }

    @Test
    void faces_areAsBrightAsTheirLights() throws Exception {
        Scene room = room("");
        assertThat(pixel(room, 20, 15)).containsExactly((float) (0.5 * Math.PI), (float) (0.5 * Math.PI), (float) (0.5 * Math.PI));
        assertThat(pixel(room, 12, 15)).containsExactly(0.75f, 0.375f, 0.1875f);
        assertThat(pixel(edited(room, "key.on=no"), 20, 15)).containsExactly(0, 0, 0);
    }

    /** Upper left red, upper right green, lower left blue, lower right white. */
    private static Texture quarters(float scale) {
        return new Texture(2, 2, new float[] {scale, 0, 0, 0, scale, 0, 0, 0, scale, scale, scale, scale});
    }

    private static Scene textured(Scene scene, String light, Texture image) {
        return scene.withLight(scene.light(light).orElseThrow().withTexture(Optional.of(new LightTexture("image.hdr", image))));
    }

    @Test
    void texture_isUprightOnTheFace_andEdgesDoNotBlend() throws Exception {
        Scene room = edited(edited(textured(room(""), "key", quarters(2)), "key.width=5"), "key.height=3.4");
        room = edited(edited(room, "lamp.visible=no"), "globe.at=9 0 0");
        float twice = (float) (0.5 * Math.PI / (5 * 3.4)) * 2;
        assertThat(pixel(room, 10, 8)).usingComparatorWithPrecision(1e-6f).containsExactly(twice, 0, 0);
        assertThat(pixel(room, 29, 8)).usingComparatorWithPrecision(1e-6f).containsExactly(0, twice, 0);
        assertThat(pixel(room, 10, 21)).usingComparatorWithPrecision(1e-6f).containsExactly(0, 0, twice);
        assertThat(pixel(room, 29, 21)).usingComparatorWithPrecision(1e-6f).containsExactly(twice, twice, twice);
    }

    @Test
    void up_rollsTheImageOfADisc() throws Exception {
        Scene room = edited(edited(textured(room(""), "ring", quarters(1)), "ring.color=1 1 1"), "ring.radius=0.8");
        Scene rolled = edited(room, "ring.up=0 -1 0");
        // Rolled by 180°, white is where red was.
        assertThat(pixel(room, 9, 13)[1]).isLessThan(pixel(room, 9, 13)[0]);
        assertThat(pixel(rolled, 9, 13)[1]).isGreaterThan(pixel(rolled, 9, 13)[0]);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(room, Progress.NONE);
            renderer.render(rolled, Progress.NONE);
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(rolled).trace())).isTrue();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "indirect { rays 16  spacing 4 }", "antialias edges"})
    void texturedFaces_haveTheBitsOfAFullTrace(String settings) throws Exception {
        Scene plain = room(settings);
        Scene one = textured(plain, "key", quarters(1));
        Scene both = textured(one, "ring", quarters(3));
        Scene dark = edited(both, "key.on=no");
        Scene other = textured(dark, "key", quarters(0.5f));
        Scene[] scenes = {plain, one, both, dark, other, edited(other, "key.on=yes"), edited(other, "ring.solo=yes"),
            edited(both, "key.visible=no"), edited(both, "key.at=0.2 1.1 0.3"), edited(both, "globe.at=1.4 0 0.2"), plain};
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
            for (Scene scene : scenes) {
                renderer.render(scene, Progress.NONE);
                assertThat(renderer.film().hasSameBits(new ReferenceTracer(scene).trace())).isTrue();
                assertThat(renderer.film().hasSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film())).isTrue();
            }
        }
    }

    @Test
    void backs_areInvisible() throws Exception {
        Scene room = room("");
        Scene turned = edited(edited(room, "key.direction=0 0 -1"), "ring.direction=0 0 -1");
        Scene hidden = edited(edited(turned, "key.visible=no"), "ring.visible=no");
        assertThat(pixel(turned, 20, 15)).isEqualTo(pixel(hidden, 20, 15));
        assertThat(pixel(turned, 12, 15)).isEqualTo(pixel(hidden, 12, 15));
    }

    @Test
    void cornersOfADisc_areInvisible() throws Exception {
        Scene room = edited(room(""), "ring.radius=0.9");
        Scene hidden = edited(room, "ring.visible=no");
        // The disc's bounds contain this pixel, the disc does not.
        assertThat(pixel(room, 5, 10)).isEqualTo(pixel(hidden, 5, 10));
        assertThat(pixel(room, 12, 11)).isNotEqualTo(pixel(hidden, 12, 11));
    }

    @Test
    void mirrors_showFaces() throws Exception {
        Scene room = room("");
        Scene without = edited(edited(edited(room, "key.visible=no"), "ring.visible=no"), "lamp.visible=no");
        assertThat(mirrorPixels(room)).isNotEqualTo(mirrorPixels(without));
    }

    /** Returns pixels of the globe only. */
    private static float[] mirrorPixels(Scene scene) {
        float[] red = new float[64];
        for (int i = 0; i < red.length; i++) {
            red[i] = pixel(scene, 27 + i % 8, 17 + i / 8)[0];
        }
        return red;
    }

    @Test
    void faces_lightAndShadowNothing() throws Exception {
        for (String indirect : new String[] {"", "indirect { rays 16  spacing 4 }"}) {
            Scene room = edited(room(indirect), "ring.on=no");
            Scene without = edited(room, "lamp.visible=no");
            assertThat(pixel(room, 3, 27)).isEqualTo(pixel(without, 3, 27));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"key.on=no", "key.exposure=1.3", "key.color=0.2 1 0.4", "lamp.solo=yes", "key.at=0.2 1.1 0.3",
        "key.direction=0.3 -0.2 1", "key.width=2", "ring.radius=0.3", "key.visible=no", "key.name=other", "ring.falloff=inverse_square",
        "lamp.radius=0", "lamp.radius=0.5", "lamp.type=disc", "key.type=spot", "globe.at=1.4 0 0.2", "key.samples=8",
        "camera.from=0 1 5", "world.meters=3"})
    void edits_haveTheBitsOfAFullTrace(String edit) throws Exception {
        for (String settings : new String[] {"", "indirect { rays 16  spacing 4 }", "antialias edges"}) {
            Scene before = room(settings);
            Scene after = edited(before, edit);
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1)); WorkerPool workers = new WorkerPool(1)) {
                renderer.render(before, Progress.NONE);
                renderer.render(after, Progress.NONE);
                assertThat(renderer.film().hasSameBits(new ReferenceTracer(after).trace())).isTrue();
                assertThat(renderer.film().hasSameBits(new TraditionalTracer(after).trace(workers, Progress.NONE).film())).isTrue();
                renderer.render(before, Progress.NONE);
                assertThat(renderer.film().hasSameBits(new ReferenceTracer(before).trace())).isTrue();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"key.on=no", "key.exposure=1.3", "key.temperature=3000", "lamp.solo=yes", "key.unit=nit"})
    void editsOfTheColor_castNoRay(String edit) throws Exception {
        Scene before = room("");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            assertThat(renderer.render(edited(before, edit), Progress.NONE).rays()).isEqualTo(RayCounts.NONE);
        }
    }

    @Test
    void editsOfTheTexture_castNoRay() throws Exception {
        Scene plain = room("");
        Scene one = textured(plain, "key", quarters(1));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(plain, Progress.NONE);
            for (Scene scene : new Scene[] {one, edited(one, "key.color=0.2 1 0.4"), textured(one, "key", quarters(3)), plain}) {
                assertThat(renderer.render(scene, Progress.NONE).rays()).isEqualTo(RayCounts.NONE);
            }
        }
    }

    /** Only camera and mirrored rays that can meet the face are cast again, with the shadow rays of their new hits. */
    @Test
    void hiddenFace_repeatsFewRays() throws Exception {
        Scene before = room("");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            RayCounts all = renderer.render(before, Progress.NONE).rays();
            RayCounts some = renderer.render(edited(before, "lamp.visible=no"), Progress.NONE).rays();
            assertThat(some.eye()).isBetween(1L, all.eye() / 4);
            assertThat(some.shadow()).isLessThan(all.shadow() / 4);
        }
    }
}
