package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/**
 * Tests by ray counts that each edit of a clear shape recasts only shadow rays that can meet it. The picture is two tiles of a
 * floor side by side; a pane hangs above the left one, higher than the camera.
 */
class TintedShadowWorkTest {
    private static final int TILE = 32 * 32;
    private static final Transmission GREEN =
            Transmission.NONE.withColor(new Rgb(0.25, 1, 0.5)).withThin(true).withShadows(ShadowCasting.TINTED);

    private static Scene scene() {
        return new Scene(new PictureSettings(64, 32, 1), new Camera(new Vec3(0, 10, 0), Vec3.ZERO, new Vec3(0, 0, -1), 20), World.DEFAULT,
                List.of(Material.of("floor").withDiffuse(Rgb.gray(0.7)),
                        Material.of("glass").withDiffuse(Rgb.BLACK).withTransmission(GREEN)),
                List.of(square("floor", "floor", Vec3.ZERO, 40), square("pane", "glass", new Vec3(-2, 12, 0), 2)),
                List.of(Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0))));
    }

    private static Shape square(String name, String material, Vec3 at, double size) {
        return new Shape(Solid.PLANE, name, material, new Placement(at, Vec3.ZERO, new Vec3(size, 1, size)));
    }

    private static StudioRenderer studio() {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene());
    }

    private static UpdateResult render(StudioRenderer studio, Scene scene) {
        UpdateResult update = studio.render(scene);
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "tinted-shadow-work");
        return update;
    }

    private static UpdateResult edit(StudioRenderer studio, UnaryOperator<Transmission> edit) {
        Material glass = studio.scene().material("glass").orElseThrow();
        return render(studio, studio.scene().withMaterial(glass.withTransmission(edit.apply(glass.transmission()))));
    }

    private static UpdateResult light(StudioRenderer studio, UnaryOperator<Light> edit) {
        return render(studio, studio.scene().withLight(edit.apply(studio.scene().lights().getFirst())));
    }

    /**
     * A row in the plane of a rectangle is behind some of its samples by rounding. These count neither in a first trace nor after an edit of the
     * glass, although the row faces them.
     */
    @Test
    void rowInPlaneOfRectangle_countsSamplesInFrontOfIt() {
        Vec3 at = new Vec3(1, 2, 0.3);
        Random random = new Random(3);
        for (int i = 0; i < 40; i++) {
            // The row is lifted off the floor by a rounding of its distance.
            Vec3 direction = at.minus(new Vec3(0, 10 - 9.999999f, 0))
                    .cross(new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble() - 0.5)).normalized();
            Light light = Light.of("sun", LightType.RECT).withPosition(at).withDirection(direction)
                    .withArea(AreaShape.DEFAULT.withWidth(1.5).withHeight(1.5).withSamples(16));
            Scene scene = scene().withPicture(new PictureSettings(3, 3, 1)).withLights(List.of(light)).withNodes(
                    List.of(square("floor", "floor", Vec3.ZERO, 40),
                            new Shape(Solid.SPHERE, "pane", "glass",
                                    new Placement(new Vec3(0.4, 1, 0.15), Vec3.ZERO, Vec3.ONE.times(0.3)))));
            try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene)) {
                FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(scene).trace(), "tinted-shadow-work");
                edit(studio, t -> t.withColor(new Rgb(1, 0.3, 0.2)));
                assertThat(new PixelExplainer(studio.scene()).explainPixel(1, 1).color())
                        .isEqualTo(new ReferenceTracer(studio.scene()).pixel(1, 1));
            }
        }
    }

    @Test
    void lightColor_castsNoRays() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = light(studio, l -> l.withColor(new Rgb(1, 0.5, 0.2)).withIntensity(0.4));
            assertThat(update.rays().shadow() + update.rays().eye()).as(update.plan().description()).isZero();
        }
    }

    @Test
    void glassColor_castsOnlyShadowRaysThroughIt() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, c -> c.withColor(new Rgb(1, 0.5, 0.5)));
            assertThat(update.rays().eye()).as(update.plan().description()).isZero();
            assertThat(update.rays().shadow()).isPositive().isLessThan(TILE);
        }
    }

    @Test
    void paneTint_needsNoWork() {
        try (StudioRenderer studio = studio()) {
            UpdateResult update = edit(studio, c -> c.withColor(GREEN.color()));
            assertThat(update.rays().shadow() + update.rowsTouched()).isZero();
        }
    }

    @Test
    void shadowMode_switchesBackAndForth() {
        try (StudioRenderer studio = studio()) {
            assertThat(edit(studio, c -> c.withShadows(ShadowCasting.FULL)).rays().shadow()).isPositive().isLessThan(TILE);
            assertThat(edit(studio, c -> c.withShadows(ShadowCasting.TINTED)).rays().shadow()).isPositive().isLessThan(TILE);
        }
    }

    /** 12 bytes for each row of the tile under the glass, and for no other row. */
    @Test
    void tileWithoutGlass_storesNoTint() {
        try (StudioRenderer tinted = studio(); StudioRenderer free = studio()) {
            edit(free, c -> c.withShadows(ShadowCasting.NONE));
            assertThat(tinted.renderer().cache().bytes() - free.renderer().cache().bytes()).isEqualTo(12L * TILE);
        }
    }

    @Test
    void movedLight_isRecomputed() {
        try (StudioRenderer studio = studio()) {
            light(studio, l -> l.withDirection(new Vec3(0.1, -1, 0)));
            light(studio, l -> l.withType(LightType.POINT).withPosition(new Vec3(-2, 15, 0)));
            light(studio, l -> l.withArea(l.area().withRadius(0.5)));
        }
    }

    private static Scene withLid(boolean visible) {
        List<SceneNode> nodes = new ArrayList<>(scene().nodes());
        nodes.add(square("lid", "floor", new Vec3(-2, 13, 0), 2).withVisible(visible));
        return scene().withNodes(nodes);
    }

    @Test
    void hiddenLidAboveGlass_leavesTintedLight() {
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, withLid(true))) {
            assertThat(render(studio, withLid(false)).rays().shadow()).isPositive().isLessThan(TILE);
        }
    }

    /** The lid shadows the same rows that the glass tints. */
    @Test
    void lidAndGlassColor_castOneRayPerRow() {
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, withLid(false))) {
            long tinted = edit(studio, c -> c.withColor(new Rgb(1, 0.5, 0.5))).rays().shadow();
            Scene covered = withLid(true);
            assertThat(render(studio, covered).rays().shadow()).isEqualTo(tinted);
        }
    }

    @Test
    void coneGrowingUnderGlass_isTinted() {
        try (StudioRenderer studio = studio()) {
            light(studio, l -> l.withType(LightType.SPOT).withPosition(new Vec3(-2, 15, 0)).withAngle(2));
            light(studio, l -> l.withAngle(8));
            light(studio, l -> l.withAngle(1));
            light(studio, l -> l.withAngle(30));
        }
    }

    @Test
    void shapeShownUnderGlass_isTintedAndLeavesOtherTints() {
        List<SceneNode> nodes = new ArrayList<>(scene().nodes());
        nodes.add(square("tile", "floor", new Vec3(-3, 1, 0), 1).withVisible(false));
        Scene before = scene().withNodes(nodes);
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, before)) {
            Scene shown = before.withNode("tile", nodes.getLast().withVisible(true));
            render(studio, shown);
            render(studio, shown.withNode("pane", shown.stage().node("pane").orElseThrow().withVisible(false)));
            render(studio, before);
        }
    }
}
