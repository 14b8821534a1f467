package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

@Slow
class ViewEffectsTest {
    private static final Rgb RED = new Rgb(1, 0, 0);

    /** Floor seen from above, lit from above through a sphere. */
    private static Scene floor(Rgb reflective, Optional<TextureMap> texture) {
        Material material = Material.of("m").withDiffuse(Rgb.WHITE).withShininess(1).withReflective(reflective).withTexture(texture);
        return new Scene(new PictureSettings(9, 9, 3), new Camera(new Vec3(0, 4, 0), Vec3.ZERO, new Vec3(0, 0, 1), 20),
                new World(1, RED), List.of(material),
                List.of(new Shape(Solid.PLANE, "floor", "m", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9))),
                        new Shape(Solid.SPHERE, "ball", "m", new Placement(new Vec3(0, 8, 0), Vec3.ZERO, Vec3.ONE))),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withColor(new Rgb(0, 0.5, 0))));
    }

    private static UpdateResult render(Scene scene, ViewEffects view, Film[] film) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1).withView(view))) {
            UpdateResult update = renderer.render(scene, Progress.NONE);
            film[0] = renderer.film();
            return update;
        }
    }

    @Provide
    Arbitrary<List<Set<RenderEffect>>> hidden() {
        return Arbitraries.of(RenderEffect.ALL).set().list().ofSize(13);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void hiddenEffects_equalSceneWithoutThem(@ForAll("sessions") EditSession session,
            @ForAll("hidden") List<Set<RenderEffect>> hidden) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.CURRENT).withThreads(1))) {
            for (int step : session.steps()) {
                Set<RenderEffect> hides = new HashSet<>();
                hides.addAll(hidden.get(step));
                hides.remove(RenderEffect.SHADOWS);
                ViewEffects view = ViewEffects.ALL.withHidden(hides);
                renderer.setOptions(renderer.options().withView(view));
                Scene scene = session.scenes().get(step);
                String plan = renderer.render(scene, Progress.NONE).plan().description();
                SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(view.apply(scene)).trace(), "hidden", session, step,
                        plan + ", without " + hides);
            }
        }
    }

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    @Test
    void hiddenShadows_areShownAgain() {
        Scene scene = floor(Rgb.BLACK, Optional.empty());
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.setOptions(renderer.options().withView(ViewEffects.ALL.withHidden(Set.of(RenderEffect.SHADOWS))));
            renderer.render(scene, Progress.NONE);
            assertThat(renderer.film().green(4, 4)).isEqualTo(0.5f);
            renderer.setOptions(renderer.options().withView(ViewEffects.ALL));
            renderer.render(scene, Progress.NONE);
            assertThat(renderer.film().green(4, 4)).isZero();
        }
    }

    @Test
    void hiddenShadows_lightBlockedRowsWithoutRays() {
        Film[] film = new Film[1];
        Scene scene = floor(Rgb.BLACK, Optional.empty());
        render(scene, ViewEffects.ALL, film);
        assertThat(film[0].green(4, 4)).isZero();
        UpdateResult update = render(scene, ViewEffects.ALL.withHidden(Set.of(RenderEffect.SHADOWS)), film);
        assertThat(film[0].green(4, 4)).isEqualTo(0.5f);
        assertThat(update.rays().shadow()).isZero();
    }

    @Test
    void hiddenReflections_ignoreReflectivity() {
        Film[] film = new Film[1];
        Scene scene = floor(Rgb.gray(0.5), Optional.empty());
        UpdateResult update = render(scene, ViewEffects.ALL.withHidden(Set.of(RenderEffect.SHADOWS, RenderEffect.REFLECTION)), film);
        assertThat(film[0].green(0, 0)).isEqualTo(0.5f);
        assertThat(film[0].red(0, 0)).isZero();
        assertThat(update.rays().mirrored()).isZero();
    }

    @Test
    void unlitTextures_showTextureColor() {
        Texture blue = new Texture(1, 1, new float[] {0, 0, 0.25f});
        Film[] film = new Film[1];
        render(floor(Rgb.BLACK, Optional.of(new TextureMap("t.png", 1, 1, blue))), ViewEffects.PREVIEW_1998, film);
        assertThat(film[0].blue(4, 4)).isEqualTo(0.25f);
        assertThat(film[0].green(4, 4)).isZero();
    }
}
