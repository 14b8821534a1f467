package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/**
 * Tests by ray counts that each edit of a cutout retraces only rays that can meet its shapes. The picture is two tiles side by
 * side: a sphere with holes in the left one, a whole one in the right.
 */
class CutoutWorkTest {
    private static final Vec3 LEFT = new Vec3(-3.5, 0, 0);
    private static final Vec3 RIGHT = new Vec3(3.5, 0, 0);
    private static final TextureMap THERE = new TextureMap("there.png", 2, 3,
            new Texture(2, 2, new float[] {0, 0, 0, 1, 1, 1, 0.5f, 0.5f, 0.5f, 0.2f, 0.2f, 0.2f}));

    private static Scene scene() {
        AlphaCutout cutout = AlphaCutout.NONE.withMap(Optional.of(THERE));
        return new Scene(new PictureSettings(64, 32, 1), new Camera(new Vec3(0, 0, 20), Vec3.ZERO, Vec3.Y, 20), World.DEFAULT,
                List.of(Material.of("cut").withDiffuse(Rgb.gray(0.7)).withCutout(cutout),
                        Material.of("whole").withDiffuse(Rgb.gray(0.7))),
                List.of(ball("left", "cut", LEFT), ball("right", "whole", RIGHT)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, -0.5))));
    }

    private static Shape ball(String name, String material, Vec3 at) {
        return new Shape(Solid.SPHERE, name, material, new Placement(at, Vec3.ZERO, Vec3.ONE));
    }

    private static StudioRenderer studio() {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static UpdateResult edit(StudioRenderer studio, String material, AlphaCutout cutout) {
        UpdateResult update =
                studio.render(studio.scene().withMaterial(studio.scene().material(material).orElseThrow().withCutout(cutout)));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "cutout-work");
        return update;
    }

    private static AlphaCutout cutout(StudioRenderer studio) {
        return studio.scene().material("cut").orElseThrow().cutout();
    }

    @Test
    void changedCutoff_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "cut", cutout(studio).withCutoff(0.9)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void removedCutout_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "cut", AlphaCutout.NONE).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void addedCutout_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "whole", cutout(studio)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), RIGHT));
        }
    }

    /** The sun is behind the camera: neither sphere can shadow the other. */
    @Test
    void cutout_castsNoUnaffectedShadowRays() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, "cut", AlphaCutout.NONE);
            Predicate<SurfacePoint> facing = studio.referenceRows().isFacing(studio.scene().lights().getFirst());
            assertThat(update.rays().shadow()).isEqualTo(studio.referenceRows().count(0, facing.and(row -> row.px() < 0)));
        }
    }

    @Test
    void equalCutoutImage_tracesNothing() {
        try (StudioRenderer studio = studio()) {
            AlphaCutout renamed = cutout(studio).withMap(Optional.of(new TextureMap("copy.png", 2, 3, THERE.image())));
            UpdateResult update = edit(studio, "cut", renamed);
            assertThat(update.rays().eye() + update.rays().shadow()).as(update.plan().description()).isZero();
        }
    }

    @Test
    void cutoffWithoutImage_needsNoWork() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, "whole", AlphaCutout.NONE.withCutoff(0.2));
            assertThat(update.rowsTouched() + update.rowsComposed()).as(update.plan().description()).isZero();
            assertThat(update.plan()).isNotInstanceOf(UpdatePlan.FirstPass.class);
        }
    }
}
