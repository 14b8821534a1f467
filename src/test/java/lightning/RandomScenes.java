package lightning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
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
import lightning.scene.Texture;
import lightning.scene.TextureMap;
import lightning.scene.World;

/** Scenes drawn from a seed: a floor, shapes of every kind over it, lights of every type above. */
public final class RandomScenes {
    private final Random random;

    public RandomScenes(long seed) {
        random = new Random(seed);
    }

    public Scene scene(int width, int height, int shapes, int lights) {
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            materials.add(material("m" + i, i));
        }
        List<Node> nodes = new ArrayList<>();
        nodes.add(new Shape.Plane("floor", "m0", new Placement(new Vec3(0, -1, 0), Vec3.ZERO, new Vec3(14, 1, 14))));
        for (int i = 0; i < shapes; i++) {
            nodes.add(shape("s" + i, "m" + random.nextInt(4)));
        }
        List<Light> all = new ArrayList<>();
        for (int i = 0; i < lights; i++) {
            all.add(light("l" + i));
        }
        return new Scene(new Picture(width, height, random.nextInt(5)),
                new Camera(new Vec3(random.nextDouble() - 0.5, 2, 7), Vec3.ZERO, Vec3.Y, 40),
                new World(random.nextDouble(), new Rgb(0.1, 0.2, 0.3)), materials, nodes, all);
    }

    public Material material(String name, int kind) {
        boolean mirror = kind % 2 == 0;
        Optional<TextureMap> texture = kind == 3
                ? Optional.of(new TextureMap("t.png", 2, 3, texture()))
                : Optional.empty();
        return new Material(name, Rgb.grey(0.1), new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble()),
                kind == 1 ? Rgb.BLACK : Rgb.grey(random.nextDouble()), random.nextInt(60) + (kind == 2 ? 0.5 : 0),
                mirror ? new Rgb(0.5, random.nextDouble(), 0.2) : Rgb.BLACK, texture);
    }

    private Texture texture() {
        float[] rgb = new float[3 * 4 * 5];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextFloat();
        }
        return new Texture(4, 5, rgb);
    }

    public Shape shape(String name, String material) {
        Placement placement = new Placement(
                new Vec3(4 * random.nextDouble() - 2, 2 * random.nextDouble() - 1, 4 * random.nextDouble() - 2),
                new Vec3(360 * random.nextDouble(), 360 * random.nextDouble(), 90 * random.nextInt(4)),
                new Vec3(0.3 + random.nextDouble(), 0.3 + random.nextDouble(), 0.3 + random.nextDouble()));
        return switch (random.nextInt(4)) {
            case 0 -> new Shape.Sphere(name, material, placement);
            case 1 -> new Shape.Cone(name, material, placement);
            case 2 -> new Shape.Cylinder(name, material, placement);
            default -> new Shape.Plane(name, material, placement);
        };
    }

    public Light light(String name) {
        Vec3 position = position();
        return new Light(name, LightType.values()[random.nextInt(3)],
                new Rgb(random.nextDouble(), random.nextDouble(), random.nextDouble()), random.nextDouble() * 3,
                position, direction(position), attenuation(), 10 + 50 * random.nextDouble(), random.nextInt(9) / 2.0,
                random.nextInt(10) > 0, random.nextInt(20) == 0);
    }

    public Vec3 position() {
        return new Vec3(8 * random.nextDouble() - 4, 1 + 4 * random.nextDouble(), 8 * random.nextDouble() - 4);
    }

    public Vec3 direction(Vec3 from) {
        return from.negated().plus(new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble()));
    }

    public Attenuation attenuation() {
        return random.nextInt(3) == 0 ? Attenuation.NONE
                : new Attenuation(random.nextDouble(), random.nextDouble(), random.nextDouble() / 4);
    }

    public Random random() {
        return random;
    }
}
