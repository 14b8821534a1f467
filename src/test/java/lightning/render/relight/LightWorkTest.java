package lightning.render.relight;

import static lightning.render.relight.StudioRenderer.assertWork;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.ReferenceRows;
import lightning.render.shading.layer.ConeChange;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.Texture;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.Photometry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that each edit of a light does the least work: its plan, rows and shadow rays, for every type of light. */
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

    private static void assertPlan(UpdateResult update, LightUpdate... layers) {
        assertThat(StudioRenderer.layers(update)).containsExactly(layers);
    }

    /** Asserts that an edit without effect on the light's type does no work. */
    private static void assertNothingDone(UpdateResult update) {
        assertPlan(update, KEEP);
        assertWork(update, 0, 0, 0, 0);
    }

    private static long rows(StudioRenderer studio) {
        return studio.referenceRows().rowsOfLevel(0).size();
    }

    @ParameterizedTest
    @EnumSource(names = {"POINT", "SPOT"})
    void profile_rewritesFalloffOfLitRows(LightType type) {
        var profile = Optional.of(new IesProfile("p.ies",
                new Photometry(Photometry.Type.C, new double[] {0, 60, 90}, new double[] {0}, new double[] {2, 1, 0.5})));
        try (StudioRenderer studio = StudioRenderer.of(type).withOutdatedMirrors()) {
            ReferenceRows reference = studio.referenceRows();
            long lit = reference.count(0, reference.isLit(studio.key()));
            for (UpdateResult update : List.of(studio.edit(l -> l.withProfile(profile)),
                    studio.edit(l -> l.withProfile(Optional.empty())))) {
                assertPlan(update, FALLOFF);
                assertWork(update, lit, rows(studio), 0, 0);
            }
        }
    }

    @Test
    void doorsAndGobo_equalFullTrace() {
        var gobo = Optional.of(new Gobo("half.png", new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0})));
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            Scene mirrored = studio.scene();
            for (UnaryOperator<Light> edit : List.<UnaryOperator<Light>>of(l -> l.withDoors(new BarnDoors(5, 90, 90, -10)),
                    l -> l.withGobo(gobo), l -> l.withAngle(30))) {
                studio.edit(edit);
                FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene(), mirrored).trace(), "mask");
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void studio_hasRowsOfEveryState(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            ReferenceRows reference = studio.referenceRows();
            assertThat(reference.count(0, reference.isLit(studio.key()))).isPositive();
            assertThat(reference.count(0, reference.isShadowed(studio.key()))).isPositive();
            assertThat(reference.count(0, reference.isFacing(studio.key()).negate())).isPositive();
            assertThat(reference.count(0, reference.isOutsideCone(studio.key())) > 0).isEqualTo(type.hasCone());
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void colorAndIntensity_changeOnlyWeight(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            for (UpdateResult update : List.of(studio.edit(l -> l.withColor(new Rgb(1, 0, 0.5))), studio.edit(l -> l.withIntensity(0.3)))) {
                assertPlan(update, REWEIGHT);
                assertWork(update, 0, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void ambienceOnAndOffSoloAndZero_onlyCompose(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            studio.lights(l -> List.of(l.getFirst(), StudioScene.key(LightType.POINT).withName("other")));
            for (UpdateResult update : List.of(
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
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void deletedLight_dropsLayer(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            UpdateResult update = studio.lights(_ -> List.of());
            assertPlan(update);
            assertThat(((UpdatePlan.Relight) update.plan()).top().droppedLights()).containsExactly(StudioScene.KEY);
            assertWork(update, 0, rows(studio), 0, 0);
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void addedLight_castsOneRayPerReachedRow(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(LightType.POINT)) {
            Light light = StudioScene.key(type).withName("more").withPosition(ELSEWHERE);
            UpdateResult update = studio.lights(l -> List.of(l.getFirst(), light));
            assertPlan(update, KEEP, ADD);
            assertWork(update, rows(studio), rows(studio), 0, studio.referenceRows().count(0, studio.referenceRows().isReached(light)));
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void attenuation_rewritesFalloffOfLitRows(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            ReferenceRows reference = studio.referenceRows();
            UpdateResult update = studio.edit(l -> l.withAttenuation(new Attenuation(0, 1, 1)));
            if (type == LightType.DIRECTIONAL) {
                assertNothingDone(update);
            } else {
                assertPlan(update, FALLOFF);
                assertWork(update, reference.count(0, reference.isLit(studio.key())), rows(studio), 0, 0);
            }
        }
    }

    @Test
    void doorsAndGobo_rewriteFalloffOfLitRows() {
        var gobo = Optional.of(new Gobo("half.png", new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0})));
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            ReferenceRows reference = studio.referenceRows();
            long lit = reference.count(0, reference.isLit(studio.key()));
            for (UpdateResult update : List.of(studio.edit(l -> l.withDoors(new BarnDoors(5, 90, 90, -10))),
                    studio.edit(l -> l.withFeather(10)),
                    studio.edit(l -> l.withGobo(gobo)), studio.edit(l -> l.withGobo(Optional.empty()).withDoors(BarnDoors.OPEN)))) {
                assertPlan(update, FALLOFF);
                assertWork(update, lit, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void dropoff_rewritesFalloffOfLitRows(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            ReferenceRows reference = studio.referenceRows();
            UpdateResult update = studio.edit(l -> l.withDropoff(7.5));
            if (!LightAttribute.DROPOFF.appliesTo(type)) {
                assertNothingDone(update);
            } else {
                assertPlan(update, FALLOFF);
                assertWork(update, reference.count(0, reference.isLit(studio.key())), rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void smallerAngle_checksRowsInsideCone(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            ReferenceRows reference = studio.referenceRows();
            long inside = reference.count(0, reference.isReached(studio.key()));
            UpdateResult update = studio.edit(l -> l.withAngle(8));
            if (type != LightType.SPOT) {
                assertNothingDone(update);
            } else {
                assertPlan(update, REMOVE);
                assertWork(update, inside, rows(studio), 0, 0);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void largerAngle_castsOnlyForEnteringRows(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            ReferenceRows reference = studio.referenceRows();
            Light before = studio.key();
            UpdateResult update = studio.edit(l -> l.withAngle(30));
            if (type != LightType.SPOT) {
                assertNothingDone(update);
            } else {
                assertPlan(update, ENTER);
                assertWork(update, reference.count(0, reference.isOutsideCone(before)), rows(studio), 0,
                        reference.count(0, reference.isOutsideCone(before).and(reference.isInsideCone(studio.key()))));
            }
        }
    }

    @Test
    void largerAngleWithAttenuation_countsFalloffRows() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            ReferenceRows reference = studio.referenceRows();
            Light before = studio.key();
            UpdateResult update = studio.edit(l -> l.withAngle(30).withAttenuation(new Attenuation(0, 1, 1)));
            assertPlan(update, new LightUpdate.Partial(ConeChange.ANGLE_ADD, true, false));
            assertWork(update, reference.count(0, reference.isOutsideCone(before)) + reference.count(0, reference.isLit(before)),
                    rows(studio), 0,
                    reference.count(0, reference.isOutsideCone(before).and(reference.isInsideCone(studio.key()))));
        }
    }

    @Test
    void undoneAndRedoneAngle_castsNoRays() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT).withOutdatedMirrors()) {
            studio.edit(l -> l.withAngle(30));
            for (double angle : new double[] {20, 30, 12, 26, 20}) {
                UpdateResult update = studio.edit(l -> l.withAngle(angle));
                assertThat(update.rays().shadow()).as("angle " + angle).isZero();
                assertThat(update.rowsComposed()).isEqualTo(rows(studio));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void turnedLight_castsOnlyUnknownShadowRays(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            ReferenceRows reference = studio.referenceRows();
            Light before = studio.key();
            UpdateResult update = studio.edit(l -> l.withDirection(ASIDE));
            switch (type) {
                case POINT -> assertNothingDone(update);
                case DIRECTIONAL -> {
                    assertPlan(update, FULL);
                    assertWork(update, rows(studio), rows(studio), 0, reference.count(0, reference.isFacing(studio.key())));
                }
                case SPOT -> {
                    assertPlan(update, TURN);
                    assertWork(update, reference.count(0, reference.isFacing(before)), rows(studio), 0,
                            reference.count(0, reference.isOutsideCone(before).and(reference.isInsideCone(studio.key()))));
                    assertThat(studio.edit(_ -> before).rays().shadow()).as("after turning back").isZero();
                }
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void directionLength_isNoEdit(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type).withOutdatedMirrors()) {
            assertNothingDone(studio.edit(l -> l.withDirection(l.direction().times(2))));
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void movedLight_castsOneRayPerReachedRow(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            UpdateResult update = studio.edit(l -> l.withPosition(ELSEWHERE));
            if (type == LightType.DIRECTIONAL) {
                assertNothingDone(update);
            } else {
                ReferenceRows reference = studio.referenceRows();
                assertPlan(update, FULL);
                assertWork(update, rows(studio), rows(studio), 0, reference.count(0, reference.isReached(studio.key())));
            }
        }
    }

    static Stream<LightType[]> typeChanges() {
        // The light of an object has no position of its own; ObjectLightWorkTest has its work.
        List<LightType> placed = Stream.of(LightType.values()).filter(type -> type != LightType.OBJECT).toList();
        return placed.stream().flatMap(a -> placed.stream().filter(b -> a != b).map(b -> new LightType[] {a, b}));
    }

    @ParameterizedTest
    @MethodSource("typeChanges")
    void changedType_castsOnlyUnknownShadowRays(LightType from, LightType to) {
        try (StudioRenderer studio = StudioRenderer.of(from)) {
            ReferenceRows reference = studio.referenceRows();
            Light before = studio.key();
            UpdateResult update = studio.edit(l -> l.withType(to));
            boolean isTube = from == LightType.TUBE || to == LightType.TUBE;
            if (from.hasPosition() && to.hasPosition() && !from.isSurface() && !to.isSurface() && !isTube) {
                assertPlan(update, TURN);
                assertWork(update, reference.count(0, reference.isFacing(before)), rows(studio), 0,
                        from == LightType.SPOT ? reference.count(0, reference.isOutsideCone(before)) : 0);
                assertThat(studio.edit(_ -> before).rays().shadow()).as("after undo").isZero();
            } else {
                assertPlan(update, FULL);
                assertWork(update, rows(studio), rows(studio), 0, reference.count(0, reference.isReached(studio.key())));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void renamedLight_doesNothingAndReordered_onlyComposes(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            Light light = studio.key();
            assertNothingDone(studio.lights(_ -> List.of(light.withName("renamed"))));
            studio.lights(l -> List.of(l.getFirst(), light.withName("second")));
            UpdateResult update = studio.lights(List::reversed);
            assertPlan(update, KEEP, KEEP);
            assertWork(update, 0, rows(studio), 0, 0);
        }
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, mode = EnumSource.Mode.EXCLUDE, names = "OBJECT")
    void lightEditedWhileOff_isDeferred(LightType type) {
        try (StudioRenderer studio = StudioRenderer.of(type)) {
            studio.edit(l -> l.withOn(false));
            assertNothingDone(studio.edit(l -> l.withPosition(ELSEWHERE).withDirection(ASIDE).withIntensity(2)));
            UpdateResult update = studio.edit(l -> l.withOn(true));
            ReferenceRows reference = studio.referenceRows();
            assertPlan(update, FULL);
            assertWork(update, rows(studio), rows(studio), 0, reference.count(0, reference.isReached(studio.key())));
        }
    }

    @Test
    void editsOfTwoLights_costSumOfBoth() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.SPOT)) {
            studio.lights(l -> List.of(l.getFirst(), StudioScene.key(LightType.POINT).withName("other")));
            ReferenceRows reference = studio.referenceRows();
            long inside = reference.count(0, reference.isReached(studio.key()));
            Light moved = StudioScene.key(LightType.POINT).withName("other").withPosition(ELSEWHERE);
            UpdateResult update = studio.lights(l -> List.of(l.getFirst().withAngle(8).withIntensity(2), moved));
            assertPlan(update, new LightUpdate.Partial(ConeChange.ANGLE_REMOVE, false, true), FULL);
            assertWork(update, inside + rows(studio), rows(studio), 0, reference.count(0, reference.isReached(moved)));
        }
    }

    /** Its gain lifts its weight above the smallest float, but the weight of its film is 0. */
    @Test
    void lightWithoutWeight_castsNoRay_whateverItsGain() {
        try (StudioRenderer studio = StudioRenderer.of(LightType.POINT)) {
            studio.edit(l -> l.withIntensity(5e-46).withInfluence(Influence.DEFAULT.withDiffuse(2)));
            assertThat(studio.edit(l -> l.withPosition(ELSEWHERE)).rays().shadow()).isZero();
        }
    }
}
