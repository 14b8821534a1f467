package lightning.document.manipulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.document.manipulation.NodeGizmo.Action;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.FilterShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightType;
import lightning.scene.value.Fog;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Handles of flags, filters and fog. */
class PlacedPartTest {
    private static final Viewport CANVAS = new Viewport(640, 480);
    private static final Vec3 FAR = new Vec3(0.5, 1, -0.5);

    private static Scene scene() {
        Scene studio = StudioScene.of(LightType.SPOT);
        Light light = studio.lights().getFirst().withFlag(new LightFlag(true, new Vec3(0.2, 1, 0), new Vec3(10, 0, 0), 0, 2, 0.1, 0.9))
                .withFilter(LightFilter.NONE.withShape(FilterShape.BOX).withPosition(new Vec3(-1, 0, 0)).withSize(new Vec3(1, 2, 3)));
        return studio.withLight(light)
                .withWorld(studio.world().withFog(Fog.NONE.withDensity(0.1).withCenter(new Vec3(0, 0.5, 0)).withSize(new Vec3(3, 2, 1))));
    }

    private static List<PlacedPart> parts(Scene scene) {
        return PlacedPart.of(scene, null, scene.lights().getFirst(), true);
    }

    private static Scene placed(Scene scene, PlacedPart part, Placement v) {
        return part.place(scene, v);
    }

    private static Placement moved(PlacedPart part) {
        return new Placement(FAR, part.placement().rotation(), part.placement().scale());
    }

    @Test
    void lightAndFog_haveThreeParts() {
        assertThat(parts(scene())).hasExactlyElementsOfTypes(PlacedPart.OfFlag.class, PlacedPart.OfFilter.class, PlacedPart.OfFog.class);
        assertThat(PlacedPart.of(scene(), scene().stage().node("ball").orElseThrow(), scene().lights().getFirst(), false))
                .as("a selected object")
                .hasExactlyElementsOfTypes(PlacedPart.OfNode.class);
    }

    /** A width of 0 is none that a placement can have. */
    @Test
    void movedFlag_keepsItsSize() {
        PlacedPart flag = parts(scene()).getFirst();
        LightFlag moved = placed(scene(), flag, moved(flag)).lights().getFirst().flag();
        assertThat(moved).isEqualTo(scene().lights().getFirst().flag().withPosition(FAR));
    }

    @Test
    void scaledFilter_hasTheNewSize() {
        PlacedPart filter = parts(scene()).get(1);
        Placement p = filter.placement();
        LightFilter scaled =
                placed(scene(), filter, new Placement(p.position(), p.rotation(), p.scale().times(2))).lights().getFirst().filter();
        assertThat(scaled.size()).isEqualTo(new Vec3(2, 4, 6));
    }

    @Test
    void fogBox_movesAndIsNotTurned() {
        PlacedPart fog = parts(scene()).getLast();
        assertThat(placed(scene(), fog, moved(fog)).world().fog().center()).isEqualTo(FAR);
        List<NodeGizmo> gizmos = NodeGizmo.of(scene(), List.of(fog), PreviewCamera.of(scene()), CANVAS);
        assertThat(gizmos.getFirst().handles()).extracting(NodeGizmo.Handle::action).contains(Action.MOVE, Action.SCALE)
                .doesNotContain(Action.ROTATE);
    }

    @Test
    void grip_isThatOfTheGizmoUnderThePointer() {
        PreviewCamera view = PreviewCamera.of(scene());
        List<NodeGizmo> gizmos = NodeGizmo.of(scene(), parts(scene()), view, CANVAS);
        for (NodeGizmo gizmo : gizmos) {
            assertThat(NodeGizmo.pick(gizmos, view, CANVAS, CANVAS.project(view, gizmo.origin()), 8).orElseThrow().gizmo())
                    .isEqualTo(gizmo);
        }
    }
}
