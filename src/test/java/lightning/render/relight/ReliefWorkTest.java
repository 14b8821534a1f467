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
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/**
 * Tests by ray counts that each edit of a relief retraces only rays that can meet its shapes. The picture is two tiles side by
 * side: a rough sphere in the left one, a smooth one in the right.
 */
class ReliefWorkTest {
    private static final Vec3 LEFT = new Vec3(-3.5, 0, 0);
    private static final Vec3 RIGHT = new Vec3(3.5, 0, 0);
    private static final TextureMap HEIGHTS = new TextureMap("heights.png", 2, 3,
            new Texture(2, 2, new float[] {0, 0, 0, 1, 1, 1, 0.5f, 0.5f, 0.5f, 0.2f, 0.2f, 0.2f}));

    private static Scene scene() {
        BumpMapping relief = BumpMapping.NONE.withBump(Optional.of(HEIGHTS)).withHeight(0.2);
        return new Scene(new PictureSettings(64, 32, 1), new Camera(new Vec3(0, 0, 20), Vec3.ZERO, Vec3.Y, 20), World.DEFAULT,
                List.of(Material.of("rough").withDiffuse(Rgb.gray(0.7)).withBumpMapping(relief),
                        Material.of("smooth").withDiffuse(Rgb.gray(0.7))),
                List.of(ball("left", "rough", LEFT), ball("right", "smooth", RIGHT)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, -0.5))));
    }

    private static Shape ball(String name, String material, Vec3 at) {
        return new Shape(Solid.SPHERE, name, material, new Placement(at, Vec3.ZERO, Vec3.ONE));
    }

    private static StudioRenderer studio() {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static UpdateResult edit(StudioRenderer studio, String material, BumpMapping relief) {
        UpdateResult update =
                studio.render(studio.scene().withMaterial(studio.scene().material(material).orElseThrow().withBumpMapping(relief)));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "relief-work");
        return update;
    }

    private static BumpMapping relief(StudioRenderer studio) {
        return studio.scene().material("rough").orElseThrow().bumpMapping();
    }

    @Test
    void changedHeight_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "rough", relief(studio).withHeight(-0.1)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void removedRelief_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "rough", BumpMapping.NONE).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void addedRelief_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "smooth", relief(studio)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), RIGHT));
        }
    }

    /** Shadow rays keep their results: no bump moves a point. */
    @Test
    void relief_castsNoUnaffectedShadowRays() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, "rough", BumpMapping.NONE);
            Predicate<SurfacePoint> facing = studio.referenceRows().isFacing(studio.scene().lights().getFirst());
            assertThat(update.rays().shadow()).isEqualTo(studio.referenceRows().count(0, facing.and(row -> row.px() < 0)));
        }
    }

    @Test
    void equalHeights_traceNothing() {
        try (StudioRenderer studio = studio()) {
            BumpMapping renamed = relief(studio).withBump(Optional.of(new TextureMap("copy.png", 2, 3, HEIGHTS.image())));
            UpdateResult update = edit(studio, "rough", renamed);
            assertThat(update.rays().eye() + update.rays().shadow()).as(update.plan().description()).isZero();
        }
    }

    @Test
    void strengthWithoutNormalMap_needsNoWork() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, "rough", relief(studio).withStrength(3));
            assertThat(update.rowsTouched() + update.rowsComposed()).as(update.plan().description()).isZero();
            assertThat(update.plan()).isNotInstanceOf(UpdatePlan.FirstPass.class);
        }
    }
}
