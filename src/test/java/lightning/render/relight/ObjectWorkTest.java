package lightning.render.relight;

import static lightning.render.relight.Studio.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.SeenRows;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Each edit of shapes traces again only where rays can meet what was or what is: its rays and rows, counted.
 *
 * <p>The picture is two tiles side by side. A ball stands in the middle of each; the sun is above, so that no ball shades the
 * other. A third ball, over the right one and out of the picture, throws a shadow on it.
 */
class ObjectWorkTest {
    private static final int TILE = 32 * 32;
    private static final Vec3 LEFT = new Vec3(-3.5, 0, 0);
    private static final Vec3 RIGHT = new Vec3(3.5, 0, 0);
    private static final Light SUN = Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0));

    private static Scene scene(Light light) {
        return new Scene(new Picture(64, 32, 1), new Camera(new Vec3(0, 0, 20), Vec3.ZERO, Vec3.Y, 20), World.DEFAULT,
                List.of(Material.of("matt").withDiffuse(Rgb.grey(0.7)), Material.of("glass").withReflective(Rgb.grey(0.5))),
                List.of(ball("left", LEFT.x(), 0), ball("right", RIGHT.x(), 0), ball("above", 3.5, 8)), List.of(light));
    }

    private static Shape ball(String name, double x, double y) {
        return new Shape(Solid.SPHERE, name, "matt", new Placement(new Vec3(x, y, 0), Vec3.ZERO, Vec3.ONE));
    }

    private static Studio studio(Scene scene) {
        return new Studio(Reflections.CURRENT, MirrorStorage.FULL_ROWS, scene);
    }

    private static Update edit(Studio studio, String name, UnaryOperator<Node> change) {
        Update update = studio.render(studio.scene().withNode(name, change.apply(studio.scene().stage().node(name).orElseThrow())));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        return update;
    }

    private static Node moved(Node node, double x, double y, double z) {
        Placement p = node.placement();
        return node.withPlacement(new Placement(p.at().plus(new Vec3(x, y, z)), p.rotate(), p.scale()));
    }

    private static long eyeRays(Vec3... balls) {
        return BallBoxes.eyeRays(scene(SUN), balls);
    }

    private static long left(SeenRows seen) {
        return seen.count(0, row -> row.px() < 0);
    }

    private static long facing(SeenRows seen, Light light, boolean left) {
        return seen.count(0, seen.facing(light).and(row -> row.px() < 0 == left));
    }

    private static void assertRays(Update update, long eye, long mirrored, long shadow) {
        assertThat(update.plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(update.rays().eye()).as("eye rays").isEqualTo(eye);
        assertThat(update.rays().mirrored()).as("mirrored rays").isEqualTo(mirrored);
        assertThat(update.rays().shadow()).as("shadow rays").isEqualTo(shadow);
    }

    private static final Light WIDE_SUN = SUN.withArea(SUN.area().withSpread(2));

    /** Over everything, out of the picture. */
    private static Node roof(Node node) {
        return node.withPlacement(new Placement(new Vec3(0, 60, 0), Vec3.ZERO, new Vec3(30, 30, 30)));
    }

    @Test
    void shapeThatHidesAllOfAnAreaLight_darkensTilesThatSawIt() {
        try (Studio studio = studio(scene(WIDE_SUN))) {
            edit(studio, "above", ObjectWorkTest::roof);
        }
    }

    @Test
    void areaLightThatGoesOutAsShapesMove_leavesNoLight() {
        try (Studio studio = studio(scene(WIDE_SUN))) {
            Scene moved = studio.scene().withNode("above", roof(studio.scene().stage().node("above").orElseThrow()));
            studio.render(moved.withLight(WIDE_SUN.withOn(false)));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void movedBall_retracesOnlyItsBox() {
        try (Studio studio = studio(scene(SUN))) {
            Update update = edit(studio, "left", ball -> moved(ball, 0.25, 0, 0));
            assertRays(update, eyeRays(LEFT, LEFT.plus(new Vec3(0.25, 0, 0))), 0, facing(studio.seen(), SUN, true));
            assertThat(update.rowsComposed()).isEqualTo(left(studio.seen()));
        }
    }

    @Test
    void turnedAndScaledBall_retracesOnlyItsBox() {
        try (Studio studio = studio(scene(SUN))) {
            Update update = edit(studio, "left", ball -> ball.withPlacement(
                    new Placement(ball.placement().at(), new Vec3(0, 30, 10), new Vec3(0.5, 1, 0.7))));
            assertRays(update, eyeRays(LEFT), 0, facing(studio.seen(), SUN, true));
        }
    }

    @Test
    void hiddenBall_retracesItsBox_andCastsNothingWhereNothingIsLeft() {
        try (Studio studio = studio(scene(SUN))) {
            assertRays(edit(studio, "left", ball -> ball.withVisible(false)), eyeRays(LEFT), 0, 0);
            assertRays(edit(studio, "left", ball -> ball.withVisible(true)), eyeRays(LEFT), 0, facing(studio.seen(), SUN, true));
        }
    }

    @Test
    void hiddenBallThatNobodySees_asksOnlyTheRowsThatItShaded() {
        try (Studio studio = studio(scene(SUN))) {
            SeenRows seen = studio.seen();
            long shaded = seen.count(0, seen.shadowed(SUN).and(row -> row.px() > 0));
            assertThat(shaded).isPositive();
            assertRays(edit(studio, "above", ball -> ball.withVisible(false)), 0, 0, shaded);
        }
    }

    @Test
    void shownBallThatNobodySees_asksNoRowBesideItsBox() {
        try (Studio studio = studio(scene(SUN))) {
            edit(studio, "above", ball -> moved(ball, 1.5, 0, 0).withVisible(false));
            Update update = edit(studio, "above", ball -> ball.withVisible(true));
            SeenRows seen = studio.seen();
            long beneath = seen.count(0, seen.facing(SUN).and(row -> row.px() > 4));
            assertThat(update.rays().eye()).isZero();
            assertThat(update.rays().shadow()).isBetween(beneath, beneath + 32);
        }
    }

    @Test
    void ballMovedWhereNoRayGoes_costsNothing() {
        try (Studio studio = studio(scene(SUN))) {
            edit(studio, "above", ball -> moved(ball, 20, 0, 0));
            assertWork(edit(studio, "above", ball -> moved(ball, 1, 1, 1)), 0, 0, 0, 0);
        }
    }

    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void ballThatOnlyAMirrorShows_castsNoEyeRay(MirrorStorage storage) {
        Scene scene = scene(SUN);
        scene = scene.withNode("left", ((Shape) scene.nodes().getFirst()).withMaterial("glass"))
                .withNode("above", moved(scene.nodes().get(2), -7, -3.5, 3));
        try (Studio studio = new Studio(Reflections.CURRENT, storage, scene)) {
            Update update = edit(studio, "above", ball -> moved(ball, 0, 1, 0));
            assertThat(update.rays().eye()).isZero();
            Vec3 before = new Vec3(-3.5, 4.5, 3);
            long towards = studio.seen().level(0).stream().filter(row -> studio.seen().mirrors(row)).map(SurfacePoint::mirrored)
                    .filter(ray -> BallBoxes.meets(studio.scene(), ray, before, before.plus(Vec3.Y))).count();
            assertThat(towards).isPositive();
            assertThat(update.rays().mirrored()).isEqualTo(storage == MirrorStorage.FULL_ROWS ? towards : left(studio.seen()));
        }
    }

    @Test
    void anotherMaterialOfABall_asksNoWayOfOthers() {
        try (Studio studio = studio(scene(SUN))) {
            assertRays(edit(studio, "above", ball -> ((Shape) ball).withMaterial("glass")), 0, 0, 0);
            assertRays(edit(studio, "left", ball -> ((Shape) ball).withMaterial("default")), eyeRays(LEFT), 0,
                    facing(studio.seen(), SUN, true));
        }
    }

    @Test
    void darkLight_isNotAskedUntilItShines() {
        try (Studio studio = studio(scene(SUN))) {
            studio.render(studio.scene().withLight(SUN.withOn(false)));
            assertRays(edit(studio, "above", ball -> ball.withVisible(false)), 0, 0, 0);
            Update update = studio.render(studio.scene().withLight(SUN));
            assertRays(update, 0, 0, facing(studio.seen(), SUN, false));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void addedAndDeletedBalls_leaveOthersAtTheirPlaces() {
        try (Studio studio = studio(scene(SUN))) {
            List<Node> more = new ArrayList<>(studio.scene().nodes());
            Vec3 added = new Vec3(-3.5, 2.6, 0);
            more.addFirst(ball("first", added.x(), added.y()));
            Scene before = studio.scene();
            assertRays(studio.render(before.withNodes(more)), eyeRays(added), 0, facing(studio.seen(), SUN, true));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
            assertRays(studio.render(before), eyeRays(added), 0, facing(studio.seen(), SUN, true));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }

    @Test
    void aGroupsNewName_costsNothing() {
        Scene scene = scene(SUN);
        List<Node> pair = scene.nodes().subList(1, 3);
        try (Studio studio = studio(scene.withNodes(List.of(scene.nodes().getFirst(), new Group("pair", Placement.IDENTITY, pair))))) {
            assertWork(studio.render(studio.scene().withNodes(
                    List.of(scene.nodes().getFirst(), new Group("two", Placement.IDENTITY, pair)))), 0, 0, 0, 0);
        }
    }

    @Test
    void movedGroup_movesAllThatIsInIt() {
        Scene scene = scene(SUN);
        List<Node> pair = scene.nodes().subList(1, 3);
        try (Studio studio = studio(scene.withNodes(List.of(scene.nodes().getFirst(), new Group("pair", Placement.IDENTITY, pair))))) {
            assertRays(edit(studio, "pair", group -> moved(group, 0.25, 0, 0)),
                    eyeRays(RIGHT, RIGHT.plus(new Vec3(0.25, 0, 0))), 0, facing(studio.seen(), SUN, false));
        }
    }

    @Test
    void otherShapesAndALightAtOnce_costWhatEachOfThemCosts() {
        try (Studio studio = studio(scene(SUN))) {
            Scene scene = studio.scene();
            Update update = studio.render(scene.withNode("left", moved(scene.nodes().getFirst(), 0.25, 0, 0))
                    .withLight(SUN.withIntensity(0.3)));
            assertRays(update, eyeRays(LEFT, LEFT.plus(new Vec3(0.25, 0, 0))), 0, facing(studio.seen(), SUN, true));
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "object-work");
        }
    }
}
