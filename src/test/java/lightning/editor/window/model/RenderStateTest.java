package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.render.gather.GatherRays;
import lightning.render.image.Film;
import lightning.render.measure.Timing;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.MaterialUpdate;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.ShapeChange;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class RenderStateTest {
    private static final Scene SCENE = StudioScene.of(LightType.POINT);
    private static final Film FILM = Film.black(2, 2);
    private static final UpdatePlan SAMPLES = new UpdatePlan.Relight(new LevelPlan(List.of(), List.of(),
            new MaterialUpdate(Geometry.of(SCENE).materials(), MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE, MaterialSet.NONE)),
            null, 2, 2, true, ShapeChange.NONE, PathUpdate.NONE);

    /** Frame of an update that took 60 ms in a cold JVM. */
    private static Frame frame(UpdatePlan plan) {
        return frame(plan, Frame.Step.ALL_LIGHT);
    }

    private static Frame frame(UpdatePlan plan, Frame.Step step) {
        return new Frame(FILM, FILM, DisplayMode.FULL_PICTURE, SCENE, SCENE,
                new UpdateResult(plan, 0, 0, 0, RayCounts.NONE, 60_000_000, 0, false), null, null, step,
                true);
    }

    private static WarmSaving saving(Frame frame) {
        return new WarmSaving(frame.update(), new Timing(List.of(2.0)), new Timing(List.of(29.0)));
    }

    private static String text(RenderState state) {
        return StatusText.of(state.frame(), state.saving());
    }

    @Test
    void saving_isShownForItsUpdate() {
        Frame edit = frame(SAMPLES);
        RenderState state = RenderState.NONE.withFrame(edit);
        assertThat(text(state)).contains("60 ms (measuring the saving…)").doesNotContain("%");
        assertThat(text(state.withMeasuredSaving(saving(edit)))).contains("60 ms · median 2.0 ms, full trace 29 ms · 93.1 % saved");
    }

    @Test
    void rays_areShownByPurpose() {
        RayCounts rays = RayCounts.ofShadows(Map.of("key", 4000L, "fill", 811L))
                .plus(RayCounts.of(new GatherRays(10, 300, 40, 5, List.of(60L, 25L))));
        var update = new UpdateResult(SAMPLES, 0, 0, 0, rays, 60_000_000, 0, false);
        assertThat(StatusText.of(update, true, "exact", Optional.empty()))
                .contains("4,811 shadow rays, 4,000 of key · 400 rays of indirect light · 40 rays of blurred reflections · ");
    }

    @Test
    void pictureOfCenters_isShownAsUnfinished() {
        Frame edit = frame(SAMPLES);
        var centers = new Frame(FILM, FILM, DisplayMode.FULL_PICTURE, SCENE, SCENE, edit.update(), null, null, Frame.Step.ALL_LIGHT, false);
        assertThat(text(RenderState.NONE.withFrame(centers))).endsWith("60 ms · not anti-aliased yet").doesNotContain("exact");
    }

    @Test
    void savingOfOlderUpdate_isNotShown() {
        Frame older = frame(SAMPLES);
        Frame newer = frame(SAMPLES);
        RenderState behind = RenderState.NONE.withFrame(older).withMeasuredSaving(saving(older)).withPlan(SAMPLES).withFrame(newer);
        assertThat(behind.saving()).isEmpty();
        assertThat(text(behind)).doesNotContain("%", "slower");
        RenderState late = RenderState.NONE.withFrame(newer).withMeasuredSaving(saving(older));
        assertThat(late.saving()).as("saving of an earlier edit").isEmpty();
    }

    @Test
    void stepOfIndirectLight_isNamed() {
        assertThat(StatusText.shortText(RenderState.NONE.withFrame(frame(SAMPLES)))).startsWith("Updated in 60 ms");
        Frame direct = frame(SAMPLES, Frame.Step.DIRECT_LIGHT);
        assertThat(StatusText.shortText(RenderState.NONE.withFrame(direct))).startsWith("Updated in 60 ms");
        Frame indirect = frame(SAMPLES, Frame.Step.INDIRECT_LIGHT);
        assertThat(StatusText.shortText(RenderState.NONE.withFrame(indirect))).startsWith("Indirect light in 60 ms");
    }

    @Test
    void otherDisplayMode_keepsMeasuredSaving() {
        Frame edit = frame(SAMPLES);
        Frame look = new Frame(FILM, FILM, DisplayMode.FULL_PICTURE.withLight(Optional.of("key")), SCENE, SCENE, edit.update(), null, null,
                Frame.Step.ALL_LIGHT,
                true);
        assertThat(RenderState.NONE.withFrame(edit).withMeasuredSaving(saving(edit)).withFrame(look).saving()).isPresent();
    }

    @Test
    void firstPassAndNoUpdate_showNoPendingSaving() {
        for (UpdatePlan plan : List.of(new UpdatePlan.FirstPass("resolution changed"), new UpdatePlan.Nothing())) {
            assertThat(text(RenderState.NONE.withFrame(frame(plan)))).contains("60 ms · exact");
        }
    }
}
