package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class GroupBoundsTest {
    private static Shape shape(Solid solid, String name, Vec3 at) {
        return new Shape(solid, name, Material.DEFAULT.name(), new Placement(at, Vec3.ZERO, Vec3.ONE));
    }

    private static Scene scene(NodeGroup group) {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, new Stage(List.of(), List.of(group)), LightRig.EMPTY);
    }

    private static List<Vec3> corners(NodeGroup group) {
        return new GroupBounds().lines(scene(group), group).stream().flatMap(l -> Stream.of(l.from(), l.to())).distinct().toList();
    }

    @Test
    void bounds_containAllChildren() {
        NodeGroup group = new NodeGroup("g", new Placement(new Vec3(10, 0, 0), Vec3.ZERO, Vec3.ONE), List.of(
                shape(Solid.SPHERE, "ball", new Vec3(0, 1, 0)), shape(Solid.CYLINDER, "post", new Vec3(4, 0, 0))), false);
        assertThat(corners(group)).containsExactlyInAnyOrder(new Vec3(9, 0, -1), new Vec3(9, 0, 1), new Vec3(9, 2, -1), new Vec3(9, 2, 1),
                new Vec3(15, 0, -1), new Vec3(15, 0, 1), new Vec3(15, 2, -1), new Vec3(15, 2, 1));
    }

    @Test
    void emptyGroup_hasNoBounds() {
        assertThat(corners(new NodeGroup("g", Placement.IDENTITY, List.of(), true))).isEmpty();
    }

    @Test
    void edgeBehindEye_isClipped() {
        PreviewCamera view = PreviewCamera.of(scene(new NodeGroup("g", Placement.IDENTITY, List.of(), true)));
        Viewport canvas = new Viewport(100, 100);
        Vec3 eye = view.camera().from();
        Vec3 aside = view.right();
        var through = new LightGizmo.Segment(eye.plus(view.forward()).plus(aside), eye.minus(view.forward()).plus(aside));
        LightGizmo.Stroke stroke = GroupBounds.strokes(List.of(through), view, canvas).getFirst();
        assertThat(stroke.from()).isEqualTo(canvas.project(view, through.from()));
        assertThat(stroke.to().x()).isGreaterThan(stroke.from().x());
        assertThat(
                GroupBounds.strokes(List.of(new LightGizmo.Segment(eye.minus(view.forward()), eye.minus(view.forward()).plus(aside))), view,
                        canvas))
                .isEmpty();
    }
}
