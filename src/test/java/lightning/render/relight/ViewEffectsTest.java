package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.sample.Session;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import lightning.scene.World;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;
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

    /** A floor seen from above, lit from above through a ball. */
    private static Scene floor(Rgb reflective, Optional<TextureMap> texture) {
        Material material = Material.of("m").withDiffuse(Rgb.WHITE).withShininess(1).withReflective(reflective).withTexture(texture);
        return new Scene(new Picture(9, 9, 3), new Camera(new Vec3(0, 4, 0), Vec3.ZERO, new Vec3(0, 0, 1), 20),
                new World(1, RED), List.of(material),
                List.of(new Shape(Solid.PLANE, "floor", "m", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(9, 1, 9))),
                        new Shape(Solid.SPHERE, "ball", "m", new Placement(new Vec3(0, 8, 0), Vec3.ZERO, Vec3.ONE))),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withColor(new Rgb(0, 0.5, 0))));
    }

    private static Update render(Scene scene, ViewEffects view, Film[] film) {
        try (Renderer renderer = new Renderer(Options.DEFAULT.withThreads(1).withView(view))) {
            Update update = renderer.render(scene, Progress.NONE);
            film[0] = renderer.film();
            return update;
        }
    }

    @Provide
    Arbitrary<List<Set<Effect>>> hidden() {
        return Arbitraries.of(Effect.ALL).set().list().ofSize(13);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void hiddenEffects_areAReRenderOfTheSceneWithoutThem(@ForAll("sessions") Session session,
            @ForAll("hidden") List<Set<Effect>> hidden) {
        try (Renderer renderer = new Renderer(Options.DEFAULT.withReflections(Reflections.CURRENT).withThreads(1))) {
            for (int step = 0; step < session.scenes().size(); step++) {
                Set<Effect> hides = new HashSet<>();
                hides.addAll(hidden.get(step));
                hides.remove(Effect.SHADOWS);
                ViewEffects view = ViewEffects.ALL.hiding(hides);
                renderer.change(renderer.options().withView(view));
                Scene scene = session.scenes().get(step);
                String plan = renderer.render(scene, Progress.NONE).plan().text();
                SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(view.of(scene)).trace(), "hidden", session, step,
                        plan + ", without " + hides);
            }
        }
    }

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    @Test
    void hiddenShadows_areShownAgain() {
        Scene scene = floor(Rgb.BLACK, Optional.empty());
        try (Renderer renderer = new Renderer(Options.DEFAULT)) {
            renderer.change(renderer.options().withView(ViewEffects.ALL.hiding(Set.of(Effect.SHADOWS))));
            renderer.render(scene, Progress.NONE);
            assertThat(renderer.film().green(4, 4)).isEqualTo(0.5f);
            renderer.change(renderer.options().withView(ViewEffects.ALL));
            renderer.render(scene, Progress.NONE);
            assertThat(renderer.film().green(4, 4)).isZero();
        }
    }

    @Test
    void withoutShadows_blockedRowsAreLitAndNoRayIsCast() {
        Film[] film = new Film[1];
        Scene scene = floor(Rgb.BLACK, Optional.empty());
        render(scene, ViewEffects.ALL, film);
        assertThat(film[0].green(4, 4)).isZero();
        Update update = render(scene, ViewEffects.ALL.hiding(Set.of(Effect.SHADOWS)), film);
        assertThat(film[0].green(4, 4)).isEqualTo(0.5f);
        assertThat(update.rays().shadow()).isZero();
    }

    @Test
    void withoutReflections_reflectivityCountsAsZero() {
        Film[] film = new Film[1];
        Scene scene = floor(Rgb.grey(0.5), Optional.empty());
        Update update = render(scene, ViewEffects.ALL.hiding(Set.of(Effect.SHADOWS, Effect.REFLECTION)), film);
        assertThat(film[0].green(0, 0)).isEqualTo(0.5f);
        assertThat(film[0].red(0, 0)).isZero();
        assertThat(update.rays().mirrored()).isZero();
    }

    @Test
    void unlitTextures_showTheirOwnColour() {
        Texture blue = new Texture(1, 1, new float[] {0, 0, 0.25f});
        Film[] film = new Film[1];
        render(floor(Rgb.BLACK, Optional.of(new TextureMap("t.png", 1, 1, blue))), ViewEffects.PREVIEW_1998, film);
        assertThat(film[0].blue(4, 4)).isEqualTo(0.25f);
        assertThat(film[0].green(4, 4)).isZero();
    }
}
