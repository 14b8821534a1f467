package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Quote;
import lightning.sample.StudioScene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class SceneTest {
    private final Scene scene = StudioScene.of(LightType.SPOT);

    @Test
    void lightsMaterialsAndDepth_keepShapes() {
        for (Scene other : List.of(scene, scene.withLights(List.of()), scene.withPicture(scene.picture().withDepth(7)),
                scene.withWorld(scene.world().withAmbience(0.5)),
                scene.withMaterials(scene.materials().stream().map(m -> m.withDiffuse(Rgb.BLACK)).toList()))) {
            assertThat(scene.hasSameShapes(other)).isTrue();
        }
    }

    /** After an edit, names are checked again only if they may have changed. */
    @Test
    void lightNamedLikeShape_isRejected() {
        Light light = scene.lights().getFirst();
        Scene edited = scene.withLight(light.withIntensity(0.25));
        List<SceneNode> nodes = List.of(new Shape(Solid.SPHERE, light.name(), Material.DEFAULT.name(), Placement.IDENTITY));
        String reason = "light " + Quote.of(light.name()) + ": the name is already taken";
        assertThatThrownBy(() -> edited.withNodes(nodes)).hasMessage(reason);
        assertThatThrownBy(() -> scene.withNodes(nodes)).hasMessage(reason);
        Scene free = edited.withLights(List.of()).withNodes(nodes);
        assertThatThrownBy(() -> free.withLight(light)).hasMessageContaining("there is no light");
        assertThatThrownBy(() -> free.withRig(edited.rig())).hasMessage(reason);
    }

    @Test
    void cameraSizeOrShapeEdit_changesShapes() {
        Camera c = scene.camera();
        for (Scene other : List.of(scene.withCamera(new Camera(c.from().plus(Vec3.Y), c.to(), c.up(), c.fov())),
                scene.withPicture(scene.picture().withSize(scene.picture().width(), 3)),
                scene.withPicture(scene.picture().withSize(3, scene.picture().height())),
                scene.withNodes(scene.nodes().subList(1, scene.nodes().size())))) {
            assertThat(scene.hasSameShapes(other)).isFalse();
        }
    }

    @Test
    void shapeEdit_keepsView() {
        assertThat(scene.hasSameView(scene.withNodes(List.of()))).isTrue();
        assertThat(scene.hasSameView(scene.withPicture(scene.picture().withSize(3, scene.picture().height())))).isFalse();
    }
}
