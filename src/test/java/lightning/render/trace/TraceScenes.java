package lightning.render.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.sample.SampleMeshes;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;

/** Scenes for tracing tests: like those of the paper, and arbitrary ones. */
public final class TraceScenes {
    private final List<SceneNode> nodes = new ArrayList<>();

    private TraceScenes add(Solid solid, Vec3 at, Vec3 rotate, Vec3 scale) {
        String name = "s" + nodes.size();
        String material = Material.DEFAULT.name();
        Placement placement = new Placement(at, rotate, scale);
        nodes.add(new Shape(solid, name, material, placement));
        return this;
    }

    private TraceScenes add(Solid solid, double x, double y, double z, double sx, double sy, double sz) {
        return add(solid, new Vec3(x, y, z), Vec3.ZERO, new Vec3(sx, sy, sz));
    }

    private Scene withCameraAt(double x, double y, double z) {
        Camera camera = new Camera(new Vec3(x, y, z), new Vec3(0, 1, 0), Vec3.Y, 40);
        return new Scene(PictureSettings.DEFAULT, camera, World.DEFAULT, List.of(), nodes, List.of());
    }

    /** Returns a single shape seen from a camera. */
    static PrimitiveTable singleShape(Solid solid, Placement placement, Vec3 camera) {
        return Geometry.of(singleShape(solid, placement, camera, camera.plus(new Vec3(0, 0, -1 - camera.maxAbs())))).primitives();
    }

    /** Returns a ball of radius 1 around (0, 0, −5) on a floor, seen from the origin. */
    public static Scene ballOnFloor() {
        return ballOnFloor(new Vec3(0, 0, -5), 1);
    }

    /** Returns a single shape around (0, 0, −5), its base at a height of −0.5, seen from the origin. */
    public static Scene singleSolid(Solid solid) {
        return singleShape(solid, new Placement(new Vec3(0, -0.5, -5), Vec3.ZERO, Vec3.ONE), Vec3.ZERO, new Vec3(0, 0, -5));
    }

