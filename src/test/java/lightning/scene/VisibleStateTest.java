package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.DoubleStream;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.document.AttributeNumber;
import lightning.document.DeskScene;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.format.jen.JenReader;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Falloff;
import lightning.scene.light.FilterShape;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

@Slow
class VisibleStateTest {
    private final Scene scene = DeskScene.scene();

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    private boolean isInvisible(EditOutcome change) {
        return VisibleState.isSame(scene, DeskScene.sceneOf(change));
    }

    @Test
    void inactiveAttributes_areInvisible() {
        assertThat(isInvisible(LightEdits.edit(scene, "sun", l -> l.withPosition(new Vec3(9, 9, 9))))).isTrue();
        assertThat(isInvisible(DeskScene.parameter("attenuation linear").set(scene, "sun", 3))).isTrue();
        assertThat(isInvisible(LightEdits.edit(scene, "fill", l -> l.withDirection(new Vec3(9, 9, 9))))).isTrue();
        assertThat(isInvisible(DeskScene.parameter("angle").set(scene, "fill", 3))).isTrue();
        assertThat(isInvisible(LightEdits.rename(scene, "key", "rim"))).isTrue();
    }

    @Test
    void activeAttributes_areVisible() {
        for (AttributeNumber<?, ?> dial : AttributeNumber.ALL) {
            assertThat(LightType.values()).as(dial.title()).anySatisfy(type -> {
                Scene bare = DeskScene.sceneOf(LightEdits.setType(scene, "key", type));
                Scene typed = DeskScene.sceneOf(LightEdits.edit(bare, "key", l -> l.withFlag(LightFlag.NONE.withOn(true))
                        .withFilter(LightFilter.NONE.withShape(FilterShape.BOX))));
                // One of two values may be the scene's own.
                assertThat(
                        DoubleStream.of(7, 0).mapToObj(v -> dial.set(typed, "key", Math.clamp(v, dial.range().min(), dial.range().max()))))
                        .anyMatch(edited -> !VisibleState.isSame(typed, DeskScene.sceneOf(edited)));
            });
        }
        assertThat(isInvisible(LightEdits.edit(scene, "key", l -> l.withPosition(Vec3.ZERO)))).isFalse();
        assertThat(isInvisible(LightEdits.edit(scene, "sun", l -> l.withDirection(Vec3.Y)))).isFalse();
        assertThat(isInvisible(LightEdits.setType(scene, "key", LightType.POINT))).isFalse();
        assertThat(isInvisible(LightEdits.setOn(scene, "key", false))).isFalse();
        assertThat(isInvisible(LightEdits.setSolo(scene, "key", true))).isFalse();
    }

    @Test
    void flagThatIsOff_isInvisible() {
        assertThat(isInvisible(LightEdits.edit(scene, "key", l -> l.withFlag(LightFlag.NONE.withWidth(7))))).isTrue();
        assertThat(isInvisible(LightEdits.edit(scene, "key", l -> l.withFilter(LightFilter.NONE.withDensity(0.5))))).isTrue();
    }

    @Test
    void darkLightEdits_areInvisible() {
        Scene off = DeskScene.sceneOf(LightEdits.setOn(scene, "key", false));
        assertThat(VisibleState.isSame(off, DeskScene.sceneOf(LightEdits.edit(off, "key", l -> l.withPosition(Vec3.ZERO))))).isTrue();
    }

    @Test
    void darkSoloLight_turnsOffEnvironment() {
        EnvironmentMap sky = new EnvironmentMap(1, 1, new float[] {1, 1, 1});
        Scene solo = DeskScene
                .sceneOf(LightEdits.setSolo(DeskScene.sceneOf(DeskScene.parameter("intensity").set(scene, "key", 0)), "key", true));
        Scene around = solo.withWorld(solo.world().withEnvironment(Optional.of(new Environment("x.hdr", sky))));
        assertThat(VisibleState.of(around).lights()).anyMatch(Light::solo);
        assertThat(VisibleState.of(solo).lights()).noneMatch(Light::solo);
    }

    /** A light in nits is dark without its size, a relative one is not. */
    @Test
    void brightLightInNits_hasNormalForm() throws Exception {
        Scene bright = JenReader.read("""
                jen 1
                sphere "ball" { material "gold" }
                material "gold" { model metallic  roughness 0 }
                light "lamp" disc { radius 0.2  unit nit  intensity 1e22  falloff inverse_square }
                """, "test", Path.of("")).scene();
        assertThat(VisibleState.of(bright).lights().getFirst().weight()).isEqualTo(bright.rig().effectiveLights().getFirst().weight());
    }

    /** Hides a face whose color depends on the unit, which the normal form does not have. */
    private static Light withoutLuminance(Light light) {
        return light.falloff() == Falloff.CUSTOM && light.emission().unit() == IntensityUnit.NIT ? LightAttribute.VISIBLE.with(light, false)
                : light;
    }

    /** Checks that the normal form renders the same image in every bit. */
    @Property
    void visibleState_rendersSamePicture(@ForAll("sessions") EditSession session) {
        Scene last = session.scenes().getLast();
        // Bulbs find their lights by name.
        Scene any = last.withMaterials(last.materials().stream().map(m -> m.withBulb(Bulb.NONE)).toList())
                .withLights(last.lights().stream().map(VisibleStateTest::withoutLuminance).toList());
        Scene plain = new Scene(any.picture(), any.camera(), any.world(), any.materials(), any.nodes(),
                VisibleState.of(any).lights().stream().map(l -> l.withName("unlike_" + l.name())).toList());
        try (var workers = new WorkerPool(1)) {
            Film film = new TraditionalTracer(any).trace(workers, Progress.NONE).film();
            assertThat(new TraditionalTracer(plain).trace(workers, Progress.NONE).film().hasSameBits(film)).isTrue();
        }
    }
}
