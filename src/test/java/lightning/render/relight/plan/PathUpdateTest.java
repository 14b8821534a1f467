package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.sample.IndirectScenes;
import lightning.scene.GatherSettings;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests which paths of indirect light an edit repeats, and that its plan says so. */
class PathUpdateTest {
    private final Scene scene = IndirectScenes.all().get("glass ball");
    private final Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1));

    @BeforeEach
    void renderScene() {
        renderer.render(scene, Progress.NONE);
    }

    @AfterEach
    void close() {
        renderer.close();
    }

    private UpdateResult update(UnaryOperator<Scene> edit) {
        return renderer.render(edit.apply(scene), Progress.NONE);
    }

    private static PathUpdate paths(UpdateResult update) {
        return ((UpdatePlan.Relight) update.plan()).paths();
    }

    private PathUpdate plannedPaths(Scene target) {
        return ((UpdatePlan.Relight) renderer.plan(target).update()).paths();
    }

    /** A background of one color is no environment: the last surfels do not see it. */
    @Test
    void removedEnvironment_needsPathsOfItsOwn() {
        Scene room = IndirectScenes.all().get("environment with a sun");
        GatherSettings paths = GatherSettings.of(room).orElseThrow();
        assertThat(paths.canServe(room.withWorld(room.world().withOwn(own -> own.withGain(0))))).isTrue();
        assertThat(paths.canServe(room.withWorld(room.world().withEnvironment(Optional.empty())))).isFalse();
    }

    private static Scene withMirroringWalls(Scene scene, double reflectance) {
        return scene.withMaterial(scene.material("red").orElseThrow().withReflective(Rgb.gray(reflectance)));
    }

    @Test
    void editedLight_keepsPaths() {
        UpdateResult moved = update(s -> s.withLights(List.of(s.lights().getFirst().withPosition(new Vec3(0, 0.5, 0)))));
        assertThat(paths(moved)).isEqualTo(PathUpdate.KEEP);
        assertThat(moved.plan().steps()).contains("gathered light");
        assertThat(moved.rays().gather()).isZero();
    }

    @Test
    void editedColor_keepsPaths() {
        UpdateResult painted =
                update(s -> s.withMaterials(s.materials().stream().map(m -> m.withDiffuse(new Rgb(0.3, 0.2, 0.1))).toList()));
        assertThat(paths(painted)).isEqualTo(PathUpdate.KEEP);
        assertThat(painted.plan().steps()).contains("gathered light");
        assertThat(painted.rays().gather()).isZero();
    }

    @Test
    void editedBackground_addsNoStep() {
        UpdateResult changed = update(s -> s.withWorld(s.world().withAmbience(0.3)));
        assertThat(changed.plan().steps()).doesNotContain("gathered light");
    }

    @Test
    void deletedObject_repeatsSomePaths() {
        UpdateResult deleted = update(s -> s.withNodes(s.nodes().subList(0, s.nodes().size() - 1)));
        assertThat(paths(deleted)).isEqualTo(PathUpdate.REPEAT);
        assertThat(deleted.plan().steps()).contains("gathered light: changed paths");
        assertThat(deleted.rays().gather()).isPositive();
    }

    @Test
    void otherSettings_buildPaths() {
        UpdateResult sparser =
                update(s -> s.withPicture(s.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT.withSpacing(16)))));
        assertThat(paths(sparser)).isEqualTo(PathUpdate.BUILD);
        assertThat(sparser.plan().steps()).contains("gathered light: all paths");
        assertThat(sparser.rays().gather()).isPositive();
    }

    @Test
    void withoutIndirectLight_thereIsNoPath() {
        UpdateResult direct = update(Scene::withoutIndirect);
        assertThat(paths(direct)).isEqualTo(PathUpdate.NONE);
        assertThat(direct.plan().description()).doesNotContain("indirect");
    }

    @Test
    void newMirror_repeatsPathsAndAnotherReflectance_keepsThem() {
        Scene mirroring = withMirroringWalls(scene, 0.5);
        assertThat(plannedPaths(mirroring)).isEqualTo(PathUpdate.REPEAT);
        renderer.render(mirroring, Progress.NONE);
        assertThat(plannedPaths(withMirroringWalls(scene, 0.6))).isEqualTo(PathUpdate.KEEP);
    }

    @Test
    void otherDepth_repeatsPaths() {
        assertThat(plannedPaths(scene.withPicture(scene.picture().withDepth(3)))).isEqualTo(PathUpdate.REPEAT);
    }

    @Test
    void unchangedScene_keepsPathsIfThereAreAny() {
        assertThat(PathUpdate.unchanged(renderer.cache())).isEqualTo(PathUpdate.KEEP);
        update(Scene::withoutIndirect);
        assertThat(PathUpdate.unchanged(renderer.cache())).isEqualTo(PathUpdate.NONE);
    }
}
