package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ViewFocus;
import lightning.document.manipulation.Viewport;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.node.SceneNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NewBlockerTest {
    private static Scene scene(String lights) throws Exception {
        return JenReader.read("jen 1\ncamera { from 0 5 10 to 0 0 0 }\nplane floor { scale 20 1 20 }\n" + lights, "test.jen", Path.of(""))
                .scene();
    }

    private static SceneNode added(Scene scene, String light) {
        Scene after = ((EditOutcome.Applied) NewBlocker.add(scene, light)).scene();
        assertThat(after.material("blocker").orElseThrow().transmission().isSeen()).isFalse();
        return after.nodes().getLast();
    }

    @ParameterizedTest
    @ValueSource(strings = {"point { at 4 6 2 }", "spot { at -4 0.5 -3 }", "rect { at 0 6 0 }", "directional { direction 1 -2 -0.5 }",
        "directional { direction 0 -1 0 }"})
    void card_facesTheLightOnItsWay(String light) throws Exception {
        Scene scene = scene("light key " + light);
        SceneNode card = added(scene, "key");
        Vec3 focus = ViewFocus.of(scene);
        Vec3 toLight = scene.lights().getFirst().type().hasPosition() ? scene.lights().getFirst().position().minus(focus)
                : scene.lights().getFirst().direction().negated();
        Vec3 normal = card.placement().transform().transformVector(new Vec3(0, 1, 0)).normalized();
        assertThat(normal.dot(toLight.normalized())).isGreaterThan(1 - 1e-12);
        assertThat(card.placement().position().minus(focus).cross(toLight).length()).isLessThan(1e-9);
    }

    /** The handle is at the card's center. */
    @ParameterizedTest
    @ValueSource(strings = {"point { at 0 40 2 }", "spot { at -30 3 4 }", "directional { direction 0 -1 0 }", "point { at 0 30 60 }", ""})
    void handle_isInThePicture(String light) throws Exception {
        Scene scene = scene(light.isEmpty() ? "" : "light key " + light);
        Vec3 at = added(scene, "key").placement().position();
        Viewport.Pixel pixel = new Viewport(200, 200).project(PreviewCamera.of(scene), at);
        assertThat(pixel.x()).isBetween(10.0, 190.0);
        assertThat(pixel.y()).isBetween(10.0, 190.0);
        assertThat(PreviewCamera.of(scene).depth(at)).isPositive();
    }

    @Test
    void lightInView_getsCardHalfway() throws Exception {
        Scene scene = scene("light key point { at 2 2 1 }");
        Vec3 halfway = ViewFocus.of(scene).plus(new Vec3(2, 2, 1)).times(0.5);
        assertThat(added(scene, "key").placement().position().minus(halfway).length()).isLessThan(1e-9);
    }

    @Test
    void sceneWithoutLights_getsCardAbove() throws Exception {
        SceneNode card = added(scene(""), "");
        assertThat(card.placement().position().y()).isPositive();
    }

    @Test
    void secondBlocker_hasAnotherNameAndTheSameMaterial() throws Exception {
        Scene once = ((EditOutcome.Applied) NewBlocker.add(scene("light key point { at 1 2 3 }"), "key")).scene();
        Scene twice = ((EditOutcome.Applied) NewBlocker.add(once, "key")).scene();
        assertThat(twice.nodes()).extracting(SceneNode::name).containsExactly("floor", "blocker", "blocker2");
        assertThat(twice.materials()).hasSize(once.materials().size());
    }
}
