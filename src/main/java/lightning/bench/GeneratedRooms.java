package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.bench.mesh.BumpySphere;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
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
 * Generator of closed rooms with indirect light: six walls, two of them colored, with any number of balls and lights, or a mesh. The camera
 * is inside. Deterministic in the seed.
 */
record GeneratedRooms(PictureSize size, IndirectSettings settings, Random random) {
    private static final Camera CAMERA = new Camera(new Vec3(0, 0, 3.6), new Vec3(0, -0.1, 0), Vec3.Y, 40);
    private static final String WHITE = "white";
    private static final String RED = "red";
    private static final String GREEN = "green";

    GeneratedRooms(long seed, PictureSize size, IndirectSettings settings) {
        this(size, settings, new Random(seed));
    }

    /**
     * Returns a room with balls.
     *
     * @param balls  number of balls, ≥ 1
     * @param lights number of point lights, ≥ 1
     */
    Scene withBalls(int balls, int lights) {
        List<SceneNode> nodes = walls();
        // With this radius, any number of balls fills a fifth of a block of 1.6 × 1 × 1.6.
        double radius = Math.cbrt(0.2 * 1.6 * 1.6 / (balls * 4 / 3.0 * Math.PI));
        for (int i = 0; i < balls; i++) {
            Vec3 at = new Vec3(1.6 * (random.nextDouble() - 0.5), radius - 1 + random.nextDouble() * (1 - radius),
                    1.6 * (random.nextDouble() - 0.5));
            nodes.add(new Shape(Solid.SPHERE, "ball" + i, i % 3 == 0 ? RED : WHITE,
                    new Placement(at, Vec3.ZERO, Vec3.ONE.times(radius))));
        }
        return scene(nodes, lights);
    }

    /**
     * Returns a room with one mesh and one light.
     *
     * @param triangles approximate number of triangles, ≥ 12
     */
    Scene withMesh(int triangles) {
        List<SceneNode> nodes = walls();
        nodes.add(new Shape(new Solid.TriangleMesh("ball.ply", "", BumpySphere.of(triangles)), "ball", WHITE,
                new Placement(new Vec3(0, -0.4, 0), Vec3.ZERO, Vec3.ONE.times(0.5))));
        return scene(nodes, 1);
    }

    private static List<SceneNode> walls() {
        List<SceneNode> nodes = new ArrayList<>();
        nodes.add(wall("floor", WHITE, new Vec3(0, -1, 1.5), Vec3.ZERO, new Vec3(2, 1, 5)));
        nodes.add(wall("ceiling", WHITE, new Vec3(0, 1, 1.5), Vec3.ZERO, new Vec3(2, 1, 5)));
        nodes.add(wall("back", WHITE, new Vec3(0, 0, -1), new Vec3(90, 0, 0), new Vec3(2, 1, 2)));
        nodes.add(wall("front", WHITE, new Vec3(0, 0, 4), new Vec3(90, 0, 0), new Vec3(2, 1, 2)));
        nodes.add(wall("left", RED, new Vec3(-1, 0, 1.5), new Vec3(0, 0, 90), new Vec3(2, 1, 5)));
        nodes.add(wall("right", GREEN, new Vec3(1, 0, 1.5), new Vec3(0, 0, 90), new Vec3(2, 1, 5)));
        return nodes;
    }

    private static Shape wall(String name, String material, Vec3 at, Vec3 rotation, Vec3 scale) {
        return new Shape(Solid.PLANE, name, material, new Placement(at, rotation, scale));
    }

    private Scene scene(List<SceneNode> nodes, int lights) {
        List<Light> lightList = new ArrayList<>();
        for (int i = 0; i < lights; i++) {
            Vec3 at = i == 0 ? new Vec3(0.2, 0.8, 0.3)
                    : new Vec3(1.6 * (random.nextDouble() - 0.5), 0.5 + 0.4 * random.nextDouble(), 1.6 * (random.nextDouble() - 0.5));
            lightList.add(Light.of("light" + i, LightType.POINT).withIntensity(1.0 / lights).withPosition(at)
                    .withAttenuation(new Attenuation(0.5, 0, 0.2)));
        }
        PictureSettings picture = new PictureSettings(size.width(), size.height(), 0).withIndirect(Optional.of(settings));
        return new Scene(picture, CAMERA, World.DEFAULT.withAmbience(0), List.of(diffuse(WHITE, Rgb.gray(0.75)),
                diffuse(RED, new Rgb(0.7, 0.15, 0.1)), diffuse(GREEN, new Rgb(0.15, 0.6, 0.15))), nodes, lightList);
    }

    private static Material diffuse(String name, Rgb color) {
        return Material.of(name).withAmbient(Rgb.BLACK).withDiffuse(color);
    }
}