    /** Returns a ball of a radius, and a floor under it, seen from the origin. */
    static Scene ballOnFloor(Vec3 at, double radius) {
        List<SceneNode> nodes = new TraceScenes().add(Solid.SPHERE, at, Vec3.ZERO, Vec3.ONE.times(radius))
                .add(Solid.PLANE, at.minus(new Vec3(0, radius, 0)), Vec3.ZERO, new Vec3(8 * radius, 1, 8 * radius)).nodes;
        return new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, at, Vec3.Y, 40), World.DEFAULT, List.of(), nodes, List.of());
    }

    /** Returns a single shape, seen from a camera that looks at a point. */
    static Scene singleShape(Solid solid, Placement placement, Vec3 from, Vec3 to) {
        return new Scene(PictureSettings.DEFAULT, new Camera(from, to, Vec3.Y, 40), World.DEFAULT, List.of(),
                new TraceScenes().add(solid, placement.position(), placement.rotation(), placement.scale()).nodes, List.of());
    }

    /** Returns a shape over a floor of 12 × 12, seen from a camera. */
    static Scene shapeOverFloor(Solid solid, Placement placement, Vec3 camera) {
        return new TraceScenes().add(solid, placement.position(), placement.rotation(), placement.scale())
                .add(Solid.PLANE, 0, 0, 0, 12, 1, 12)
                .withCameraAt(camera.x(), camera.y(), camera.z());
    }

    /** Returns a single shape in nested groups, the outermost first, seen from a camera. */
    static Scene singleShape(Solid solid, List<Placement> placements, Vec3 camera) {
        Placement local = placements.getLast();
        SceneNode node = new TraceScenes().add(solid, local.position(), local.rotation(), local.scale()).nodes.getFirst();
        for (int g = placements.size() - 2; g >= 0; g--) {
            node = new NodeGroup("g" + g, placements.get(g), List.of(node));
        }
        return new Scene(PictureSettings.DEFAULT, new Camera(camera, camera.plus(new Vec3(0, 0, -1 - camera.maxAbs())), Vec3.Y, 40),
                World.DEFAULT,
                List.of(), List.of(node), List.of());
    }

    /** Returns four spheres over a floor. */
    public static Scene balls() {
        return new TraceScenes()
                .add(Solid.PLANE, 0, 0, 0, 12, 1, 12)
                .add(Solid.SPHERE, 0, 1, 0, 1, 1, 1)
                .add(Solid.SPHERE, -2.2, 0.8, 0.5, 0.8, 0.8, 0.8)
                .add(Solid.SPHERE, 2.1, 0.7, 0.8, 0.7, 0.7, 0.7)
                .add(Solid.SPHERE, 0.6, 0.4, 2, 0.4, 0.4, 0.4)
                .withCameraAt(0, 3, 9);
    }

    /** Returns a bird of four spheres, two cones and four cylinders over a floor. */
    public static Scene bird() {
        return new TraceScenes()
                .add(Solid.SPHERE, 0, 1.6, 0, 0.8, 0.7, 1.1)
                .add(Solid.SPHERE, 0, 2.5, 0.9, 0.5, 0.5, 0.5)
                .add(Solid.SPHERE, -0.2, 2.6, 1.3, 0.1, 0.1, 0.1)
                .add(Solid.SPHERE, 0.2, 2.6, 1.3, 0.1, 0.1, 0.1)
                .add(Solid.CONE, new Vec3(0, 2.45, 1.3), new Vec3(90, 0, 0), new Vec3(0.15, 0.5, 0.15))
                .add(Solid.CONE, new Vec3(0, 1.6, -2), new Vec3(80, 0, 0), new Vec3(0.5, 1.4, 0.2))
                .add(Solid.CYLINDER, new Vec3(-0.3, 0.05, 0.2), Vec3.ZERO, new Vec3(0.08, 1.1, 0.08))
                .add(Solid.CYLINDER, new Vec3(0.3, 0.05, 0.2), Vec3.ZERO, new Vec3(0.08, 1.1, 0.08))
                .add(Solid.CYLINDER, new Vec3(-0.3, 0.05, 0.1), new Vec3(90, 0, 0), new Vec3(0.07, 0.5, 0.05))
                .add(Solid.CYLINDER, new Vec3(0.3, 0.05, 0.1), new Vec3(90, 0, 0), new Vec3(0.07, 0.5, 0.05))
                .add(Solid.PLANE, 0, 0, 0, 10, 1, 10)
                .withCameraAt(4, 3, 7);
    }

    /** Returns a log house: 270 cylinders in four walls. */
    public static Scene house() {
        TraceScenes s = new TraceScenes();
        for (int row = 0; row < 22; row++) {
            for (int wall = 0; wall < 4; wall++) {
                for (int part = 0; part < 3; part++) {
                    double along = -3 + 2 * part;
                    double across = wall % 2 == 0 ? -3 : 3;
                    double y = 0.12 + row * 0.22;
                    s.add(Solid.CYLINDER, wall < 2 ? new Vec3(along, y, across) : new Vec3(across, y + 0.11, along),
                            wall < 2 ? new Vec3(0, 0, -90) : new Vec3(90, 0, 0), new Vec3(0.12, 1.9, 0.12));
                }
            }
        }
        for (int post = 0; post < 6; post++) {
            s.add(Solid.CYLINDER, -3 + 1.2 * post, 0, 4, 0.1, 4, 0.1);
        }
        return s.withCameraAt(9, 5, 12);
    }

    /** Returns small shapes of all kinds, distributed in a cube. */
    public static Scene cloud(int count, long seed) {
        Random random = new Random(seed);
        TraceScenes s = new TraceScenes();
        double size = 3 / Math.cbrt(count);
        for (int i = 0; i < count; i++) {
            s.add(CanonicalSolids.randomSolid(random), vector(random, 4), vector(random, 180),
                    new Vec3(size * (0.2 + random.nextDouble()), size * (0.2 + random.nextDouble()), size * (0.2 + random.nextDouble())));
        }
        return s.withCameraAt(0, 2, 12);
    }

    /** Returns shapes of scales from 10⁻³ to 10⁶, some of them far away, many of them equal. */
    public static Scene randomScene(int count, long seed) {
        Random random = new Random(seed);
        TraceScenes s = new TraceScenes();
        double moved = random.nextBoolean() ? 0 : 1e7 * random.nextDouble();
        for (int i = 0; i < count; i++) {
            Vec3 at = vector(random, Math.pow(10, random.nextInt(6) - 1)).plus(new Vec3(moved, 0, -moved));
            Vec3 rotation = random.nextInt(3) == 0 ? new Vec3(90 * random.nextInt(4), 90 * random.nextInt(4), 0) : vector(random, 180);
            Vec3 scale = new Vec3(scale(random), scale(random), scale(random));
            Solid solid = random.nextInt(5) == 0 ? SampleMeshes.samples().get(random.nextInt(7)) : CanonicalSolids.randomSolid(random);
            for (int copy = random.nextInt(8) == 0 ? 2 : 1; copy > 0; copy--) {
                s.add(solid, at, rotation, scale);
            }
        }
        Vec3 from = vector(random, 10).plus(new Vec3(moved, 0, -moved));
        return new Scene(PictureSettings.DEFAULT, new Camera(from, from.plus(new Vec3(0, 0, -1)), Vec3.Y, 40), World.DEFAULT,
                List.of(), s.nodes, List.of());
    }

    /** Returns equal spheres, all at one position. */
    public static Scene overlappingShapes(int count) {
        TraceScenes s = new TraceScenes();
        for (int i = 0; i < count; i++) {
            s.add(Solid.SPHERE, 0, 1, 0, 1, 1, 1);
        }
        return s.withCameraAt(0, 1, 8);
    }

    /** Returns shapes of all kinds, equal ones and their mirror images, all at one position. */
    public static Scene mixedOverlappingShapes(int count) {
        TraceScenes s = new TraceScenes();
        for (int i = 0; i < count; i++) {
            s.add(CanonicalSolids.ALL.get(i / 2 % CanonicalSolids.ALL.size()), 0, 1, 0, i % 3 == 0 ? -1 : 1, 1, i % 5 == 0 ? -1 : 1);
        }
        return s.withCameraAt(0, 1, 8);
    }

    /** Returns shapes inside shapes that share a cap, a rim, a base or a line of contact; the inner ones first and last. */
    public static Scene nested() {
        TraceScenes s = new TraceScenes();
        for (double scale : new double[] {0.5, 1, 0.25, 1, 0.5}) {
            s.add(Solid.CONE, 0, 0, 0, scale, scale, scale)
                    .add(Solid.CYLINDER, 0, 0, 0, scale, scale, scale)
                    .add(Solid.SPHERE, 0, 0, 0, scale, scale, scale)
                    .add(Solid.PLANE, 0, 0, 0, 2 * scale, scale, 2 * scale);
        }
        return s.withCameraAt(0, 1, 8);
    }

    /** Returns shapes whose boxes are flat, or as thin as allowed: in one plane, on each other and crossing. */
    public static Scene flat() {
        TraceScenes s = new TraceScenes();
        for (int i = 0; i < 4; i++) {
            s.add(Solid.PLANE, 0.25 * i, 1, 0, 1, 1, 1)
                    .add(Solid.PLANE, new Vec3(0, 1, 0.25 * i), new Vec3(90, 0, 0), Vec3.ONE)
                    .add(Solid.PLANE, new Vec3(0, 1, 0), new Vec3(0, 0, 90 * i), Vec3.ONE)
                    .add(Solid.CYLINDER, 0.25 * i, 1, 0, 0.5, 1e-9, 0.5)
                    .add(Solid.SPHERE, 0, 1, 0.25 * i, 0.5, 1e-9, 1)
                    .add(Solid.CONE, 0.25 * i, 1, 0, 1e-9, 1, 1e-9);
        }
        return s.withCameraAt(0, 1, 8);
    }

    /** Returns shapes in rotated groups that stretch one axis and squeeze another increasingly. */
    public static Scene skewedShapes(int count, long seed) {
        Random random = new Random(seed);
        TraceScenes s = new TraceScenes();
        for (int i = 0; i < count; i++) {
            TraceScenes one = new TraceScenes();
            one.add(CanonicalSolids.randomSolid(random), vector(random, 1), vector(random, 180), new Vec3(1, 1, 1));
            SceneNode node = one.nodes.getFirst();
            int levels = random.nextInt(4);
            // Nested scales multiply; the product stays within the limits of a scene, 10⁻⁹ to 10⁹.
            double stretch = Math.scalb(1.0, random.nextInt(1 + 28 / Math.max(1, levels)));
            for (int level = levels; level > 0; level--) {
                Placement turned = new Placement(vector(random, 1), vector(random, 180), new Vec3(stretch, 1, 1 / stretch));
                node = new NodeGroup("g" + i + "_" + level, turned, List.of(node));
            }
            s.nodes.add(new NodeGroup("g" + i, Placement.IDENTITY, List.of(rename(node, i))));
        }
        return s.withCameraAt(0, 2, 12);
    }

    private static SceneNode rename(SceneNode node, int i) {
        return switch (node) {
            case NodeGroup g -> new NodeGroup(g.name(), g.placement(), List.of(rename(g.children().getFirst(), i)));
            case Shape x -> x.withName("s" + i);
        };
    }

    private static double scale(Random random) {
        double s = random.nextInt(3) == 0 ? Math.pow(10, random.nextInt(10) - 3) : 0.1 + 3 * random.nextDouble();
        return random.nextInt(4) == 0 ? -s : s;
    }

    private static Vec3 vector(Random random, double extent) {
        return new Vec3((random.nextDouble() - 0.5) * 2 * extent, (random.nextDouble() - 0.5) * 2 * extent,
                (random.nextDouble() - 0.5) * 2 * extent);
    }
}
