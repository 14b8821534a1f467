package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.ReferenceRows;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;

/** Studio scene with a renderer whose work is counted. */
final class StudioRenderer implements AutoCloseable {
    private final Renderer renderer;
    private Scene scene;

    StudioRenderer(ReflectionMode reflections, MirrorStorage storage, Scene scene) {
        this.scene = scene;
        renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, storage, 1));
        renderer.render(scene, Progress.NONE);
    }

    /** Creates a renderer with one tile, stale reflections and a light of the given type. */
    static StudioRenderer of(LightType type) {
        return new StudioRenderer(ReflectionMode.STALE, MirrorStorage.FULL_ROWS, StudioScene.of(type));
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

    /** Returns the visible rows of the current scene. */
    ReferenceRows referenceRows() {
        return new ReferenceRows(scene);
    }

    /** Renders another scene. */
    UpdateResult render(Scene target) {
        scene = target;
        return renderer.render(target, Progress.NONE);
    }

    /** Dims the light, so that stale mirrors show an earlier scene: what they show is then a film of its own, which later edits keep. */
    StudioRenderer withOutdatedMirrors() {
        edit(light -> light.withIntensity(0.9 * light.intensity()));
        return this;
    }

    /** Renders the scene after an edit of its light. */
    UpdateResult edit(UnaryOperator<Light> edit) {
        return render(scene.withLight(edit.apply(key())));
    }

    UpdateResult lights(Function<List<Light>, List<Light>> edit) {
        return render(scene.withLights(edit.apply(scene.lights())));
    }

    UpdateResult depth(int depth) {
        return render(scene.withPicture(scene.picture().withDepth(depth)));
    }

    /** Returns the plan for the first level's layers, in the order of the lights. */
    static List<LightUpdate> layers(UpdateResult update) {
        return ((UpdatePlan.Relight) update.plan()).top().layers().stream().map(LayerPlan::update).toList();
    }

    /** Asserts all counts of an update. */
    static void assertWork(UpdateResult update, long rowsTouched, long rowsComposed, long mirroredRays, long shadowRays) {
        assertThat(update.rowsTouched()).as("rows touched: " + update.plan().description()).isEqualTo(rowsTouched);
        assertThat(update.rowsComposed()).as("rows composed: " + update.plan().description()).isEqualTo(rowsComposed);
        assertThat(update.rays().eye()).as("eye rays").isZero();
        assertThat(update.rays().mirrored()).as("mirrored rays: " + update.plan().description()).isEqualTo(mirroredRays);
        assertThat(update.rays().shadow()).as("shadow rays: " + update.plan().description()).isEqualTo(shadowRays);
    }

    @Override
    public void close() {
        renderer.close();
    }
}
