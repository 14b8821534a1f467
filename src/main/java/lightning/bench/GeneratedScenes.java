package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;

/**
 * Generator of scenes with any number of shapes and lights, for growth curves: balls in a block above a floor, every second one reflective,
 * with lights of all types. Deterministic in the seed.
 */
final class GeneratedScenes {
    private static final Camera CAMERA = new Camera(new Vec3(0, 3, 9), new Vec3(0, 1.5, 0), Vec3.Y, 40);
    /** Size of the block of balls, in scene units. */
    private static final double WIDTH = 6;
    private static final double HEIGHT = 3;

    private GeneratedScenes() {}

    /**
     * @param shapes number of shapes including the floor, ≥ 1
     * @param lights number of lights, ≥ 1, alternating point, directional and spot
     * @param depth  maximum reflection depth
     */
    static Scene of(long seed, PictureSize size, int shapes, int lights, int depth) {
        Random random = new Random(seed);
        List<SceneNode> nodes = new ArrayList<>();
        nodes.add(new Shape(Solid.PLANE, "floor", "matt", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(20, 1, 20))));
        // With this radius, any number of balls fills a tenth of the block.
        double radius = Math.cbrt(0.1 * WIDTH * WIDTH * HEIGHT / (Math.max(shapes - 1, 1) * 4 / 3.0 * Math.PI));
        for (int i = 1; i < shapes; i++) {
            Vec3 at = new Vec3(WIDTH * (random.nextDouble() - 0.5), radius + HEIGHT * random.nextDouble(),
                    WIDTH * (random.nextDouble() - 0.5));
            nodes.add(new Shape(Solid.SPHERE, "ball" + i, i % 2 == 0 ? "mirror" : "matt",
                    new Placement(at, Vec3.ZERO, Vec3.ONE.times(radius))));
        }
        List<Light> lightList = new ArrayList<>();
        for (int i = 0; i < lights; i++) {
            lightList.add(light(i, lights, random));
        }
        return new Scene(new PictureSettings(size.width(), size.height(), depth), CAMERA, World.DEFAULT,
                List.of(material("matt", Rgb.BLACK), material("mirror", Rgb.gray(0.5))), nodes, lightList);
    }

    private static Light light(int i, int lights, Random random) {
        LightType type = List.of(LightType.POINT, LightType.DIRECTIONAL, LightType.SPOT).get(i % 3);
        Vec3 at = new Vec3(10 * (random.nextDouble() - 0.5), 4 + 4 * random.nextDouble(), 10 * (random.nextDouble() - 0.3));
        return Light.of("light" + i, type).withIntensity(2.0 / lights).withPosition(at).withDirection(new Vec3(0, 1, 0).minus(at))
                .withAttenuation(new Attenuation(0.5, 0.05, 0.01)).withDropoff(2);
    }

    private static Material material(String name, Rgb reflective) {
        return Material.of(name).withAmbient(Rgb.gray(0.1)).withDiffuse(Rgb.gray(0.7)).withSpecular(Rgb.gray(0.2))
                .withReflective(reflective);
    }
}
