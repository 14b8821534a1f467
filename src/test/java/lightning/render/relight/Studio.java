package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import lightning.base.work.Progress;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.shading.SeenRows;
import lightning.sample.StudioScene;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/** The studio's scene and a renderer whose work is counted. */
final class Studio implements AutoCloseable {
    private final Renderer renderer;
    private Scene scene;

    Studio(Reflections reflections, MirrorStorage storage, Scene scene) {
        this.scene = scene;
        renderer = new Renderer(new Options(Accuracy.EXACT, reflections, storage, 1));
        renderer.render(scene, Progress.NONE);
    }

    /** One tile, reflections stale, a light of the given type. */
    static Studio of(LightType type) {
        return new Studio(Reflections.STALE, MirrorStorage.FULL_ROWS, StudioScene.of(type));
    }

    Scene scene() {
        return scene;
    }

    Light key() {
        return scene.light(StudioScene.KEY).orElseThrow();
    }

    Renderer renderer() {
        return renderer;
    }

    /** What can be seen of the scene as it is now. */
    SeenRows seen() {
        return new SeenRows(scene);
    }

    /** Renders another scene. */
    Update render(Scene wanted) {
        scene = wanted;
        return renderer.render(wanted, Progress.NONE);
    }

    /** Renders the scene with its light edited. */
    Update edit(UnaryOperator<Light> edit) {
        return render(scene.withLight(edit.apply(key())));
    }

    Update lights(Function<List<Light>, List<Light>> edit) {
        return render(scene.withLights(edit.apply(scene.lights())));
    }

    Update depth(int depth) {
        return render(scene.withPicture(scene.picture().withDepth(depth)));
    }

    /** The plan for the first level's layers, in the order of the lights. */
    static List<LightUpdate> layers(Update update) {
        return ((UpdatePlan.Relight) update.plan()).top().layers().stream().map(LayerPlan::update).toList();
    }

    /** Asserts all counts of an update. */
    static void assertWork(Update update, long rowsTouched, long rowsComposed, long mirroredRays, long shadowRays) {
        assertThat(update.rowsTouched()).as("rows touched: " + update.plan().text()).isEqualTo(rowsTouched);
        assertThat(update.rowsComposed()).as("rows composed: " + update.plan().text()).isEqualTo(rowsComposed);
        assertThat(update.rays().eye()).as("eye rays").isZero();
        assertThat(update.rays().mirrored()).as("mirrored rays: " + update.plan().text()).isEqualTo(mirroredRays);
        assertThat(update.rays().shadow()).as("shadow rays: " + update.plan().text()).isEqualTo(shadowRays);
    }

    @Override
    public void close() {
        renderer.close();
    }
}
