package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;

/** Tests the steps by which plans are reported. */
class PlanDescriptionTest {
    private static Scene studio(int lights) {
        Scene scene = StudioScene.of(LightType.SPOT);
        return scene.withPicture(scene.picture().withDepth(0)).withLights(IntStream.range(0, lights)
                .mapToObj(i -> StudioScene.key(LightType.SPOT).withName("l" + i)).toList());
    }

    private static List<String> steps(Scene before, Scene target) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            return renderer.plan(target).update().steps();
        }
    }

    private static Scene edited(Scene scene, UnaryOperator<Light> edit) {
        return scene.withLights(scene.lights().stream().map(edit).toList());
    }

    @Test
    void fourLightsWithSameUpdate_areOneStep() {
        assertThat(steps(studio(4), edited(studio(4), l -> l.withIntensity(2)))).containsExactly("l0 to l3: weight");
        assertThat(steps(studio(3), edited(studio(3), l -> l.withIntensity(2)))).containsExactly("l0: weight", "l1: weight", "l2: weight");
    }

    @Test
    void lightsBetweenOthers_areCountedAlone() {
        Scene scene = studio(6);
        List<Light> lights = scene.lights();
        Scene target = edited(scene, l -> l == lights.getFirst() || l == lights.getLast() ? l.withDropoff(7) : l.withIntensity(2));
        assertThat(steps(scene, target)).containsExactly("l0: falloff", "l1 to l4: weight", "l5: falloff");
    }

    private static List<String> editSteps(UnaryOperator<Light> edit) {
        return steps(studio(1), edited(studio(1), edit));
    }

    @Test
    void partsOfUpdate_areNamed() {
        assertThat(editSteps(l -> l.withAngle(10))).containsExactly("l0: angle remove");
        assertThat(editSteps(l -> l.withAngle(30).withIntensity(2))).containsExactly("l0: angle add + weight");
        assertThat(editSteps(l -> l.withShadowedBy(ShapeLinks.NONE))).containsExactly("l0: shadows");
        assertThat(editSteps(l -> l.withIlluminates(ShapeLinks.only("ball")))).containsExactly("l0: links");
        assertThat(editSteps(l -> l.withDirection(new Vec3(-2, -4, -2)))).containsExactly("l0: turn + falloff");
        assertThat(editSteps(l -> l.withAttenuation(new Attenuation(1, 0, 0)).withShadowedBy(ShapeLinks.NONE).withIntensity(2)))
                .containsExactly("l0: falloff + shadows + weight");
        assertThat(editSteps(l -> l.withPosition(Vec3.Y))).containsExactly("l0: full recompute");
    }
}
