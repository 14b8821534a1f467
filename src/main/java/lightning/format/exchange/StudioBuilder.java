package lightning.format.exchange;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.format.exchange.assembly.ImportSubject;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.mesh.UniqueNames;
import lightning.render.trace.Geometry;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Placement;

/**
 * Builds lights and ground around an imported subject, in its size. Keeps the file's camera, or frames the subject; adds no ground to a scene
 * that has a floor.
 */
final class StudioBuilder {
    private static final String CAMERA_BELOW = "the camera is below the ground of the lighting; another was added";
    private static final Rgb STUDIO_BACKGROUND = new Rgb(0.1, 0.11, 0.13);
    private static final Rgb SKY_BACKGROUND = new Rgb(0.4, 0.58, 0.86);
    private static final Rgb GROUND_COLOR = new Rgb(0.36, 0.35, 0.33);
    private static final double COVE_RADIUS = 2.5;
    private static final double COVE_Z = -4;
    private static final int COVE_STRIPS = 24;
    /** Extent of the ground, in units of the studio. */
    private static final double GROUND = 400;
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    /** Share of the distance from the center to a corner at which a floor is looked for. */
    private static final double CORNER = 0.92;
    /** Height of a floor, in radii of the subject above its lowest point. */
    private static final double FLOOR_HEIGHT = 0.1;

    /** Height of a room's light, as a share of the height from the center to the ceiling. */
    private static final double CEILING_HEIGHT = 0.9;
    /** Size of a room's light, as a share of half the room's. */
    private static final double CEILING_SHARE = 0.8;

    private final Scene scene;
    private final ImportSubject subject;
    private final PictureSettings picture;
    private final Camera camera;
    private final SubjectFrame frame;
    private final UniqueNames names = new UniqueNames();
    private final boolean isRoom;
    private final boolean hasFloor;
    private final List<String> notes;

    private StudioBuilder(ImportedScene imported) {
        scene = imported.unscaledScene();
        subject = imported.subject();
        isRoom = ClosedRoom.contains(scene);
        hasFloor = isRoom || findFloor();
        boolean isBelow = subject.hasCamera() && !hasFloor && scene.camera().from().y() <= subject.min().y();
        notes = isBelow ? List.of(CAMERA_BELOW) : List.of();
        boolean hasCamera = subject.hasCamera() && !isBelow;
        PictureSettings smooth =
                scene.picture().sampling().isSupersampled() ? scene.picture() : scene.picture().withSampling(ImportedScene.SMOOTH);
        picture = hasCamera ? smooth : smooth.withSize(WIDTH, HEIGHT);
        camera = hasCamera ? scene.camera() : SubjectFrame.camera(subject, (double) WIDTH / HEIGHT);
        frame = new SubjectFrame(subject, camera);
        scene.stage().nodes().forEach(this::reserveNames);
    }

    static StudioBuilder of(ImportedScene imported) {
        return new StudioBuilder(imported);
    }

    private void reserveNames(SceneNode node) {
        names.unique(node.name(), "");
        if (node instanceof NodeGroup group) {
            group.children().forEach(this::reserveNames);
        }
    }

    /**
     * Returns whether there is something low near at least three corners of the bounding box, and nothing above it: not the inside of a pedestal.
     */
    private boolean findFloor() {
        if (scene.stage().shapeCount() == 0) {
            return false;
        }
        var geometry = Geometry.of(scene.withMaterials(scene.materials().stream()
                .map(Material::withoutImages).toList()));
        Vec3 half = subject.max().minus(subject.center());
        double height = subject.min().y() + FLOOR_HEIGHT * subject.radius();
        long hits = IntStream.range(0, 4).filter(i -> {
            var from = new Vec3(subject.center().x() + CORNER * ((i & 1) == 0 ? half.x() : -half.x()), height,
                    subject.center().z() + CORNER * ((i & 2) == 0 ? half.z() : -half.z()));
            Vec3 origin = geometry.toRenderSpace(from);
            return geometry.nearest(new Ray(origin, new Vec3(0, -1, 0))) >= 0 && geometry.nearest(new Ray(origin, Vec3.Y)) < 0;
        }).count();
        return hits >= 3;
    }

    /** Returns what was replaced besides the lights. */
    List<String> notes() {
        return notes;
    }

    /** Returns the scene in a studio. */
    Scene studio() {
        Light sky = Light.of(names.unique("sky", ""), LightType.DIRECTIONAL).withColor(new Rgb(0.75, 0.86, 1)).withIntensity(0.16)
                .withDirection(frame.direction(0, -1, -0.25));
        List<Light> lights = isRoom ? List.of(ceiling())
                : List.of(softbox("key", 1, 4.6, -4, 3.45, 3.6, 2.2, 2.2).withColor(new Rgb(1, 0.93, 0.84)),
                        softbox("fill", 0.75, 0.6, 5, 1.45, 3.4, 3, 3).withColor(new Rgb(0.82, 0.9, 1)),
                        softbox("rim", 0.75, 3.5, 2.6, 3.05, -3.6, 2.6, 0.7),
                        sky.withArea(sky.area().withSpread(70).withSamples(16)));
        return build(lights, STUDIO_BACKGROUND, new Rgb(0.52, 0.51, 0.5), this::cyclorama);
    }

