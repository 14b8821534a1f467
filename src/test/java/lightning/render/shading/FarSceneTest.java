package lightning.render.shading;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.NodeGroup;
import lightning.scene.value.Placement;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a scene far from the origin is rendered as precisely as at the origin. */
class FarSceneTest {

    /** Returns a scene translated with its camera. All coordinates of the studio are whole numbers, so none is rounded. */
    private static Scene moved(Scene scene, Vec3 offset) {
        Camera c = scene.camera();
        Scene moved = new Scene(scene.picture(), new Camera(c.from().plus(offset), c.to().plus(offset), c.up(), c.fov()), scene.world(),
                scene.materials(),
                List.of(new NodeGroup("all", new Placement(offset, Vec3.ZERO, Vec3.ONE), scene.nodes())), List.of());
        return moved.withLights(scene.lights().stream().map((Light l) -> l.withPosition(l.position().plus(offset))).toList());
    }

    /** At 2²² floats are half a unit apart, at 2³⁹ 65 536 units: the radius of the spheres is 1. */
    @ParameterizedTest
    @ValueSource(doubles = {0x1p10, 0x1p22, 0x1p39})
    void sceneFarFromOrigin_hasSameBits(double far) {
        for (LightType type : LightType.values()) {
            Scene scene = StudioScene.of(type);
            FilmAssert.assertSameBits(new ReferenceTracer(moved(scene, new Vec3(far, -far / 2, 3 * far / 4))).trace(),
                    new ReferenceTracer(scene).trace(), "moved");
        }
    }
}
