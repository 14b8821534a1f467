package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.document.manipulation.LightPlacement.Goal;
import lightning.document.manipulation.SightPlacement.Change;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Placement of lights in a room: a ball of radius 1 on a floor, a wall behind it, a ceiling at 3. */
class SightPlacementTest {
    private static final String ROOM = """
            jen 1
            picture { size 40 30 }
            camera { from 0 1 9  to 0 1 0  up 0 1 0  fov 50 }
            material paint { diffuse 1 1 1 }
            plane floor { material paint  scale 20 1 20 }
            sphere ball { material paint  at 0 1 0 }
            plane wall { material paint  at 0 0 -4  rotate 90 0 0  scale 20 1 20 }
            plane ceiling { material paint  at 0 3 0  scale 20 1 20 }
            plane curb { material paint  at 2 0 0  rotate 90 0 0  scale 1 1 0.1 }
            sphere lamp_shade { material paint  at -2 2 1  scale 0.4 0.4 0.4 }
            light lamp point { at 0 2 4 }
            """;
    /** A point on the lower part of the ball, seen horizontally. */
    private static final Vec3 DOWN = new Vec3(0, -0.5, Math.sqrt(0.75));
    private static final Vec3 ON_LOWER_HALF = Vec3.Y.plus(DOWN);

    private final Scene scene = room();
    private final ScenePicker picker = new ScenePicker(scene);

