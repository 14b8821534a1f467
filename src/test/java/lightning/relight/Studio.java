package lightning.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Attenuation;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.World;
import lightning.shading.Progress;
import lightning.shading.SeenRows;

/** A ball and a mirror over a mirroring floor, one light, and a renderer whose work is counted. */
final class Studio implements AutoCloseable {
    static final String KEY = "key";
    private final Renderer renderer;
    private Scene scene;

    Studio(Reflections reflections, MirrorStorage storage, Scene scene) {
        this.scene = scene;
        renderer = new Renderer(new Options(Accuracy.EXACT, reflections, storage, 1));
        renderer.render(scene, Progress.NONE);
    }

    /** One tile, reflections stale, a light of the given type. */
    static Studio of(LightType type) {
        return new Studio(Reflections.STALE, MirrorStorage.FULL_ROWS, scene(type));
    }

    static Scene scene(LightType type) {
        return new Scene(new Picture(30, 24, 2), new Camera(new Vec3(0, 2, 7), Vec3.ZERO, Vec3.Y, 40), World.DEFAULT,
                List.of(material("matt", Rgb.BLACK), material("glass", Rgb.grey(0.5))), nodes(), List.of(key(type)));
    }

    /** A light with rows of every state: lit and shadowed ones, and a spot's outside its cone. */
    static Light key(LightType type) {
        return Light.of(KEY, type).withPosition(new Vec3(2, 4, 2)).withDirection(new Vec3(-2, -4.5, -2.2))
                .withAttenuation(new Attenuation(0.1, 0.2, 0.01)).withAngle(20).withDropoff(2);
    }

    private static Material material(String name, Rgb reflective) {
        return new Material(name, Rgb.grey(0.1), Rgb.grey(0.7), Rgb.grey(0.2), 8, reflective, Optional.empty());
    }

    private static List<Node> nodes() {
        return List.of(new Shape.Plane("floor", "glass", placement(new Vec3(0, -1, 0), new Vec3(9, 1, 9))),
                new Shape.Sphere("ball", "matt", placement(Vec3.ZERO, Vec3.ONE)),
                new Shape.Sphere("mirror", "glass", placement(new Vec3(-2, 0, -1), Vec3.ONE)));
    }

    private static Placement placement(Vec3 at, Vec3 scale) {
        return new Placement(at, Vec3.ZERO, scale);
    }

    Scene scene() {
        return scene;
    }

    Light key() {
        return scene.light(KEY).orElseThrow();
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
