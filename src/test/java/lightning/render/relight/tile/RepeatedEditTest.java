package lightning.render.relight.tile;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.value.Attenuation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests that edits of scenes with many lights, in any order, equal full traces. */
@Slow
class RepeatedEditTest {
    private static final Scene NIGHT = SmallNightScene.SCENE;

    private static Light edited(Light light, Random random) {
        return switch (random.nextInt(8)) {
            case 0 -> light.withColor(new Rgb(random.nextDouble(), random.nextInt(2), random.nextDouble()));
            case 1 -> light.withIntensity(random.nextInt(3) * random.nextDouble());
            case 2 -> light.withOn(!light.on());
            case 3 -> light.withPosition(light.position().plus(new Vec3(random.nextDouble() - 0.5, 0, 0.1)));
            case 4 -> light.withAngle(90 * random.nextDouble());
            case 5 -> light.withAttenuation(new Attenuation(random.nextDouble(), random.nextInt(2), random.nextDouble()));
            case 6 -> light.withDropoff(9 * random.nextDouble());
            default -> light.withDirection(light.direction().plus(new Vec3(0, 0, 0.1 * random.nextDouble())));
        };
    }

    @Property
    void dragOfTwoLightsInTurn_equalsFullTrace(@ForAll Random random, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 7, max = 30) int lights) {
        RenderOptions options = RenderOptions.DEFAULT.withReflections(ReflectionMode.CURRENT).withStorage(storage);
        Scene scene = NIGHT.withLights(NIGHT.lights().subList(0, lights));
        try (Renderer renderer = new Renderer(options); WorkerPool workers = new WorkerPool(2)) {
            renderer.render(scene, Progress.NONE);
            for (int drag = 0; drag < 3; drag++) {
                int light = random.nextInt(lights);
                for (int frame = 0; frame < 4; frame++) {
                    List<Light> all = new ArrayList<>(scene.lights());
                    all.set(light, edited(all.get(light), random));
                    scene = scene.withLights(all);
                    renderer.render(scene, Progress.NONE);
                    FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), "drag");
                }
            }
        }
    }

    private static Scene editedMaterialsOrAmbience(Scene scene, Random random) {
        List<Light> lights = new ArrayList<>(scene.lights());
        Material material = scene.materials().get(random.nextInt(scene.materials().size()));
        switch (random.nextInt(6)) {
            case 0 -> lights.remove(random.nextInt(lights.size()));
            case 1 -> lights.addFirst(lights.removeLast());
            case 2 -> {
                return scene.withMaterial(material.withAlbedo(material.albedo().times(0.5 + 0.5 * random.nextDouble())));
            }
            case 3 -> {
                return scene.withMaterial(material.withShininess(1 + 20 * random.nextDouble()));
            }
            default -> {
                return scene.withWorld(scene.world().withAmbience(random.nextDouble()));
            }
        }
        return scene.withLights(lights);
    }

    @Property
    void editsOfOtherThanLights_equalFullTrace(@ForAll Random random, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 11, max = 30) int lights) {
        Scene scene = NIGHT.withLights(NIGHT.lights().subList(0, lights));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withStorage(storage)); WorkerPool workers = new WorkerPool(2)) {
            renderer.render(scene, Progress.NONE);
            for (int edit = 0; edit < 10; edit++) {
                scene = editedMaterialsOrAmbience(scene, random);
                renderer.render(scene, Progress.NONE);
                FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), "beside");
            }
        }
    }
}
