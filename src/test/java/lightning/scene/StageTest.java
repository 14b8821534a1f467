package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Tests stages, which are checked once and shared by scenes that differ in lights. */
class StageTest {
    private static final Material GOLD = Material.DEFAULT.withShininess(50);
    private static final Stage STAGE = new Stage(List.of(), List.of(group("g", sphere("a"), sphere("b")), sphere("c")));

    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static NodeGroup group(String name, SceneNode... children) {
        return new NodeGroup(name, Placement.IDENTITY, List.of(children));
    }

    private static Scene activeLights(Light... lights) {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, STAGE, LightRig.of(List.of(lights)));
    }

    @Test
    void editedLight_sharesTheStage() {
        Scene scene = activeLights(Light.of("key", LightType.POINT));
        assertThat(scene.withLight(Light.of("key", LightType.SPOT)).stage()).isSameAs(STAGE);
    }

    @Test
    void editedMaterial_sharesTheNodes() {
        assertThat(STAGE.withMaterials(List.of(GOLD)).nodes()).isSameAs(STAGE.nodes());
    }

    @Test
    void sameMaterials_returnSameStage() {
        assertThat(STAGE.withMaterials(List.of())).isSameAs(STAGE);
    }

    @Test
    void shapesInGroups_areCounted() {
        assertThat(STAGE.shapeCount()).isEqualTo(3);
    }

    @Test
    void groupsAndShapes_areFoundByName() {
        assertThat(List.of("g", "a", "b", "c")).allMatch(STAGE::hasNode);
        assertThat(STAGE.hasNode("d")).isFalse();
    }

    @Test
    void duplicateShapeName_isRejected() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> STAGE.withNodes(List.of(group("g", sphere("a")), sphere("a"))))
                .withMessage("object 'a': the name is already taken");
    }

    @Test
    void usedMaterial_cannotBeDeleted() {
        Material wood = Material.of("wood").withAmbient(GOLD.ambient()).withDiffuse(GOLD.diffuse()).withSpecular(GOLD.specular())
                .withShininess(1).withReflective(GOLD.reflective()).withTexture(GOLD.texture());
        Stage wooden = new Stage(List.of(wood), List.of(new Shape(Solid.CONE, "hat", "wood", Placement.IDENTITY)));
        assertThatIllegalArgumentException().isThrownBy(() -> wooden.withMaterials(List.of()))
                .withMessage("object 'hat': there is no material 'wood'");
    }

    @Test
    void lightNamedLikeShape_isRejected() {
        assertThatIllegalArgumentException().isThrownBy(() -> activeLights(Light.of("b", LightType.POINT)))
                .withMessage("light 'b': the name is already taken");
    }

    @Test
    void duplicateLightName_isRejected() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> activeLights(Light.of("key", LightType.POINT), Light.of("key", LightType.SPOT)))
                .withMessage("light 'key': the name is already taken");
    }

    @Test
    void soloLight_turnsOffOthers() {
        Light solo = Light.of("solo", LightType.POINT).withSolo(true);
        Light plain = Light.of("plain", LightType.POINT);
        assertThat(activeLights(solo, plain).isActive(solo)).isTrue();
        assertThat(activeLights(solo, plain).isActive(plain)).isFalse();
    }

    @Test
    void soloLightOff_hasNoEffect() {
        Light solo = Light.of("solo", LightType.POINT).withSolo(true).withOn(false);
        Light plain = Light.of("plain", LightType.POINT);
        assertThat(activeLights(solo, plain).isActive(plain)).isTrue();
    }
}
