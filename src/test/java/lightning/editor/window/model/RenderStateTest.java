package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.bench.accuracy.Timing;
import lightning.bench.accuracy.WarmSaving;
import lightning.editor.loop.Frame;
import lightning.editor.loop.Look;
import lightning.editor.loop.RenderState;
import lightning.render.image.Film;
import lightning.render.relight.Update;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.MaterialUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.ShapeChange;
import lightning.sample.StudioScene;
import lightning.scene.LightType;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class RenderStateTest {
    private static final Scene SCENE = StudioScene.of(LightType.POINT);
    private static final Film FILM = Film.black(2, 2);
    private static final UpdatePlan SAMPLES = new UpdatePlan.Relight(new LevelPlan(List.of(), List.of(), true,
            new MaterialUpdate(new Geometry(SCENE).materials(), MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE)),
            null, 2, 2, true, ShapeChange.NONE);

    /** Took 60 ms in cold code. */
    private static Frame frame(UpdatePlan plan) {
        return new Frame(FILM, FILM, Look.PLAIN, SCENE, SCENE, new Update(plan, 0, 0, 0, TraceCounts.NONE, 60_000_000, 0, false), null,
                true);
    }

    private static WarmSaving saving(Frame of) {
        return new WarmSaving(of.update(), new Timing(List.of(2.0)), new Timing(List.of(29.0)));
    }

    private static String text(RenderState state) {
        return StatusText.of(state.frame(), state.saving());
    }

    @Test
    void saving_isToldOfTheUpdateThatItWasMeasuredOf() {
        Frame edit = frame(SAMPLES);
        RenderState state = RenderState.NONE.rendered(edit);
        assertThat(text(state)).contains("60 ms (what it saves is being measured)").doesNotContain("%");
        assertThat(text(state.measured(saving(edit)))).contains("60 ms · made again 2.0 ms of 29 ms for a full trace · 93.1 % saved");
    }

    @Test
    void pictureOfCentres_isToldToLackItsSamples() {
        Frame edit = frame(SAMPLES);
        var centers = new Frame(FILM, FILM, Look.PLAIN, SCENE, SCENE, edit.update(), null, false);
        assertThat(text(RenderState.NONE.rendered(centers))).endsWith("60 ms · without finer samples yet").doesNotContain("exact");
    }

    @Test
    void savingOfAnOlderUpdate_isToldOfNoOther() {
        Frame older = frame(SAMPLES);
        Frame newer = frame(SAMPLES);
        RenderState behind = RenderState.NONE.rendered(older).measured(saving(older)).started(SAMPLES).rendered(newer);
        assertThat(behind.saving()).isEmpty();
        assertThat(text(behind)).doesNotContain("%", "slower");
        RenderState late = RenderState.NONE.rendered(newer).measured(saving(older));
        assertThat(late.saving()).as("of an edit that is over").isEmpty();
    }

    @Test
    void anotherLook_isStillThePictureThatWasMeasured() {
        Frame edit = frame(SAMPLES);
        Frame look = new Frame(FILM, FILM, Look.PLAIN.withLight(Optional.of("key")), SCENE, SCENE, edit.update(), null, true);
        assertThat(RenderState.NONE.rendered(edit).measured(saving(edit)).rendered(look).saving()).isPresent();
    }

    @Test
    void firstPassAndNothing_waitForNoSaving() {
        for (UpdatePlan plan : List.of(new UpdatePlan.FirstPass("another size"), new UpdatePlan.Nothing())) {
            assertThat(text(RenderState.NONE.rendered(frame(plan)))).contains("60 ms · exact");
        }
    }
}
