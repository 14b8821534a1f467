package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.SceneWarnings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Materials that glow with a light. */
class BulbTest {
    private static final String ROOM = """
            jen 1
            picture { size 40 30  depth 2  %s }
            camera { from 0 1 6  to 0 1 0 }
            world { ambience 0 }
            material lamp { diffuse 0.2 0.2 0.2  bulb key  bulb_exposure -2  shadows none }
            plane floor { scale 20 1 20 }
            sphere globe { material lamp  at 0 1 0 }
            bank warm { color 1 0.5 0.25 }
            light key point { at 0 1 0  intensity 1  exposure 3  falloff inverse_square  bank warm }
            light fill point { at 5 5 5  intensity 0.2 }
            """;

    private static Scene room(String indirect) throws Exception {
        return JenReader.read(ROOM.replace("%s", indirect), "room", Path.of("")).scene();
    }

    private static Scene edited(Scene scene, String edit) {
        return PropertyEdit.apply(scene, edit);
    }

    @Test
    void glow_isTheLightsWeightTimesTheExposure() throws Exception {
        float[] before = new ReferenceTracer(edited(room(""), "key.on=no")).pixel(20, 15);
        float[] after = new ReferenceTracer(edited(room(""), "material:lamp.diffuse=0 0 0")).pixel(20, 15);
        assertThat(after).containsExactly(2f, 1f, 0.5f);
        assertThat(before[0]).isBetween(0f, 0.1f);
    }

    @ParameterizedTest
    @ValueSource(strings = {"key.on=no", "key.exposure=1.3", "key.color=0.2 1 0.4", "key.temperature=3000", "warm.intensity=0.3",
        "fill.solo=yes",
        "key.name=other", "material:lamp.bulb=fill", "material:lamp.bulb=none", "key.unit=lumen", "world.meters=3"})
    void edits_haveTheBitsOfAFullTrace(String edit) throws Exception {
        for (String indirect : new String[] {"", "indirect { rays 16  spacing 4 }"}) {
            Scene before = room(indirect);
            Scene after = edited(before, edit);
            try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
                renderer.render(before, Progress.NONE);
                renderer.render(after, Progress.NONE);
                assertThat(renderer.film().hasSameBits(new ReferenceTracer(after).trace())).isTrue();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"key.on=no", "key.exposure=1.3", "key.temperature=3000", "warm.intensity=0.3", "material:lamp.bulb=fill"})
    void editsOfTheLight_castNoRay(String edit) throws Exception {
        Scene before = room("");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            assertThat(renderer.render(edited(before, edit), Progress.NONE).rays()).isEqualTo(RayCounts.NONE);
        }
    }

    /** The light lights the room already: with its bulb's glow gathered too, the floor would be brighter. */
    @Test
    void glow_lightsNothing() throws Exception {
        Scene glowing = room("indirect { rays 16  spacing 4 }");
        Scene dark = edited(glowing, "material:lamp.bulb=none");
        assertThat(new ReferenceTracer(glowing).pixel(3, 27)).isEqualTo(new ReferenceTracer(dark).pixel(3, 27));
        assertThat(new ReferenceTracer(glowing).pixel(20, 15)).isNotEqualTo(new ReferenceTracer(dark).pixel(20, 15));
    }

    @Test
    void renamedLight_keepsItsBulb() throws Exception {
        Scene renamed = edited(room(""), "key.name=sun");
        assertThat(renamed.material("lamp").orElseThrow().bulb().light()).isEqualTo("sun");
        assertThat(renamed.material("lamp").orElseThrow().bulb().glow().isBlack()).isFalse();
    }

    @Test
    void missingLight_isReported() throws Exception {
        Scene missing = edited(room(""), "material:lamp.bulb=none");
        assertThat(SceneWarnings.of(missing)).isEmpty();
        assertThat(SceneWarnings.of(edited(missing, "material:lamp.bulb=kei"))).hasSize(1).first().asString().contains("kei");
    }
}
