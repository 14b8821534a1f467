package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.shading.ReferenceTracer;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Relief;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import lightning.scene.World;
import org.junit.jupiter.api.Test;

/**
 * Each edit of a relief traces again only where rays can meet its shapes: rays counted. The picture is two tiles side by side; a rough ball
 * stands in the left one, a smooth one in the right.
 */
class ReliefWorkTest {
    private static final Vec3 LEFT = new Vec3(-3.5, 0, 0);
    private static final Vec3 RIGHT = new Vec3(3.5, 0, 0);
    private static final TextureMap HEIGHTS = new TextureMap("heights.png", 2, 3,
            new Texture(2, 2, new float[] {0, 0, 0, 1, 1, 1, 0.5f, 0.5f, 0.5f, 0.2f, 0.2f, 0.2f}));

    private static Scene scene() {
        Relief relief = Relief.NONE.withBump(Optional.of(HEIGHTS)).withHeight(0.2);
        return new Scene(new Picture(64, 32, 1), new Camera(new Vec3(0, 0, 20), Vec3.ZERO, Vec3.Y, 20), World.DEFAULT,
                List.of(Material.of("rough").withDiffuse(Rgb.grey(0.7)).withRelief(relief),
                        Material.of("smooth").withDiffuse(Rgb.grey(0.7))),
                List.of(ball("left", "rough", LEFT), ball("right", "smooth", RIGHT)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, -0.5))));
    }

    private static Shape ball(String name, String material, Vec3 at) {
        return new Shape(Solid.SPHERE, name, material, new Placement(at, Vec3.ZERO, Vec3.ONE));
    }

    private static Studio studio() {
        return new Studio(Reflections.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static Update edit(Studio studio, String material, Relief relief) {
        Update update = studio.render(studio.scene().withMaterial(studio.scene().material(material).orElseThrow().withRelief(relief)));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "relief-work");
        return update;
    }

    private static Relief relief(Studio studio) {
        return studio.scene().material("rough").orElseThrow().relief();
    }

    @Test
    void otherHeight_tracesTheRaysThatMayMeetItAndNoOther() {
        try (Studio studio = studio()) {
            assertThat(edit(studio, "rough", relief(studio).withHeight(-0.1)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void reliefThatGoes_tracesTheRaysThatMetIt() {
        try (Studio studio = studio()) {
            assertThat(edit(studio, "rough", Relief.NONE).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void reliefThatComes_tracesTheRaysThatMayMeetIt() {
        try (Studio studio = studio()) {
            assertThat(edit(studio, "smooth", relief(studio)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), RIGHT));
        }
    }

    /** A way to a light meets what it met: no bump moves a point. */
    @Test
    void relief_asksNoWayToALightElsewhere() {
        try (Studio studio = studio()) {
            Update update = edit(studio, "rough", Relief.NONE);
            Predicate<SurfacePoint> facing = studio.seen().facing(studio.scene().lights().getFirst());
            assertThat(update.rays().shadow()).isEqualTo(studio.seen().count(0, facing.and(row -> row.px() < 0)));
        }
    }

    @Test
    void heightsThatShowTheSame_traceNothing() {
        try (Studio studio = studio()) {
            Relief renamed = relief(studio).withBump(Optional.of(new TextureMap("copy.png", 2, 3, HEIGHTS.image())));
            Update update = edit(studio, "rough", renamed);
            assertThat(update.rays().eye() + update.rays().shadow()).as(update.plan().text()).isZero();
        }
    }

    @Test
    void strengthWithoutNormals_isNoWorkAtAll() {
        try (Studio studio = studio()) {
            Update update = edit(studio, "rough", relief(studio).withStrength(3));
            assertThat(update.rowsTouched() + update.rowsComposed()).as(update.plan().text()).isZero();
            assertThat(update.plan()).isNotInstanceOf(UpdatePlan.FirstPass.class);
        }
    }
}
