package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.shading.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.Clarity;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.ShadowsThrown;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.World;
import org.junit.jupiter.api.Test;

/**
 * Each edit of what light passes asks again only ways that can meet it: rays counted. The picture is two tiles side by side, of a floor; a
 * pane hangs over the left one, higher than the eye.
 */
class TintedShadowWorkTest {
    private static final int TILE = 32 * 32;
    private static final Clarity GREEN = Clarity.NONE.withClear(new Rgb(0.25, 1, 0.5)).withThin(true).withShadows(ShadowsThrown.TINTED);

    private static Scene scene() {
        return new Scene(new Picture(64, 32, 1), new Camera(new Vec3(0, 10, 0), Vec3.ZERO, new Vec3(0, 0, -1), 20), World.DEFAULT,
                List.of(Material.of("floor").withDiffuse(Rgb.grey(0.7)), Material.of("glass").withDiffuse(Rgb.BLACK).withClarity(GREEN)),
                List.of(square("floor", "floor", Vec3.ZERO, 40), square("pane", "glass", new Vec3(-2, 12, 0), 2)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0))));
    }

    private static Shape square(String name, String material, Vec3 at, double size) {
        return new Shape(Solid.PLANE, name, material, new Placement(at, Vec3.ZERO, new Vec3(size, 1, size)));
    }

    private static Studio studio() {
        return new Studio(Reflections.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static Update render(Studio studio, Scene scene) {
        Update update = studio.render(scene);
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "tinted-shadow-work");
        return update;
    }

    private static Update edit(Studio studio, UnaryOperator<Clarity> edit) {
        Material glass = studio.scene().material("glass").orElseThrow();
        return render(studio, studio.scene().withMaterial(glass.withClarity(edit.apply(glass.clarity()))));
    }

    private static Update light(Studio studio, UnaryOperator<Light> edit) {
        return render(studio, studio.scene().withLight(edit.apply(studio.scene().lights().getFirst())));
    }

    @Test
    void colourOfTheLight_castsNothing() {
        try (Studio studio = studio()) {
            Update update = light(studio, l -> l.withColor(new Rgb(1, 0.5, 0.2)).withIntensity(0.4));
            assertThat(update.rays().shadow() + update.rays().eye()).as(update.plan().text()).isZero();
        }
    }

    @Test
    void colourOfTheGlass_asksWaysThatMeetItAndNoEyeRay() {
        try (Studio studio = studio()) {
            Update update = edit(studio, c -> c.withClear(new Rgb(1, 0.5, 0.5)));
            assertThat(update.rays().eye()).as(update.plan().text()).isZero();
            assertThat(update.rays().shadow()).isPositive().isLessThan(TILE);
        }
    }

    @Test
    void tintOfAPane_isNoWork() {
        try (Studio studio = studio()) {
            Update update = edit(studio, c -> c.withClear(GREEN.clear()));
            assertThat(update.rays().shadow() + update.rowsTouched()).isZero();
        }
    }

    @Test
    void fullShadows_andTintedOnesAgain() {
        try (Studio studio = studio()) {
            assertThat(edit(studio, c -> c.withShadows(ShadowsThrown.FULL)).rays().shadow()).isPositive().isLessThan(TILE);
            assertThat(edit(studio, c -> c.withShadows(ShadowsThrown.TINTED)).rays().shadow()).isPositive().isLessThan(TILE);
        }
    }

    /** 12 bytes for each row of the tile under the glass, and of no other. */
    @Test
    void tileWithoutGlass_keepsNoTint() {
        try (Studio tinted = studio(); Studio free = studio()) {
            edit(free, c -> c.withShadows(ShadowsThrown.NONE));
            assertThat(tinted.renderer().cache().bytes() - free.renderer().cache().bytes()).isEqualTo(12L * TILE);
        }
    }

    @Test
    void lightThatMoves_isComputedAnew() {
        try (Studio studio = studio()) {
            light(studio, l -> l.withDirection(new Vec3(0.1, -1, 0)));
            light(studio, l -> l.withType(LightType.POINT).withPosition(new Vec3(-2, 15, 0)));
            light(studio, l -> l.withArea(l.area().withRadius(0.5)));
        }
    }
}
