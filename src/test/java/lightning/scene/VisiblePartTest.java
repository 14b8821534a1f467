package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.editor.document.Change;
import lightning.editor.document.Desk;
import lightning.editor.document.Dial;
import lightning.editor.document.LightEdits;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.sample.Session;
import lightning.sample.Slow;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

@Slow
class VisiblePartTest {
    private final Scene scene = Desk.scene();

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    private boolean unseen(Change change) {
        return VisiblePart.same(scene, Desk.done(change));
    }

    @Test
    void attributesThatDoNotAct_areNotSeen() {
        assertThat(unseen(LightEdits.with(scene, "sun", l -> l.withPosition(new Vec3(9, 9, 9))))).isTrue();
        assertThat(unseen(Desk.dial("attenuation linear").set(scene, "sun", 3))).isTrue();
        assertThat(unseen(LightEdits.with(scene, "fill", l -> l.withDirection(new Vec3(9, 9, 9))))).isTrue();
        assertThat(unseen(Desk.dial("angle").set(scene, "fill", 3))).isTrue();
        assertThat(unseen(LightEdits.rename(scene, "key", "rim"))).isTrue();
    }

    @Test
    void attributesThatAct_areSeen() {
        for (Dial dial : Dial.ALL) {
            assertThat(LightType.values()).as(dial.title()).anySatisfy(type -> {
                Scene typed = Desk.done(LightEdits.type(scene, "key", type));
                assertThat(VisiblePart.same(typed, Desk.done(dial.set(typed, "key", Math.min(7, dial.steps().max()))))).isFalse();
            });
        }
        assertThat(unseen(LightEdits.with(scene, "key", l -> l.withPosition(Vec3.ZERO)))).isFalse();
        assertThat(unseen(LightEdits.with(scene, "sun", l -> l.withDirection(Vec3.Y)))).isFalse();
        assertThat(unseen(LightEdits.type(scene, "key", LightType.POINT))).isFalse();
        assertThat(unseen(LightEdits.on(scene, "key", false))).isFalse();
        assertThat(unseen(LightEdits.solo(scene, "key", true))).isFalse();
    }

    @Test
    void editsOfADarkLight_areNotSeen() {
        Scene off = Desk.done(LightEdits.on(scene, "key", false));
        assertThat(VisiblePart.same(off, Desk.done(LightEdits.with(off, "key", l -> l.withPosition(Vec3.ZERO))))).isTrue();
    }

    @Test
    void darkSoloLight_darkensTheEnvironmentStill() {
        Sky sky = new Sky(1, 1, new float[] {1, 1, 1});
        Scene solo = Desk.done(LightEdits.solo(Desk.done(Desk.dial("intensity").set(scene, "key", 0)), "key", true));
        Scene around = solo.withWorld(solo.world().withEnvironment(Optional.of(new Panorama("x.hdr", sky))));
        assertThat(VisiblePart.of(around).lights()).anyMatch(Light::solo);
        assertThat(VisiblePart.of(solo).lights()).noneMatch(Light::solo);
    }

    /** Everything hidden is taken away, and every bit of the picture stays. */
    @Property(tries = 60)
    void sceneWithItsVisiblePartsLights_givesTheSamePicture(@ForAll("sessions") Session session) {
        Scene any = session.scenes().getLast();
        Scene plain = new Scene(any.picture(), any.camera(), any.world(), any.materials(), any.nodes(),
                VisiblePart.of(any).lights().stream().map(l -> l.withName("unlike_" + l.name())).toList());
        try (var workers = new Workers(1)) {
            Film film = new TraditionalTracer(any).trace(workers, Progress.NONE).film();
            assertThat(new TraditionalTracer(plain).trace(workers, Progress.NONE).film().sameBits(film)).isTrue();
        }
    }
}
