package lightning.render.relight;

import static lightning.render.relight.StudioRenderer.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.ReferenceRows;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Tests by ray and row counts that each edit of shapes retraces only rays that can meet the old or the new shape.
 *
 * <p>The picture is two tiles side by side with a sphere in the center of each. The sun is above, so that no sphere shadows the
 * other. A third sphere above the right one, outside the picture, casts a shadow on it.
 */
class ObjectWorkTest {
    private static final int TILE = 32 * 32;
    private static final Vec3 LEFT = new Vec3(-3.5, 0, 0);
    private static final Vec3 RIGHT = new Vec3(3.5, 0, 0);
    private static final Light SUN = Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0));

    private static Scene scene(Light light) {
        return new Scene(new PictureSettings(64, 32, 1), new Camera(new Vec3(0, 0, 20), Vec3.ZERO, Vec3.Y, 20), World.DEFAULT,
                List.of(Material.of("matt").withDiffuse(Rgb.gray(0.7)), Material.of("glass").withReflective(Rgb.gray(0.5))),
                List.of(ball("left", LEFT.x(), 0), ball("right", RIGHT.x(), 0), ball("above", 3.5, 8)), List.of(light));
    }

    private static Shape ball(String name, double x, double y) {
        return new Shape(Solid.SPHERE, name, "matt", new Placement(new Vec3(x, y, 0), Vec3.ZERO, Vec3.ONE));
    }

    private static StudioRenderer studio(Scene scene) {
        return new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, scene);
    }

    private static UpdateResult edit(StudioRenderer studio, String name, UnaryOperator<SceneNode> change) {
        UpdateResult update = studio.render(studio.scene().withNode(name, change.apply(studio.scene().stage().node(name).orElseThrow())));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        return update;
    }

    private static SceneNode moved(SceneNode node, double x, double y, double z) {
        Placement p = node.placement();
        return node.withPlacement(new Placement(p.position().plus(new Vec3(x, y, z)), p.rotation(), p.scale()));
    }

    private static long eyeRays(Vec3... balls) {
        return BallBoxes.eyeRays(scene(SUN), balls);
    }

    private static long leftRows(ReferenceRows reference) {
        return reference.count(0, row -> row.px() < 0);
    }

    private static long facing(ReferenceRows reference, Light light, boolean left) {
        return reference.count(0, reference.isFacing(light).and(row -> row.px() < 0 == left));
    }

    private static void assertRays(UpdateResult update, long eye, long mirrored, long shadow) {
        assertThat(update.plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(update.rays().eye()).as("eye rays").isEqualTo(eye);
        assertThat(update.rays().mirrored()).as("mirrored rays").isEqualTo(mirrored);
        assertThat(update.rays().shadow()).as("shadow rays").isEqualTo(shadow);
    }

    private static final Light WIDE_SUN = SUN.withArea(SUN.area().withSpread(2));

    /** Places a shape above everything, outside the picture. */
    private static SceneNode roof(SceneNode node) {
        return node.withPlacement(new Placement(new Vec3(0, 60, 0), Vec3.ZERO, new Vec3(30, 30, 30)));
    }

    @Test
    void shapeHidingAreaLight_darkensTiles() {
        try (StudioRenderer studio = studio(scene(WIDE_SUN))) {
            edit(studio, "above", ObjectWorkTest::roof);
        }
    }

    @Test
    void areaLightSwitchedOffDuringMove_leavesNoLight() {
        try (StudioRenderer studio = studio(scene(WIDE_SUN))) {
            Scene moved = studio.scene().withNode("above", roof(studio.scene().stage().node("above").orElseThrow()));
            studio.render(moved.withLight(WIDE_SUN.withOn(false)));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void movedSphere_retracesOnlyItsBounds() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            UpdateResult update = edit(studio, "left", ball -> moved(ball, 0.25, 0, 0));
            assertRays(update, eyeRays(LEFT, LEFT.plus(new Vec3(0.25, 0, 0))), 0, facing(studio.referenceRows(), SUN, true));
            assertThat(update.rowsComposed()).isEqualTo(leftRows(studio.referenceRows()));
        }
    }

    @Test
    void transformedSphere_retracesOnlyItsBounds() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            UpdateResult update = edit(studio, "left", ball -> ball.withPlacement(
                    new Placement(ball.placement().position(), new Vec3(0, 30, 10), new Vec3(0.5, 1, 0.7))));
            assertRays(update, eyeRays(LEFT), 0, facing(studio.referenceRows(), SUN, true));
        }
    }

    @Test
    void hiddenSphere_retracesOnlyItsBounds() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            assertRays(edit(studio, "left", ball -> ball.withVisible(false)), eyeRays(LEFT), 0, 0);
            assertRays(edit(studio, "left", ball -> ball.withVisible(true)), eyeRays(LEFT), 0, facing(studio.referenceRows(), SUN, true));
        }
    }

    @Test
    void hiddenOffscreenSphere_castsOnlyForShadowedRows() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            ReferenceRows reference = studio.referenceRows();
            long shaded = reference.count(0, reference.isShadowed(SUN).and(row -> row.px() > 0));
            assertThat(shaded).isPositive();
            UpdateResult update = edit(studio, "above", ball -> ball.withVisible(false));
            assertRays(update, 0, 0, shaded);
            assertThat(update.rowsTouched()).isEqualTo(shaded);
        }
    }

    @Test
    void shownOffscreenSphere_castsOnlyForRowsNearBounds() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            edit(studio, "above", ball -> moved(ball, 1.5, 0, 0).withVisible(false));
            UpdateResult update = edit(studio, "above", ball -> ball.withVisible(true));
            ReferenceRows reference = studio.referenceRows();
            long below = reference.count(0, reference.isFacing(SUN).and(row -> row.px() > 4));
            assertThat(update.rays().eye()).isZero();
            assertThat(update.rays().shadow()).isBetween(below, below + 32);
        }
    }

    @Test
    void shownOffscreenSphere_castsOnlyForRowsNearItsSoftShadow() {
        double width = 7 * Math.tan(Math.toRadians(WIDE_SUN.area().spread()));
        try (StudioRenderer studio = studio(scene(WIDE_SUN))) {
            edit(studio, "above", ball -> moved(ball, 1.5, 0, 0).withVisible(false));
            UpdateResult update = edit(studio, "above", ball -> ball.withVisible(true));
            ReferenceRows reference = studio.referenceRows();
            long below = reference.count(0, row -> row.px() > 4 - width);
            assertThat(update.rays().eye()).isZero();
            assertThat(update.rays().shadow()).isBetween(1L, AreaSamples.refined(WIDE_SUN.area().samples()) * below);
        }
    }

    @Test
    void movedSphereAndRemovedLinksOfAreaLight_areExact() {
        Light linked = WIDE_SUN.withIlluminates(ShapeLinks.only("right"));
        try (StudioRenderer studio = studio(scene(linked))) {
            Scene moved = studio.scene().withNode("above", moved(studio.scene().stage().node("above").orElseThrow(), 1.2, 0, 0));
            studio.render(moved.withLight(WIDE_SUN));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void sphereMovedOutsideAllRays_costsNothing() {
        for (Light light : List.of(SUN, WIDE_SUN)) {
            try (StudioRenderer studio = studio(scene(light))) {
                edit(studio, "above", ball -> moved(ball, 20, 0, 0));
                assertWork(edit(studio, "above", ball -> moved(ball, 1, 1, 1)), 0, 0, 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void sphereVisibleOnlyInMirror_castsNoEyeRays(MirrorStorage storage) {
        Scene scene = scene(SUN);
        scene = scene.withNode("left", ((Shape) scene.nodes().getFirst()).withMaterial("glass"))
                .withNode("above", moved(scene.nodes().get(2), -7, -3.5, 3));
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, storage, scene)) {
            UpdateResult update = edit(studio, "above", ball -> moved(ball, 0, 1, 0));
            assertThat(update.rays().eye()).isZero();
            Vec3 before = new Vec3(-3.5, 4.5, 3);
            long toward = studio.referenceRows().rowsOfLevel(0).stream().filter(row -> studio.referenceRows().isMirror(row))
                    .map(SurfacePoint::reflectedRay)
                    .filter(ray -> BallBoxes.meets(studio.scene(), ray, before, before.plus(Vec3.Y))).count();
            assertThat(toward).isPositive();
            assertThat(update.rays().mirrored()).isEqualTo(storage == MirrorStorage.FULL_ROWS ? toward : leftRows(studio.referenceRows()));
        }
    }

    @Test
    void changedSphereMaterial_castsNoOtherShadowRays() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            assertRays(edit(studio, "above", ball -> ((Shape) ball).withMaterial("glass")), 0, 0, 0);
            assertRays(edit(studio, "left", ball -> ((Shape) ball).withMaterial("default")), eyeRays(LEFT), 0,
                    facing(studio.referenceRows(), SUN, true));
        }
    }

    @Test
    void darkLight_castsNoRaysUntilSwitchedOn() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            studio.render(studio.scene().withLight(SUN.withOn(false)));
            assertRays(edit(studio, "above", ball -> ball.withVisible(false)), 0, 0, 0);
            UpdateResult update = studio.render(studio.scene().withLight(SUN));
            assertRays(update, 0, 0, facing(studio.referenceRows(), SUN, false));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void sphereMovedOutsideRaysOfDarkLight_keepsItsLayers() {
        for (Light light : List.of(SUN, WIDE_SUN)) {
            try (StudioRenderer studio = studio(scene(light))) {
                edit(studio, "above", ball -> moved(ball, 20, 0, 0));
                studio.render(studio.scene().withLight(light.withOn(false)));
                edit(studio, "above", ball -> moved(ball, 1, 1, 1));
                assertThat(studio.render(studio.scene().withLight(light)).rays().shadow()).isZero();
                FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
            }
        }
    }

    @Test
    void addedAndDeletedSpheres_keepOtherIndices() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            List<SceneNode> more = new ArrayList<>(studio.scene().nodes());
            Vec3 added = new Vec3(-3.5, 2.6, 0);
            more.addFirst(ball("first", added.x(), added.y()));
            Scene before = studio.scene();
            assertRays(studio.render(before.withNodes(more)), eyeRays(added), 0, facing(studio.referenceRows(), SUN, true));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
            assertRays(studio.render(before), eyeRays(added), 0, facing(studio.referenceRows(), SUN, true));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void renamedGroup_costsNothing() {
        Scene scene = scene(SUN);
        List<SceneNode> pair = scene.nodes().subList(1, 3);
        try (StudioRenderer studio =
                studio(scene.withNodes(List.of(scene.nodes().getFirst(), new NodeGroup("pair", Placement.IDENTITY, pair))))) {
            assertWork(studio.render(studio.scene().withNodes(
                    List.of(scene.nodes().getFirst(), new NodeGroup("two", Placement.IDENTITY, pair)))), 0, 0, 0, 0);
        }
    }

    @Test
    void movedGroup_movesItsShapes() {
        Scene scene = scene(SUN);
        List<SceneNode> pair = scene.nodes().subList(1, 3);
        try (StudioRenderer studio =
                studio(scene.withNodes(List.of(scene.nodes().getFirst(), new NodeGroup("pair", Placement.IDENTITY, pair))))) {
            assertRays(edit(studio, "pair", group -> moved(group, 0.25, 0, 0)),
                    eyeRays(RIGHT, RIGHT.plus(new Vec3(0.25, 0, 0))), 0, facing(studio.referenceRows(), SUN, false));
        }
    }

    @Test
    void shapeAndLightEdit_costsSumOfBoth() {
        try (StudioRenderer studio = studio(scene(SUN))) {
            Scene scene = studio.scene();
            UpdateResult update = studio.render(scene.withNode("left", moved(scene.nodes().getFirst(), 0.25, 0, 0))
                    .withLight(SUN.withIntensity(0.3)));
            assertRays(update, eyeRays(LEFT, LEFT.plus(new Vec3(0.25, 0, 0))), 0, facing(studio.referenceRows(), SUN, true));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }
}