    /** Returns the scene under a sky. */
    Scene sky() {
        Light sun = Light.of(names.unique("sun", ""), LightType.DIRECTIONAL).withColor(new Rgb(1, 0.94, 0.84)).withIntensity(1.4)
                .withDirection(frame.direction(0.6, -0.85, -0.6));
        Light dome = Light.of(names.unique("sky", ""), LightType.DIRECTIONAL).withColor(new Rgb(0.62, 0.78, 1)).withIntensity(0.8)
                .withDirection(new Vec3(0, -1, 0));
        return build(
                List.of(sun.withArea(sun.area().withSpread(1).withSamples(8)), dome.withArea(dome.area().withSpread(90).withSamples(32))),
                SKY_BACKGROUND, GROUND_COLOR, this::ground);
    }

    /** Returns the scene inside the image of a studio, whose middle is behind the camera. */
    Scene inside(Environment environment) {
        Scene lit = build(List.of(), Rgb.BLACK, GROUND_COLOR, this::ground);
        return lit.withWorld(lit.world().withEnvironment(Optional.of(environment))
                .withOwn(dome -> dome.withRotation(DomeRotation.of(frame.rotation(), 0, 0))));
    }

    private List<SceneNode> ground(String material) {
        return List.of(plane("ground", material, Vec3.ZERO, Vec3.ZERO, new Vec3(GROUND, 1, GROUND)));
    }

    /** Creates a rectangle light that points at the subject's center; position, width and height in units of the studio. */
    private Light softbox(String name, double sampleShare, double intensity, double x, double y, double z, double width, double height) {
        Light light = Light.of(names.unique(name, ""), LightType.RECT).withIntensity(intensity).withPosition(frame.position(x, y, z))
                .withDirection(frame.direction(-x, -y, -z)).withAttenuation(new Attenuation(0.2, 0, frame.quadratic(0.1)));
        return light.withArea(light.area().withWidth(frame.length(width)).withHeight(frame.length(height))
                .withSamples((int) Math.rint(16 * sampleShare)));
    }

    /** Creates a soft light below the ceiling of a room. */
    private Light ceiling() {
        Vec3 half = subject.max().minus(subject.center());
        Light light = Light.of(names.unique("ceiling", ""), LightType.RECT).withIntensity(2)
                .withPosition(frame.rounded(subject.center().plus(new Vec3(0, CEILING_HEIGHT * half.y(), 0))))
                .withDirection(new Vec3(0, -1, 0)).withAttenuation(new Attenuation(0.2, 0, frame.quadratic(0.1)));
        return light.withArea(
                light.area().withWidth(frame.rounded(CEILING_SHARE * half.x())).withHeight(frame.rounded(CEILING_SHARE * half.z()))
                        .withUp(new Vec3(0, 0, 1)));
    }

    private Scene build(List<Light> lights, Rgb background, Rgb paper, Function<String, List<SceneNode>> ground) {
        List<Material> materials = new ArrayList<>(scene.materials());
        List<SceneNode> nodes = new ArrayList<>(scene.stage().nodes());
        if (!hasFloor) {
            var materialNames = new UniqueNames();
            materialNames.unique(Material.DEFAULT.name(), "");
            materials.forEach(m -> materialNames.unique(m.name(), ""));
            String name = materialNames.unique("paper", "");
            materials.add(Material.of(name).withDiffuse(paper).withSpecular(Rgb.BLACK));
            double unit = frame.unit();
            nodes.add(new NodeGroup(names.unique("backdrop", ""),
                    new Placement(frame.foot(), new Vec3(0, frame.rotation(), 0), new Vec3(unit, unit, unit)), ground.apply(name)));
        }
        World world = World.DEFAULT.withAmbience(0).withBackground(background);
        return new Scene(picture, camera, world, new Stage(List.copyOf(materials), List.copyOf(nodes)), LightRig.of(lights, List.of()),
                scene.cameras());
    }

    /** Returns floor and wall with a quarter round between them, as flat strips. */
    private List<SceneNode> cyclorama(String material) {
        List<SceneNode> parts = new ArrayList<>();
        parts.add(plane("floor", material, new Vec3(0, 0, 26), Vec3.ZERO, new Vec3(120, 1, 60)));
        parts.add(plane("wall", material, new Vec3(0, 22.5, COVE_Z - COVE_RADIUS), new Vec3(90, 0, 0), new Vec3(120, 1, 40)));
        double step = 90.0 / COVE_STRIPS;
        double length = 2 * COVE_RADIUS * Math.tan(Math.toRadians(step / 2));
        for (int i = 0; i < COVE_STRIPS; i++) {
            double angle = (i + 0.5) * step;
            double radians = Math.toRadians(angle);
            parts.add(plane("cove " + (i + 1), material,
                    new Vec3(0, rounded(COVE_RADIUS * (1 - Math.cos(radians))), rounded(COVE_Z - COVE_RADIUS * Math.sin(radians))),
                    new Vec3(angle, 0, 0), new Vec3(120, 1, rounded(length))));
        }
        return parts;
    }

    private static double rounded(double v) {
        return Math.rint(v * 1e4) / 1e4;
    }

    private Shape plane(String name, String material, Vec3 position, Vec3 rotation, Vec3 scale) {
        return new Shape(Solid.PLANE, names.unique(name, ""), material, new Placement(position, rotation, scale));
    }
}
