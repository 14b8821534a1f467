package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
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
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/**
 * Tests the ray counts of each edit of a clear material. The picture is two tiles side by side: a glass sphere in the left one, a
 * stone in the right.
 */
class ClearMaterialWorkTest {
    private static final Vec3 LEFT = new Vec3(-3.5, 0, 0);
    private static final Vec3 RIGHT = new Vec3(3.5, 0, 0);
    private static final Transmission GLASS = Transmission.NONE.withColor(new Rgb(0.9, 1, 0.8)).withTint(Rgb.gray(0.7));

    private static Scene scene() {
        return new Scene(new PictureSettings(64, 32, 3), new Camera(new Vec3(0, 0, 20), Vec3.ZERO, Vec3.Y, 20), World.DEFAULT,
                List.of(Material.of("glass").withDiffuse(Rgb.gray(0.7)).withTransmission(GLASS), Material.of("stone")),
                List.of(ball("left", "glass", LEFT), ball("right", "stone", RIGHT)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(1, -0.1, -0.05))));
    }

    private static Shape ball(String name, String material, Vec3 at) {
        return new Shape(Solid.SPHERE, name, material, new Placement(at, Vec3.ZERO, Vec3.ONE));
    }

    private static StudioRenderer studio() {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static UpdateResult edit(StudioRenderer studio, String material, UnaryOperator<Transmission> change) {
        Material before = studio.scene().material(material).orElseThrow();
        UpdateResult update = studio.render(studio.scene().withMaterial(before.withTransmission(change.apply(before.transmission()))));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "clear-work");
        return update;
    }

    private static void assertOnlyComposes(UnaryOperator<Transmission> change) {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, "glass", change);
            assertThat(update.rays().total()).as(update.plan().description()).isZero();
            assertThat(update.rowsComposed()).isPositive();
        }
    }

    @Test
    void clearColor_onlyComposes() {
        assertOnlyComposes(c -> c.withColor(new Rgb(0.2, 0.3, 1)));
    }

    @Test
    void tint_onlyComposes() {
        assertOnlyComposes(c -> c.withTint(new Rgb(0.2, 0.3, 1)).withTintDistance(0.3));
    }

    @Test
    void ior_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "glass", c -> c.withIor(1.2)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void thin_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "glass", c -> c.withThin(true)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), LEFT));
        }
    }

    @Test
    void clarityToggle_retracesOnlyAffectedRays() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, "stone", c -> c.withColor(Rgb.WHITE)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), RIGHT));
            assertThat(edit(studio, "stone", c -> c.withColor(Rgb.BLACK)).rays().eye()).isEqualTo(BallBoxes.eyeRays(scene(), RIGHT));
        }
    }

    @Test
    void iorOfOpaqueMaterial_needsNoWork() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, "stone", c -> c.withIor(1.2).withThin(true).withTintDistance(3));
            assertThat(update.rays().total() + update.rowsTouched()).as(update.plan().description()).isZero();
            assertThat(update.plan()).isNotInstanceOf(UpdatePlan.FirstPass.class);
        }
    }

    /** The sun shines from the left: the stone is in the glass's shadow. */
    @Test
    void removedShadows_castOnlyForBlockedRows() {
        try (StudioRenderer studio = studio()) {
            Predicate<SurfacePoint> shadowed = studio.referenceRows().isShadowed(studio.scene().lights().getFirst());
            long rows = studio.referenceRows().count(0, shadowed.and(row -> row.px() > 0));
            assertThat(rows).isPositive();
            UpdateResult update = edit(studio, "glass", c -> c.withShadows(ShadowCasting.NONE));
            assertThat(update.rays().eye() + update.rays().mirrored()).isZero();
            assertThat(update.rays().shadow()).isPositive();
            assertThat(studio.renderer().cache().allTiles().getLast().levels()[0].layers()[0].litCount())
                    .isGreaterThanOrEqualTo((int) rows);
        }
    }

    @Test
    void opaqueTile_hasNoClearColumns() {
        try (StudioRenderer studio = studio()) {
            assertThat(studio.renderer().cache().tile(0).rows().backX).isNotNull();
            assertThat(studio.renderer().cache().tile(1).rows().backX).isNull();
            assertThat(studio.renderer().cache().tile(1).images()).isNull();
        }
    }
}
