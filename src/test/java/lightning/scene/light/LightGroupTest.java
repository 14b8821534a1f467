package lightning.scene.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.shading.RayCounts;
import lightning.render.shading.WeightedLight;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;
import lightning.scene.VisibleState;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;

class LightGroupTest {
    private static final LightGroup LEFT = LightGroup.of("left");
    private static final Light KEY =
            Light.of("key", LightType.POINT).withColor(new Rgb(1, 0.5, 0.25)).withIntensity(3).withLightGroup("left");
    private static final Light FREE = Light.of("free", LightType.POINT);

    private static LightRig rig(LightGroup... banks) {
        return LightRig.of(List.of(KEY, FREE), List.of(banks));
    }

    private static Light effective(LightRig rig, String light) {
        return rig.effectiveLight(rig.light(light).orElseThrow());
    }

    @Test
    void colorAndIntensity_scaleOnlyItsLights() {
        LightRig rig = rig(LEFT.withColor(new Rgb(0.5, 1, 0)).withIntensity(2));
        assertThat(effective(rig, "key")).isEqualTo(KEY.withLightGroup("").withColor(new Rgb(0.5, 0.5, 0)).withIntensity(6));
        assertThat(effective(rig, "free")).isEqualTo(FREE);
    }

    @Test
    void intensityAboveLimit_isClamped() {
        LightRig rig = rig(LEFT.withIntensity(1000)).with(KEY.withIntensity(1e30));
        assertThat(effective(rig, "key").intensity()).isEqualTo(SceneLimits.MAX_INTENSITY);
    }

    @Test
    void groupOff_turnsOffOnlyItsLights() {
        LightRig rig = rig(LEFT.withOn(false));
        assertThat(rig.isActive(KEY)).isFalse();
        assertThat(rig.isActive(FREE)).isTrue();
    }

    @Test
    void soloGroup_turnsOffAllOthers() {
        LightRig rig = rig(LEFT.withSolo(true));
        assertThat(rig.isActive(KEY)).isTrue();
        assertThat(rig.isActive(FREE)).isFalse();
        assertThat(rig.with(LEFT.withSolo(true).withOn(false)).isActive(FREE)).as("it is off").isTrue();
        assertThat(rig.with(KEY.withOn(false)).isActive(FREE)).as("none of its lights is on").isTrue();
    }

    @Test
    void renamedGroup_keepsItsLights() {
        assertThat(rig(LEFT).renameLightGroup("left", "right"))
                .isEqualTo(LightRig.of(List.of(KEY.withLightGroup("right"), FREE), List.of(LightGroup.of("right"))));
    }

    @Test
    void deletedGroup_ungroupsItsLights() {
        assertThat(rig(LEFT).removeLightGroup("left")).isEqualTo(LightRig.of(List.of(KEY.withLightGroup(""), FREE)));
    }

    @Test
    void lightOfMissingGroup_isRejected() {
        assertThatThrownBy(() -> rig(LightGroup.of("right"))).hasMessage("light 'key': there is no light group 'left'");
    }

    @Test
    void duplicateName_isRejected() {
        assertThatThrownBy(() -> rig(LEFT, LEFT)).hasMessage("light group 'left': the name is already taken");
        assertThatThrownBy(() -> rig(LEFT, LightGroup.of("free"))).hasMessage("light group 'free': the name is already taken");
        Scene studio = StudioScene.of(LightType.POINT);
        String shape = studio.nodes().getFirst().name();
        assertThatThrownBy(() -> studio.withRig(studio.rig().addLightGroup(LightGroup.of(shape))))
                .hasMessage("light group '" + shape + "': the name is already taken");
    }

    @Test
    void groupChanges_areDescribed() {
        Scene studio = StudioScene.of(LightType.POINT);
        Scene banked = studio.withRig(studio.rig().addLightGroup(LEFT));
        assertThat(SceneDiff.describe(studio, banked)).isEqualTo("add left");
        assertThat(SceneDiff.describe(banked, studio)).isEqualTo("delete left");
        assertThat(SceneDiff.describe(banked, banked.withRig(banked.rig().with(LEFT.withIntensity(0.5).withOn(false)))))
                .isEqualTo("left: intensity 1 → 0.5, on yes → no");
        assertThat(SceneDiff.describe(banked, banked.withRig(banked.rig().renameLightGroup("left", "rear"))))
                .isEqualTo("left: name left → rear");
    }

    /** For any number of lights: casts no ray, writes no column, and composes only visible pixels. */
    @Test
    void groupEdit_onlyComposes() {
        Scene studio = StudioScene.of(LightType.SPOT);
        LightRig rig = LightRig.of(studio.lights().stream().map(l -> l.withLightGroup("left")).toList(), List.of(LEFT));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(studio.withRig(rig), Progress.NONE);
            List<LightRig> edits =
                    Stream.of(LEFT.withColor(new Rgb(1, 0, 0)), LEFT.withIntensity(0.5), LEFT.withOn(false), LEFT, LEFT.withSolo(true))
                            .map(rig::with).toList();
            for (LightRig edited : edits) {
                var update = renderer.render(studio.withRig(edited), Progress.NONE);
                assertThat(update.rays()).as(update.plan().description()).isEqualTo(RayCounts.NONE);
                assertThat(update.rowsTouched()).isZero();
            }
            var renamed = renderer.render(studio.withRig(edits.getLast().renameLightGroup("left", "right")), Progress.NONE);
            assertThat(renamed.rowsComposed()).isZero();
        }
    }

    /** A rig without groups returns its lights unchanged, and neutral groups keep every bit. */
    @Test
    void ungroupedLights_areSameInstances() {
        LightRig plain = LightRig.of(List.of(FREE), List.of(LEFT));
        assertThat(plain.effectiveLights()).isSameAs(plain.lights());
        Scene studio = StudioScene.of(LightType.SPOT);
        Scene banked = studio.withRig(LightRig.of(studio.lights().stream().map(l -> l.withLightGroup("left")).toList(), List.of(LEFT)));
        assertThat(WeightedLight.ofScene(banked)).isEqualTo(WeightedLight.ofScene(studio));
        assertThat(VisibleState.isSame(studio, banked)).isTrue();
    }
}
