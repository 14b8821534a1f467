package lightning.render.relight;

import static lightning.render.relight.Studio.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.ConeChange;
import lightning.render.shading.SeenRows;
import lightning.sample.StudioScene;
import lightning.scene.Attenuation;
import lightning.scene.BarnDoors;
import lightning.scene.Gobo;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Photometry;
import lightning.scene.Profile;
import lightning.scene.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Each edit of a light does the least work: its plan, rows and shadow rays, for every type of light. */
class LightWorkTest {
    private static final LightUpdate KEEP = new LightUpdate.Keep();
    private static final LightUpdate REWEIGHT = new LightUpdate.Reweight();
    private static final LightUpdate FALLOFF = new LightUpdate.Partial(ConeChange.NONE, true, false);
    private static final LightUpdate REMOVE = new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, false, false);
    private static final LightUpdate ENTER = new LightUpdate.Partial(ConeChange.ANGLE_ADD, false, false);
    private static final LightUpdate TURN = new LightUpdate.Partial(ConeChange.TURN, true, false);
    private static final LightUpdate FULL = new LightUpdate.FullRecompute(false);
    private static final LightUpdate ADD = new LightUpdate.FullRecompute(true);
    private static final Vec3 ELSEWHERE = new Vec3(-1, 5, 3);
    private static final Vec3 ASIDE = new Vec3(-2.5, -4.5, -3);

    private static void assertPlan(Update update, LightUpdate... layers) {
        assertThat(Studio.layers(update)).containsExactly(layers);
    }

    /** The edit does not act on the type: nothing at all is done. */
    private static void assertNothingDone(Update update) {
        assertPlan(update, KEEP);
        assertWork(update, 0, 0, 0, 0);
    }

    private static long rows(Studio studio) {
        return studio.seen().level(0).size();
    }

    @ParameterizedTest
    @EnumSource(names = {"POINT", "SPOT"})
    void profile_rewritesTheFalloffOfLitRows(LightType type) {
        var profile = Optional.of(new Profile("p.ies",
                new Photometry(Photometry.Type.C, new double[] {0, 60, 90}, new double[] {0}, new double[] {2, 1, 0.5})));
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            long lit = seen.count(0, seen.lit(studio.key()));
            for (Update update : List.of(studio.edit(l -> l.withProfile(profile)), studio.edit(l -> l.withProfile(Optional.empty())))) {
                assertPlan(update, FALLOFF);
                assertWork(update, lit, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void theStudioShowsRowsOfEveryState(LightType type) {
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            assertThat(seen.count(0, seen.lit(studio.key()))).isPositive();
            assertThat(seen.count(0, seen.shadowed(studio.key()))).isPositive();
            assertThat(seen.count(0, seen.facing(studio.key()).negate())).isPositive();
            assertThat(seen.count(0, seen.outside(studio.key())) > 0).isEqualTo(type.hasCone());
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void colorAndIntensity_changeTheWeightOnly(LightType type) {
        try (Studio studio = Studio.of(type)) {
            for (Update update : List.of(studio.edit(l -> l.withColor(new Rgb(1, 0, 0.5))), studio.edit(l -> l.withIntensity(0.3)))) {
                assertPlan(update, REWEIGHT);
                assertWork(update, 0, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void ambienceOnAndOffSoloAndZero_onlyCompose(LightType type) {
        try (Studio studio = Studio.of(type)) {
            studio.lights(l -> List.of(l.getFirst(), StudioScene.key(LightType.POINT).withName("other")));
            for (Update update : List.of(
                    studio.render(studio.scene().withWorld(studio.scene().world().withAmbience(0.2))),
                    studio.edit(l -> l.withOn(false)), studio.edit(l -> l.withOn(true)),
                    studio.edit(l -> l.withSolo(true)), studio.edit(l -> l.withSolo(false)),
                    studio.edit(l -> l.withIntensity(0)))) {
                assertPlan(update, KEEP, KEEP);
                assertWork(update, 0, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void deleting_dropsTheLayer(LightType type) {
        try (Studio studio = Studio.of(type)) {
            Update update = studio.lights(_ -> List.of());
            assertPlan(update);
            assertThat(((UpdatePlan.Relight) update.plan()).top().dropped()).containsExactly(StudioScene.KEY);
            assertWork(update, 0, rows(studio), 0, 0);
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void adding_castsOneRayForEachRowThatTheLightReaches(LightType type) {
        try (Studio studio = Studio.of(LightType.POINT)) {
            Light light = StudioScene.key(type).withName("more").withPosition(ELSEWHERE);
            Update update = studio.lights(l -> List.of(l.getFirst(), light));
            assertPlan(update, KEEP, ADD);
            assertWork(update, rows(studio), rows(studio), 0, studio.seen().count(0, studio.seen().reached(light)));
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void attenuation_rewritesTheFalloffOfLitRows(LightType type) {
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            Update update = studio.edit(l -> l.withAttenuation(new Attenuation(0, 1, 1)));
            if (type == LightType.DIRECTIONAL) {
                assertNothingDone(update);
            } else {
                assertPlan(update, FALLOFF);
                assertWork(update, seen.count(0, seen.lit(studio.key())), rows(studio), 0, 0);
            }
        }
    }

    @Test
    void doorsAndGobo_rewriteTheFalloffOfLitRows() {
        var gobo = Optional.of(new Gobo("half.png", new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0})));
        try (Studio studio = Studio.of(LightType.SPOT)) {
            SeenRows seen = studio.seen();
            long lit = seen.count(0, seen.lit(studio.key()));
            for (Update update : List.of(studio.edit(l -> l.withDoors(new BarnDoors(5, 90, 90, -10))), studio.edit(l -> l.withFeather(10)),
                    studio.edit(l -> l.withGobo(gobo)), studio.edit(l -> l.withGobo(Optional.empty()).withDoors(BarnDoors.OPEN)))) {
                assertPlan(update, FALLOFF);
                assertWork(update, lit, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void dropoff_rewritesTheFalloffOfLitRows(LightType type) {
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            Update update = studio.edit(l -> l.withDropoff(7.5));
            if (type != LightType.SPOT) {
                assertNothingDone(update);
            } else {
                assertPlan(update, FALLOFF);
                assertWork(update, seen.count(0, seen.lit(studio.key())), rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void smallerAngle_looksAtRowsInsideTheCone(LightType type) {
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            long inside = seen.count(0, seen.reached(studio.key()));
            Update update = studio.edit(l -> l.withAngle(8));
            if (type != LightType.SPOT) {
                assertNothingDone(update);
            } else {
                assertPlan(update, REMOVE);
                assertWork(update, inside, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void largerAngle_castsOnlyForRowsThatEnterTheCone(LightType type) {
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            Light before = studio.key();
            Update update = studio.edit(l -> l.withAngle(30));
            if (type != LightType.SPOT) {
                assertNothingDone(update);
            } else {
                assertPlan(update, ENTER);
                assertWork(update, seen.count(0, seen.outside(before)), rows(studio), 0,
                        seen.count(0, seen.outside(before).and(seen.inside(studio.key()))));
            }
        }
    }

    @Test
    void largerAngleWithAttenuation_countsRowsThatOnlyFadeToo() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            SeenRows seen = studio.seen();
            Light before = studio.key();
            Update update = studio.edit(l -> l.withAngle(30).withAttenuation(new Attenuation(0, 1, 1)));
            assertPlan(update, new LightUpdate.Partial(ConeChange.ANGLE_ADD, true, false));
            assertWork(update, seen.count(0, seen.outside(before)) + seen.count(0, seen.lit(before)), rows(studio), 0,
                    seen.count(0, seen.outside(before).and(seen.inside(studio.key()))));
        }
    }

    @Test
    void undoneAngle_castsNoRayAndNeitherDoesItsRedo() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            studio.edit(l -> l.withAngle(30));
            for (double angle : new double[] {20, 30, 12, 26, 20}) {
                Update update = studio.edit(l -> l.withAngle(angle));
                assertThat(update.rays().shadow()).as("angle " + angle).isZero();
                assertThat(update.rowsComposed()).isEqualTo(rows(studio));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void turning_castsOnlyWhereTheWayIsUnknown(LightType type) {
        try (Studio studio = Studio.of(type)) {
            SeenRows seen = studio.seen();
            Light before = studio.key();
            Update update = studio.edit(l -> l.withDirection(ASIDE));
            switch (type) {
                case POINT -> assertNothingDone(update);
                case DIRECTIONAL -> {
                    assertPlan(update, FULL);
                    assertWork(update, rows(studio), rows(studio), 0, seen.count(0, seen.facing(studio.key())));
                }
                case SPOT -> {
                    assertPlan(update, TURN);
                    assertWork(update, seen.count(0, seen.facing(before)), rows(studio), 0,
                            seen.count(0, seen.outside(before).and(seen.inside(studio.key()))));
                    assertThat(studio.edit(_ -> before).rays().shadow()).as("turned back").isZero();
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void anotherLengthOfTheDirection_isNoEdit(LightType type) {
        try (Studio studio = Studio.of(type)) {
            assertNothingDone(studio.edit(l -> l.withDirection(l.direction().times(2))));
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void moving_castsOneRayForEachRowThatTheLightReaches(LightType type) {
        try (Studio studio = Studio.of(type)) {
            Update update = studio.edit(l -> l.withPosition(ELSEWHERE));
            if (type == LightType.DIRECTIONAL) {
                assertNothingDone(update);
            } else {
                SeenRows seen = studio.seen();
                assertPlan(update, FULL);
                assertWork(update, rows(studio), rows(studio), 0, seen.count(0, seen.reached(studio.key())));
            }
        }
    }

    static Stream<LightType[]> typeChanges() {
        return Stream.of(LightType.values()).flatMap(a -> Stream.of(LightType.values()).filter(b -> a != b)
                .map(b -> new LightType[] {a, b}));
    }

    @ParameterizedTest
    @MethodSource("typeChanges")
    void changingTheType_castsOnlyWhereTheWayIsUnknown(LightType from, LightType to) {
        try (Studio studio = Studio.of(from)) {
            SeenRows seen = studio.seen();
            Light before = studio.key();
            Update update = studio.edit(l -> l.withType(to));
            if (from.hasPosition() && to.hasPosition() && !from.isSurface() && !to.isSurface()) {
                assertPlan(update, TURN);
                assertWork(update, seen.count(0, seen.facing(before)), rows(studio), 0,
                        from == LightType.SPOT ? seen.count(0, seen.outside(before)) : 0);
                assertThat(studio.edit(_ -> before).rays().shadow()).as("back again").isZero();
            } else {
                assertPlan(update, FULL);
                assertWork(update, rows(studio), rows(studio), 0, seen.count(0, seen.reached(studio.key())));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void renaming_doesNothingAndReordering_onlyComposes(LightType type) {
        try (Studio studio = Studio.of(type)) {
            Light light = studio.key();
            assertNothingDone(studio.lights(_ -> List.of(light.withName("renamed"))));
            studio.lights(l -> List.of(l.getFirst(), light.withName("second")));
            Update update = studio.lights(List::reversed);
            assertPlan(update, KEEP, KEEP);
            assertWork(update, 0, rows(studio), 0, 0);
        }
    }

    @ParameterizedTest
    @EnumSource(LightType.class)
    void lightEditedWhileOff_waitsUntilItIsOn(LightType type) {
        try (Studio studio = Studio.of(type)) {
            studio.edit(l -> l.withOn(false));
            assertNothingDone(studio.edit(l -> l.withPosition(ELSEWHERE).withDirection(ASIDE).withIntensity(2)));
            Update update = studio.edit(l -> l.withOn(true));
            SeenRows seen = studio.seen();
            assertPlan(update, FULL);
            assertWork(update, rows(studio), rows(studio), 0, seen.count(0, seen.reached(studio.key())));
        }
    }

    @Test
    void editsOfTwoLightsAtOnce_costWhatEachOfThemCosts() {
        try (Studio studio = Studio.of(LightType.SPOT)) {
            studio.lights(l -> List.of(l.getFirst(), StudioScene.key(LightType.POINT).withName("other")));
            SeenRows seen = studio.seen();
            long inside = seen.count(0, seen.reached(studio.key()));
            Light moved = StudioScene.key(LightType.POINT).withName("other").withPosition(ELSEWHERE);
            Update update = studio.lights(l -> List.of(l.getFirst().withAngle(8).withIntensity(2), moved));
            assertPlan(update, new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, false, true), FULL);
            assertWork(update, inside + rows(studio), rows(studio), 0, seen.count(0, seen.reached(moved)));
        }
    }
}