    private static Scene room() {
        try {
            return JenReader.read(ROOM, "room.jen", Path.of("scenes")).scene();
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private Light lamp() {
        return scene.lights().getFirst();
    }

    private static ScenePicker.SurfaceHit hit(String shape, Vec3 point, Vec3 normal) {
        return new ScenePicker.SurfaceHit(shape, point, normal, point.plus(new Vec3(0, 0, 9)));
    }

    private SightPlacement place(Light light, Goal goal, double distance, ScenePicker.SurfaceHit at) {
        return SightPlacement.of(LightPlacement.start(light, goal, at.point()).withDistance(distance), at, picker);
    }

    private void assertPlaced(SightPlacement placed, ScenePicker.SurfaceHit at, double distance, Change change, String blocker) {
        assertThat(placed.change()).isEqualTo(change);
        assertThat(placed.blocker()).isEqualTo(Optional.of(blocker));
        assertThat(placed.light().position().minus(at.point()).length()).isCloseTo(distance, within(1e-3));
        assertThat(picker.findOccluder(at, placed.light())).isEmpty();
    }

    @Test
    void freeHighlight_keepsItsDistance() {
        var at = hit("ball", new Vec3(0, 1, 1), new Vec3(0, 0, 1));
        SightPlacement placed = place(lamp(), new Goal.Highlight(), 5, at);
        assertThat(placed).isEqualTo(new SightPlacement(lamp().withPosition(new Vec3(0, 1, 6)), Optional.empty(), Change.NONE));
    }

    /** The mirrored direction is (0, −√¾, ½), so the floor is 0.5/√¾ away. */
    @Test
    void highlightBelowFloor_staysAboveIt() {
        var at = hit("ball", ON_LOWER_HALF, DOWN);
        SightPlacement placed = place(lamp(), new Goal.Highlight(), 5, at);
        assertPlaced(placed, at, 0.9 * 0.5 / Math.sqrt(0.75), Change.CLOSER, "floor");
        assertThat(placed.light().position().y()).isCloseTo(0.05, within(1e-3));
    }

    /** The tangent is (0, −√¾, −½). */
    @Test
    void rimBelowFloor_staysAboveIt() {
        var at = hit("ball", ON_LOWER_HALF, DOWN);
        assertPlaced(place(lamp(), new Goal.Rim(), 5, at), at, 0.9 * 0.5 / Math.sqrt(0.75), Change.CLOSER, "floor");
    }

    @Test
    void lightFacingFloor_staysBelowCeiling() {
        var at = hit("floor", new Vec3(3, 0, 3), Vec3.Y);
        assertPlaced(place(lamp(), new Goal.Diffuse(), 5, at), at, 2.7, Change.CLOSER, "ceiling");
    }

    @Test
    void largeLight_staysAwayFromBlocker() {
        var at = hit("floor", new Vec3(3, 0, 3), Vec3.Y);
        Light disc = lamp().withType(LightType.DISC).withDirection(Vec3.Y).withArea(lamp().area().withRadius(1));
        assertPlaced(place(disc, new Goal.Diffuse(), 5, at), at, 2, Change.CLOSER, "ceiling");
    }

    /** The curb is 0.05 high and 0.1 behind the point: 26.6 degrees. */
    @Test
    void rimBehindLowEdge_looksOverIt() {
        var at = hit("floor", new Vec3(2, 0, 0.1), Vec3.Y);
        SightPlacement placed = place(lamp(), new Goal.Rim(), 3, at);
        assertPlaced(placed, at, 3, Change.TILTED, "curb");
        assertThat(placed.light().position().y()).isCloseTo(1.5, within(1e-3));
    }

    /** The way from (0, 0, 2) along (0, 1, −4) leaves the ball after (9 + √13) / √17 and meets the wall after 1.5 √17. */
    @Test
    void shadowBehindWall_staysBetweenCasterAndWall() {
        var at = hit("floor", new Vec3(0, 0, 2), Vec3.Y);
        SightPlacement placed = place(lamp(), new Goal.Shadow(new Vec3(0, 0.5, 0)), 10, at);
        double exit = (9 + Math.sqrt(13)) / Math.sqrt(17);
        assertThat(placed.blocker()).contains("wall");
        assertThat(placed.change()).isEqualTo(Change.CLOSER);
        assertThat(placed.light().position().minus(at.point()).length())
                .isCloseTo(exit + 0.9 * (1.5 * Math.sqrt(17) - exit), within(1e-3));
    }

    @Test
    void shadowFromInsideCaster_movesBehindIt() {
        var at = hit("floor", new Vec3(0, 0, 2), Vec3.Y);
        SightPlacement placed = place(lamp(), new Goal.Shadow(Vec3.Y), 2.5, at);
        assertThat(placed.blocker()).isEmpty();
        assertThat(placed.light().position().minus(Vec3.Y).length()).isGreaterThan(1);
        assertThat(placed.light().position().z()).isGreaterThan(-4);
    }

    @Test
    void blockedSun_namesBlocker() {
        var at = hit("floor", new Vec3(3, 0, 3), Vec3.Y);
        SightPlacement placed = place(lamp().withType(LightType.DIRECTIONAL), new Goal.Diffuse(), 1, at);
        assertThat(placed.blocker()).contains("ceiling");
        assertThat(placed.change()).isEqualTo(Change.NONE);
        assertThat(placed.light().direction().normalized()).isEqualTo(Vec3.Y.negated());
    }

    @Test
    void aimAndFlagOfBlockedLight_nameBlocker() {
        var at = hit("ball", new Vec3(0, 1, 1), new Vec3(0, 0, 1));
        Light outside = lamp().withType(LightType.SPOT).withPosition(new Vec3(0, 5, 6));
        for (Goal goal : List.of(new Goal.Pool(), new Goal.Flag())) {
            SightPlacement placed = place(outside, goal, 5, at);
            assertThat(placed.blocker()).contains("ceiling");
            assertThat(placed.light().position()).isEqualTo(outside.position());
        }
    }

    @Test
    void lightWithoutShadows_mayBeAnywhere() {
        var at = hit("floor", new Vec3(3, 0, 3), Vec3.Y);
        Light shadowless = lamp().withInfluence(lamp().influence().withCastsShadows(false));
        assertThat(place(shadowless, new Goal.Diffuse(), 5, at).light().position()).isEqualTo(new Vec3(3, 5, 3));
    }

    @Test
    void draggedDistance_stopsAtBlocker() {
        var at = hit("floor", new Vec3(3, 0, 3), Vec3.Y);
        LightPlacement placing = LightPlacement.start(lamp(), new Goal.Diffuse(), at.point()).withDistance(1);
        Light placed = SightPlacement.of(placing, at, picker).light();
        assertPlaced(SightPlacement.atDistance(placing, placed, at, 8, picker), at, 2.7, Change.CLOSER, "ceiling");
        assertThat(SightPlacement.atDistance(placing, placed, at, 2, picker).blocker()).isEmpty();
    }

    @Provide
    Arbitrary<Goal> goals() {
        return Arbitraries.of(new Goal.Highlight(), new Goal.Diffuse(), new Goal.Rim(), new Goal.Pool());
    }

    @Provide
    Arbitrary<LightType> types() {
        return Arbitraries.of(LightType.POINT, LightType.SPOT, LightType.DIRECTIONAL, LightType.RECT, LightType.TUBE);
    }

    @Property
    void placedLight_seesItsPointOrNamesBlocker(@ForAll @IntRange(max = 39) int x, @ForAll @IntRange(max = 29) int y,
            @ForAll("goals") Goal goal, @ForAll("types") LightType type, @ForAll @DoubleRange(min = 0.1, max = 30) double distance) {
        Light light = lamp().withType(type).withDirection(new Vec3(0, -1, 0.1));
        if (goal instanceof Goal.Pool && !type.hasDirection()) {
            return;
        }
        picker.pickPixel(x, y).ifPresent(at -> {
            SightPlacement placed = SightPlacement.of(LightPlacement.start(light, goal, at.point()).withDistance(distance), at, picker);
            boolean isSeen = picker.findOccluder(at, placed.light()).isEmpty();
            assertThat(isSeen || placed.blocker().isPresent()).isTrue();
            assertThat(placed.change() == Change.NONE || isSeen).as("moved to where it is seen").isTrue();
            boolean canMove = type.hasPosition() && !(goal instanceof Goal.Pool);
            assertThat(!canMove || isSeen).isTrue();
        });
    }

    @Property
    void placedShadow_isThatOfItsCaster(@ForAll @IntRange(max = 39) int x, @ForAll @IntRange(min = 20, max = 29) int y,
            @ForAll @DoubleRange(min = 0.1, max = 30) double distance) {
        picker.pickPixel(x, y).filter(at -> at.shape().equals("floor")).ifPresent(at -> {
            SightPlacement placed = place(lamp(), new Goal.Shadow(Vec3.Y), distance, at);
            double reach = placed.light().position().minus(at.point()).length();
            Vec3 direction = placed.light().position().minus(at.point()).normalized();
            List<ScenePicker.SurfaceHit> between = picker.occluders(at, direction, lamp().shadowCasters(), 9).stream()
                    .filter(surface -> surface.point().minus(at.point()).length() < reach).toList();
            assertThat(between).filteredOn(surface -> surface.shape().equals("ball")).as("before and behind the light's shadow").hasSize(2);
            assertThat(between.getLast().shape()).isEqualTo("ball");
        });
    }
}
