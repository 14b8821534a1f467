package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.DeskScene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class SceneDiffTest {
    private final Scene scene = DeskScene.scene();
    private final Light sun = DeskScene.light(scene, "sun");

    private String diffTo(Scene after) {
        return SceneDiff.describe(scene, after);
    }

    @Test
    void attributes_showBothValues() {
        assertThat(diffTo(scene.withLight(sun.withColor(new Rgb(1, 0, 0)).withIntensity(1 / 3.0).withOn(false))))
                .isEqualTo("sun: color 1 1 1 → 1 0 0, intensity 0.3 → 0.3333, on yes → no");
        assertThat(diffTo(scene.withLight(sun.withType(LightType.SPOT).withAngle(12).withPosition(new Vec3(4, 5, 6)))))
                .isEqualTo("sun: type directional → spot, position 1 2 3 → 4 5 6, angle 30 → 12");
        assertThat(diffTo(scene.withWorld(scene.world().withAmbience(0.1)))).isEqualTo("ambience 1 → 0.1");
        assertThat(diffTo(scene.withPicture(scene.picture().withDepth(9)))).isEqualTo("depth 2 → 9");
        assertThat(diffTo(scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 3)))))
                .isEqualTo("anti-aliasing off 4 × 4 → edges 3 × 3");
        Scene indirect = scene.withPicture(scene.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT)));
        assertThat(diffTo(indirect)).isEqualTo("indirect light off → 2 bounces, 64 rays, every 8 pixels");
        assertThat(SceneDiff.describe(indirect, scene.withPicture(
                scene.picture().withIndirect(Optional.of(new IndirectSettings(3, 64, 8, true))))))
                .isEqualTo("indirect bounces 2 → 3, indirect background off → on");
        assertThat(diffTo(scene.withPicture(scene.picture().withView(new ViewSettings(ViewCurve.AGX, 0.5)))))
                .isEqualTo("view transform srgb → agx, view exposure 0 → 0.5");
        assertThat(diffTo(scene.withWorld(scene.world().withBackground(Rgb.WHITE)))).isEqualTo("background 0 0 0 → 1 1 1");
    }

    @Test
    void materials_showBothValues() {
        Scene textured = scene.withMaterial(scene.material("mirror").orElseThrow()
                .withTexture(Optional.of(new TextureMap("wood.png", 2, 1, new Texture(1, 1, new float[3])))));
        assertThat(diffTo(textured)).isEqualTo("mirror: texture none → wood.png 2 × 1");
        assertThat(SceneDiff.describe(textured, scene.withMaterial(scene.material("mirror").orElseThrow().withReflective(Rgb.gray(0.25)))))
                .isEqualTo("mirror: texture wood.png 2 × 1 → none, reflective 0.4 0.4 0.4 → 0.25 0.25 0.25");
    }

    @Test
    void draggedShape_showsFewDigits() {
        SceneNode node = scene.nodes().getFirst();
        Placement p = node.placement();
        SceneNode dragged = node.withPlacement(new Placement(new Vec3(1.6106858861516402, 0, -1e-9 / 3), p.rotation(), p.scale()));

        assertThat(diffTo(scene.withNode(node.name(), dragged))).endsWith(" → 1.611 0 -3.333e-10");
    }

    @Test
    void lights_addedDeletedRenamed_areDescribed() {
        List<Light> more = new ArrayList<>(scene.lights());
        more.add(Light.of("rim", LightType.POINT));
        assertThat(diffTo(scene.withLights(more))).isEqualTo("add rim, point");
        assertThat(diffTo(scene.withLights(scene.lights().stream().filter(l -> l != sun).toList()))).isEqualTo("delete sun");
        assertThat(diffTo(scene.withLights(scene.lights().stream().map(l -> l == sun ? l.withName("moon") : l).toList())))
                .isEqualTo("sun: name sun → moon");
        assertThat(diffTo(scene.withLights(scene.lights().reversed()))).isEqualTo("order of lights");
    }

    @Test
    void shapes_showBothValues() {
        SceneNode node = scene.nodes().getFirst();
        Placement p = node.placement();
        SceneNode moved = node.withPlacement(new Placement(new Vec3(1, 2, 3), p.rotation(), p.scale())).withVisible(false);
        assertThat(diffTo(scene.withNode(node.name(), moved))).startsWith(node.name() + ": position ")
                .endsWith(" → 1 2 3, visible yes → no");
        assertThat(diffTo(scene.withNodes(List.of()))).isEqualTo("delete ground, delete ball");
        assertThat(diffTo(scene.withNodes(scene.nodes().reversed()))).isEqualTo("the scene");
    }

    @Test
    void addedAndDeletedShapes_areNamed() {
        Shape ball = (Shape) scene.stage().node("ball").orElseThrow();
        assertThat(diffTo(scene.replaceNode("ball", List.of()))).isEqualTo("delete ball");
        assertThat(diffTo(scene.replaceNode("ball", List.of(ball, ball.withName("ball2"))))).isEqualTo("add ball2");
        assertThat(diffTo(scene.replaceNode("ball", List.of(ball.withName("globe"))))).isEqualTo("ball: name ball → globe");
        assertThat(diffTo(scene.replaceNode("ball", List.of(ball.withSolid(new Solid.Cone(true)))))).isEqualTo("the scene");
    }

    @Test
    void changeBelowDisplayPrecision_isALittle() {
        assertThat(diffTo(scene.withLight(sun.withIntensity(sun.intensity() + 1e-9)))).isEqualTo("sun: small change");
    }

    @Test
    void firstLightMovedToTheEnd_isAChangeOfOrder() {
        List<Light> moved = new ArrayList<>(scene.lights().subList(1, scene.lights().size()));
        moved.add(scene.lights().getFirst());
        assertThat(diffTo(scene.withLights(moved))).isEqualTo("order of lights");
    }

    @Test
    void materialsOfOtherNames_areNotDescribed() {
        List<Material> more = new ArrayList<>(scene.materials());
        more.add(scene.material("mirror").orElseThrow().withName("spare"));
        assertThat(diffTo(scene.withMaterials(more).withLight(sun.withIntensity(1)))).isEqualTo("sun: intensity 0.3 → 1, the scene");
    }

    @Test
    void upToThreeNodes_areDescribed() {
        Scene brighter = scene.withLight(sun.withIntensity(1));
        assertThat(diffTo(brighter.withNodes(withBalls(3)))).isEqualTo("sun: intensity 0.3 → 1, add ball0, add ball1, add ball2");
        assertThat(diffTo(brighter.withNodes(withBalls(4)))).isEqualTo("sun: intensity 0.3 → 1, the scene");
    }

    @Test
    void deletedNodes_betweenOthers_areNamed() {
        Scene before = scene.withNodes(withBalls(4));
        List<SceneNode> rest = new ArrayList<>(before.nodes());
        rest.subList(2, 4).clear();
        assertThat(SceneDiff.describe(before, scene.withNodes(rest))).isEqualTo("delete ball0, delete ball1");
    }

    @Test
    void shapeInGroup_showsBothValues() {
        Shape ball = (Shape) scene.stage().node("ball").orElseThrow();
        Placement p = ball.placement();
        NodeGroup group = new NodeGroup("pair", Placement.IDENTITY, List.of(ball.withName("left"), ball.withName("right")));
        Scene before = scene.replaceNode("ball", List.of(group));
        Shape turned = ball.withName("right").withMaterial("mirror")
                .withPlacement(new Placement(p.position(), new Vec3(0, 45, 0), new Vec3(2, 1, 1)));
        Scene after = scene.replaceNode("ball", List.of(group.withChildren(List.of(ball.withName("left"), turned))));
        assertThat(SceneDiff.describe(before, after)).isEqualTo("right: material " + ball.material()
                + " → mirror, rotation 0 0 0 → 0 45 0, scale 1 1 1 → 2 1 1");
    }

    @Test
    void shapeThatBecomesAGroup_isNotDescribed() {
        Scene brighter = scene.withLight(sun.withIntensity(1));
        assertThat(diffTo(brighter.replaceNode("ball", List.of(new NodeGroup("ball", Placement.IDENTITY, List.of())))))
                .isEqualTo("sun: intensity 0.3 → 1, the scene");
        assertThat(diffTo(brighter.replaceNode("ball", List.of(((Shape) scene.stage().node("ball").orElseThrow())
                .withSolid(new Solid.Cone(true)))))).isEqualTo("sun: intensity 0.3 → 1, the scene");
    }

    @Test
    void otherSolidInGroup_isNotDescribed() {
        Shape ball = (Shape) scene.stage().node("ball").orElseThrow();
        NodeGroup group = new NodeGroup("g", Placement.IDENTITY, List.of(ball));
        Scene before = scene.replaceNode("ball", List.of(group));
        Scene after = before.replaceNode("ball", List.of(ball.withSolid(new Solid.Cone(true)))).withLight(sun.withIntensity(1));
        assertThat(SceneDiff.describe(before, after)).isEqualTo("sun: intensity 0.3 → 1, the scene");
    }

    /** Scenes of so many nodes share the blocks of nodes that an edit leaves unchanged. */
    @Test
    void editAmongManyNodes_isDescribed() {
        Scene before = scene.withNodes(withBalls(10_000));
        Shape ball = (Shape) before.stage().node("ball5000").orElseThrow();
        assertThat(SceneDiff.describe(before, before.withNode("ball5000", ball.withName("globe"))))
                .isEqualTo("ball5000: name ball5000 → globe");
        assertThat(SceneDiff.describe(before, before.replaceNode("ball5000", List.of()))).isEqualTo("delete ball5000");
    }

    private List<SceneNode> withBalls(int count) {
        Shape ball = (Shape) scene.stage().node("ball").orElseThrow();
        List<SceneNode> nodes = new ArrayList<>(scene.nodes());
        for (int i = 0; i < count; i++) {
            nodes.add(ball.withName("ball" + i));
        }
        return nodes;
    }
}
