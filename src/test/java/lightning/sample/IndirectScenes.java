package lightning.sample;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PlacedShape;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.BumpMapping;
import lightning.scene.node.Mesh;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;

/** Small scenes with indirect light by name: one for each kind of surface and light that its paths meet. */
public final class IndirectScenes {
    /** Room without a front wall, from −1 to 1; the side walls are red and green. */
    private static final String ROOM = """
            material white { diffuse 0.8 0.8 0.8 }
            material red { diffuse 0.8 0.1 0.1 }
            material green { diffuse 0.1 0.7 0.1 }
            material blue { diffuse 0.2 0.2 0.9 }
            material mirror { diffuse 0.1 0.1 0.1  reflective 0.8 0.8 0.8  specular 0.5 0.5 0.5 }
            material glass { diffuse 0.1 0.1 0.1  clear 0.8 0.9 1  ior 1.5  tint 0.6 0.9 0.9  tint_distance 0.5 }
            plane floor { material white  at 0 -1 0  scale 2 1 2 }
            plane ceiling { material white  at 0 1 0  scale 2 1 2 }
            plane back { material white  at 0 0 -1  rotate 90 0 0  scale 2 1 2 }
            plane left { material red  at -1 0 0  rotate 0 0 90  scale 2 1 2 }
            plane right { material green  at 1 0 0  rotate 0 0 90  scale 2 1 2 }
            """;
    private static final String PRINCIPLED = """
            material brass { model principled  base 0.9 0.7 0.3  metalness 1  roughness 0.3 }
            material plastic { model principled  base 0.4 0.2 0.1  roughness 0.4 }
            material lacquer { model principled  base 0.5 0.1 0.1  metalness 0.5  roughness 0.5  coat 1  coat_roughness 0.15 }
            material neon { diffuse 0.1 0.1 0.1  glow 3 2 1 }
            """;
    private static final TextureMap CHECKERS =
            new TextureMap("checkers.png", 3, 2,
                    new Texture(2, 2, new float[] {1, 1, 1, 0.2f, 0.3f, 0.1f, 0.1f, 0.4f, 0.6f, 0.9f, 0.8f, 1}));
    private static final String CAMERA = "camera { from 0 0 4  to 0 0 0 }\n";
    private static final String LAMP = "light lamp point { at 0.2 0.8 0.3  color 0.7 0.6 0.5  attenuation 0.5 0 0.2 }\n";

    private IndirectScenes() {}

    /** Returns all scenes by name. */
    public static Map<String, Scene> all() {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        scenes.put("room", scene("size 32 24  depth 2", CAMERA + ROOM + LAMP, new IndirectSettings(2, 16, 4, false)));
        scenes.put("mirror ball", scene("size 40 24  depth 3", CAMERA + ROOM + LAMP + """
                sphere ball { material mirror  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                sphere other { material mirror  at -0.5 -0.6 0.3  scale 0.3 0.3 0.3 }
                """, new IndirectSettings(2, 16, 4, false)));
        scenes.put("two mirrors", scene("size 40 24  depth 2", CAMERA + ROOM + LAMP + """
                material dark_mirror { diffuse 0.1 0 0  reflective 0.5 0.5 0.5 }
                sphere ball { material mirror  at 0.45 -0.5 -0.2  scale 0.5 0.5 0.5 }
                sphere other { material dark_mirror  at -0.45 -0.5 -0.2  scale 0.5 0.5 0.5 }
                """, new IndirectSettings(2, 16, 4, false)));
        scenes.put("frosted glass", scene("size 33 24  depth 3", CAMERA + ROOM + LAMP
                + """
                        material frosted { model principled  base 0.3 0.2 0.1  clear 0.7 0.9 0.8  ior 1.5  tint 0.6 0.9 0.9  tint_distance 0.5  roughness 0.3 }
                        material sheet { model principled  base 0.3 0.2 0.1  clear 0.7 0.9 0.8  thin yes  roughness 0.5  coat 0.5  coat_roughness 0 }
                        sphere ball { material frosted  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                        plane pane { material sheet  at -0.4 0 0.3  rotate 90 30 0  scale 0.3 1 0.5 }
                        sphere bulb { material bright  at 0.3 0.1 -0.6  scale 0.1 0.1 0.1 }
                        material bright { glow 4 3 2 }
                        """,
                new IndirectSettings(2, 16, 4, false)));
        scenes.put("frosted glass before a softbox", scene("size 33 24  depth 3", CAMERA + PRINCIPLED + ROOM
                + """
                        material frosted { model principled  base 0.3 0.2 0.1  clear 0.7 0.9 0.8  ior 1.5  roughness 0.3 }
                        material sheet { model principled  base 0.3 0.2 0.1  clear 0.7 0.9 0.8  thin yes  roughness 0.5 }
                        sphere ball { material frosted  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                        plane pane { material sheet  at -0.4 0 0.3  rotate 90 30 0  scale 0.3 1 0.5 }
                        sphere vase { material brass  at -0.5 -0.6 0.2  scale 0.4 0.4 0.4 }
                        light panel rect { at 0 0.4 -0.7  direction 0 -0.4 1  width 0.8  height 0.6  samples 4  visible yes }
                        light bulb point { at -0.6 0.2 -0.5  radius 0.2  samples 4  visible yes  intensity 0.3 }
                        """, new IndirectSettings(2, 16, 4, false)));
        scenes.put("velvet",
                scene("size 32 24  depth 2",
                        CAMERA + PRINCIPLED + ROOM + LAMP
                                + """
                                        material velvet { model principled  base 0.2 0.02 0.05  roughness 0.9  sheen 0.8 0.3 0.4 }
                                        material dusty { model principled  base 0.9 0.7 0.3  metalness 1  roughness 0.05  coat 0.5  coat_roughness 0.4  sheen 0.3 0.4 0.2  sheen_roughness 0.8 }
                                        sphere ball { material velvet  at 0.4 -0.5 -0.2  scale 0.5 0.5 0.5 }
                                        sphere vase { material dusty  at -0.5 -0.6 0.2  scale 0.4 0.4 0.4 }
                                        sphere bulb { material neon  at -0.1 0.2 0.4  scale 0.1 0.1 0.1 }
                                        """,
                        new IndirectSettings(2, 16, 4, false)));
        scenes.put("brushed metal",
                scene("size 32 24  depth 2",
                        CAMERA + PRINCIPLED + ROOM + LAMP
                                + """
                                        material brushed { model principled  base 0.9 0.7 0.3  metalness 1  roughness 0.3  anisotropy 0.8  anisotropy_rotation 20 }
                                        material grooved { model principled  base 0.1 0.2 0.8  roughness 0.5  anisotropy 1  coat 0.5  coat_roughness 0.2  sheen 0.2 0.2 0.2 }
                                        sphere ball { material brushed  at 0.4 -0.5 -0.2  scale 0.5 0.4 0.5  rotate 20 0 30 }
                                        cylinder can { material grooved  at -0.5 -0.9 0.2  scale 0.4 0.6 0.4 }
                                        sphere bulb { material neon  at -0.1 0.2 0.4  scale 0.1 0.1 0.1 }
                                        """,
                        new IndirectSettings(2, 16, 4, false)));
        scenes.put("glass ball", scene("size 33 24  depth 4", CAMERA + ROOM + LAMP + """
                sphere ball { material glass  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                plane pane { material glass  at -0.4 0 0.3  rotate 90 30 0  scale 0.3 1 0.5 }
                """, new IndirectSettings(3, 16, 3, true)));
        scenes.put("panes that reflect", scene("size 24 18  depth 2", CAMERA + ROOM + LAMP + """
                material mirrored { diffuse 0.1 0.1 0.1  clear 0.9 1 0.8  ior 1.8  reflective 0.5 0.2 0  thin yes }
                plane pane { material mirrored  at 0 0.2 0.5  rotate 80 10 0  scale 1.5 1 1.5 }
                plane other { material glass  at 0.3 0.1 0.6  rotate 90 30 20  scale 0.8 1 0.8 }
                """, new IndirectSettings(2, 16, 3, true)));
        scenes.put("visible lights", withMesh(scene("size 24 18  depth 2", CAMERA + ROOM + """
                light panel rect { at 0 0.5 0  direction 0 -1 0.2  width 0.8  height 0.6  samples 4  visible yes }
                light bulb point { at 0.4 -0.5 0.2  radius 0.2  samples 4  visible yes  intensity 0 }
                plane pane { material glass  at -0.4 0 0.3  rotate 90 30 0  scale 0.6 1 0.8 }
                sphere ball { material blue  at -0.4 -0.6 -0.2  scale 0.3 0.3 0.3 }
                """, new IndirectSettings(2, 16, 4, true))));
        scenes.put("area light", scene("size 24 24  depth 1  antialias edges  samples 2", CAMERA + ROOM + """
                cylinder block { material blue  at -0.3 -1 -0.3  scale 0.3 0.8 0.3 }
                light panel rect { at 0 0.95 0  direction 0 -1 0  width 0.6  height 0.4  samples 8 }
                """, new IndirectSettings(1, 16, 8, false)));
        scenes.put("mesh", withMesh(scene("size 32 20  depth 1  antialias every  samples 2", CAMERA + ROOM + LAMP + """
                sphere ball { material blue  at 0.2 -0.4 -0.2  rotate 10 20 30  scale 0.4 0.4 0.4 }
                """, new IndirectSettings(2, 16, 5, false))));
        scenes.put("textures", withTextures(scene("size 32 24  depth 2", CAMERA + ROOM + LAMP, new IndirectSettings(3, 16, 4, false))));
        scenes.put("two rooms with a thin wall", scene("size 40 20  depth 0", CAMERA + ROOM + """
                plane wall { material white  at 0 0 0  rotate 0 0 90  scale 2 1 2 }
                light lamp point { at 0.6 0.5 0 }
                """, new IndirectSettings(3, 16, 4, false)));
        scenes.put("rough metal and lacquer",
                scene("size 32 24  depth 2  antialias edges  samples 2", CAMERA + PRINCIPLED + ROOM + LAMP + """
                        sphere ball { material brass  at 0.3 -0.5 -0.2  scale 0.5 0.5 0.5 }
                        sphere other { material lacquer  at -0.5 -0.6 0.2  scale 0.4 0.4 0.4 }
                        plane table { material plastic  at 0 -0.98 0  scale 1.5 1 1.5 }
                        sphere bulb { material neon  at 0 0.5 0.2  scale 0.08 0.08 0.08 }
                        sphere glass { material glass  at 0.3 0.1 0.5  scale 0.2 0.2 0.2 }
                        """, new IndirectSettings(2, 16, 4, false)));
        scenes.put("rough metal without indirect light", scene("size 32 24  depth 2", CAMERA + PRINCIPLED + ROOM + """
                sphere ball { material brass  at 0.3 -0.5 -0.2  scale 0.5 0.5 0.5 }
                sphere mirror { material mirror  at -0.5 -0.6 0.2  scale 0.4 0.4 0.4 }
                light panel rect { at 0 0.9 0  direction 0 -1 0  width 0.6  height 0.4  samples 4 }
                """, new IndirectSettings(2, 16, 4, false)).withoutIndirect());
        scenes.put("rough metal below an environment", withEnvironment(scene("size 24 16  depth 1", CAMERA + PRINCIPLED + """
                world { ambience 0  rotation 30 }
                sphere ball { material brass  at 0.3 -0.5 -0.2  scale 0.5 0.5 0.5 }
                plane table { material plastic  at 0 -1 0  scale 3 1 3 }
                """, new IndirectSettings(2, 16, 4, false)).withoutIndirect()));
        scenes.put("sky", scene("size 24 16  depth 1", CAMERA + "world { background 0.4 0.6 1 }\n" + ROOM,
                new IndirectSettings(2, 64, 2, true)));
        scenes.put("environment with a sun", withEnvironment(scene("size 32 20  depth 2", CAMERA + """
                world { ambience 0  rotation 30 }
                """ + ROOM + """
                sphere ball { material white  at 0.3 -0.6 0.2  scale 0.4 0.4 0.4 }
                sphere glass { material glass  at -0.4 -0.6 0.4  scale 0.3 0.3 0.3 }
                light panel rect { at 0 0.9 0  direction 0 -1 0  width 0.6  height 0.4  samples 4 }
                """, new IndirectSettings(2, 16, 4, false))));
        scenes.put("environment through an opening", withEnvironment(scene("size 32 20  depth 1", """
                camera { from 0 0.3 0.9  to 0 -0.3 -1  fov 80 }
                world { ambience 0 }
                """ + ROOM + """
                plane front { material white  at 0 -0.1 1  rotate 90 0 0  scale 2 1 1.8 }
                plane beside { material white  at 0.2 0.9 1  rotate 90 0 0  scale 1.6 1 0.2 }
                plane pane { material glass  at -0.8 0.9 1.1  rotate 90 0 0  scale 0.2 1 1 }
                sphere ball { material blue  at 0.3 -0.6 -0.2  scale 0.4 0.4 0.4 }
                """, new IndirectSettings(2, 64, 4, false))));
        scenes.put("environment on bumps", withBumps(withEnvironment(scene("size 24 16  depth 1", CAMERA + ROOM + """
                material mirrored { diffuse 0.3 0.3 0.3  reflective 0.5 0.5 0.5 }
                sphere ball { material mirrored  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                """, new IndirectSettings(1, 16, 4, true)))));
        scenes.put("empty", scene("size 16 16  depth 3", "light lamp point { at 0 1 0 }\nworld { background 0.1 0.2 0.3 }\n",
                new IndirectSettings(2, 16, 8, true)));
        scenes.put("single pixel", scene("size 1 1  depth 2", CAMERA + ROOM + LAMP, new IndirectSettings(2, 16, 64, false)));
        scenes.put("camera inside a sphere", scene("size 20 16  depth 1", """
                camera { from 0.3 0.2 0.5  to 0 0 -1  fov 80 }
                material shell { diffuse 0.6 0.7 0.8 }
                sphere around { material shell  scale 2 2 2 }
                sphere ball { material shell  at 0 0 -1  scale 0.4 0.4 0.4 }
                light lamp spot { at 0.5 1 0.5  direction 0 -1 -1  angle 40 }
                """, new IndirectSettings(3, 16, 4, false)));
        scenes.put("bumps", withBumps(scene("size 32 24  depth 1", CAMERA + ROOM + LAMP + """
                sphere ball { material blue  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                """, new IndirectSettings(3, 16, 4, false))));
        scenes.put("needles", withMesh(scene("size 32 24  depth 1", CAMERA + ROOM + LAMP + """
                sphere ball { material blue  at 0 -1 0  scale 0.9 0.6 0.9 }
                """, new IndirectSettings(2, 16, 4, false)), SampleMeshes.needles(40)));
        scenes.put("coincident surfaces and a light on a wall", scene("size 32 24  depth 1", CAMERA + ROOM + """
                plane cover { material red  at 0 -1 0  scale 1 1 2 }
                plane edge { material blue  at 0 0 -1  rotate 90 0 0  scale 1 1 2 }
                light lamp point { at 0.25 1 0.25 }
                light other point { at 0 0 -1  color 0.2 0.2 0.2 }
                """, new IndirectSettings(2, 16, 4, false)));
        scenes.put("black", scene("size 16 12  depth 1", CAMERA + LAMP + """
                material black { diffuse 0 0 0 }
                plane floor { material black  at 0 -1 0  scale 9 1 9 }
                sphere ball { material black }
                """, new IndirectSettings(2, 16, 4, true)));
        scenes.put("dim", scene("size 16 12  depth 1", CAMERA + ROOM + """
                light lamp point { at 0.2 0.8 0.3  color 1e-20 1e-20 1e-20  intensity 1e-20 }
                """, new IndirectSettings(2, 16, 4, false)));
        scenes.put("small glows", withMesh(scene("size 32 24  depth 2", CAMERA + ROOM + """
                material flame { glow 40 20 5  diffuse 0 0 0 }
                material neon { glow 3 1 6  diffuse 0.2 0.3 0.4  reflective 0.5 0.1 0 }
                material cool { glow 0 2 9  diffuse 0.1 0.1 0.1 }
                sphere candle { material flame  at -0.4 -0.7 0.1  scale 0.05 0.09 0.05 }
                cylinder tube { material neon  at 0.6 0.2 -0.6  rotate 40 20 10  scale 0.03 0.5 0.03 }
                plane panel { material cool  at 0 0.9 0  scale 0.1 1 0.2 }
                sphere ball { material cool  at 0.7 -0.8 0.5  scale 0.1 0.1 0.1 }
                plane pane { material glass  at -0.5 0 0.3  rotate 90 0 0  scale 0.4 1 0.8 }
                sphere shade { material white  at 0.1 -0.8 0  scale 0.2 0.2 0.2 }
                """, new IndirectSettings(3, 64, 4, false))));
        scenes.put("glow maps", withGlowMaps(withMesh(scene("size 32 24  depth 2", CAMERA + ROOM + """
                material screen { glow 4 2 6  diffuse 0.2 0.3 0.4  reflective 0.5 0.1 0 }
                material torch { glow 40 20 5  diffuse 0 0 0 }
                material shade { glow 3 3 1  diffuse 0.5 0.6 0.7  clear 0.5 0.4 0.6  bulb lamp  bulb_exposure 1 }
                plane screen { material screen  at 0 0.2 -0.9  rotate 90 0 0  scale 1 1 0.6 }
                sphere torch { material torch  at 0.5 -0.7 0.2  scale 0.1 0.1 0.1 }
                plane shade { material shade  at -0.5 0 0.3  rotate 90 30 0  scale 0.6 1 0.8 }
                sphere ball { material screen  at 0.2 -0.6 0.1  scale 0.3 0.3 0.3 }
                """ + LAMP, new IndirectSettings(3, 16, 4, false)))));
        scenes.put("many small glows", scene("size 24 16  depth 1", CAMERA + ROOM + LAMP + "material bulb { glow 9 7 5 }\n"
                + IntStream.range(0, 70).mapToObj(i -> "sphere bulb_" + i + " { material bulb  at " + (i % 10 * 0.2 - 0.9) + " "
                        + (i / 10 * 0.2 - 0.6) + " -0.8  scale 0.02 0.02 0.02 }\n").collect(Collectors.joining()),
                new IndirectSettings(2, 16, 4, false)));
        scenes.put("far away", moved(new Vec3(1e6, -2e6, 1e6)));
        scenes.put("huge", scaled(1e6));
        scenes.put("tiny", scaled(1e-6));
        return scenes;
    }

    /** Returns a scene without its indirect light, for tests of other things: their time stays the same, whatever the scene's file has. */
    public static Scene without(Scene scene) {
        return scene.withPicture(scene.picture().withIndirect(Optional.empty()));
    }

    private static Scene scene(String picture, String text, IndirectSettings settings) {
        try {
            Scene scene = JenReader.read("jen 1\npicture { " + picture + " }\n" + text, "indirect.jen", Path.of("")).scene();
            return scene.withPicture(scene.picture().withIndirect(Optional.of(settings)));
        } catch (JenException e) {
            throw new AssertionError(e);
        }
    }

    private static Scene withEnvironment(Scene scene) {
        float[] rgb = new float[3 * 24 * 12];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = 0.2f + i % 5 * 0.1f;
        }
        Arrays.fill(rgb, 3 * (4 * 24 + 3), 3 * (4 * 24 + 4), 300);
        return scene.withWorld(scene.world().withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(24, 12, rgb)))));
    }

    private static Scene withMesh(Scene scene) {
        return withMesh(scene, SampleMeshes.withVertexColors(SampleMeshes.ball(5, 8, true)));
    }

    private static Scene withMesh(Scene scene, Mesh mesh) {
        return scene.withNodes(scene.nodes().stream().map(node -> node instanceof Shape shape && shape.name().equals("ball")
                ? new Shape(SampleMeshes.solid(mesh), "ball", shape.material(), shape.placement())
                : node).toList());
    }

    public static Scene withBumps(Scene scene) {
        TextureMap steps = new TextureMap("steps.png", 3, 2, new Texture(3, 1, new float[] {0, 0, 0, 1, 1, 1, 0.2f, 0.2f, 0.2f}));
        BumpMapping bumps = BumpMapping.NONE.withBump(Optional.of(steps)).withHeight(1);
        return scene.withMaterials(scene.materials().stream().map(m -> m.withBumpMapping(bumps)).toList());
    }

    /** Gives a map to all materials that glow, and a texture to one of them. */
    private static Scene withGlowMaps(Scene scene) {
        return scene.withMaterials(scene.materials().stream().map(m -> m.glow().isBlack() ? m : m.withGlowMap(Optional.of(CHECKERS)))
                .map(m -> m.name().equals("screen") ? m.withTexture(Optional.of(CHECKERS)) : m).toList());
    }

    private static Scene withTextures(Scene scene) {
        return scene.withMaterials(scene.materials().stream().map(m -> m.withTexture(Optional.of(CHECKERS))).toList());
    }

    /** Returns the room with a ball in units of {@code unit}. */
    private static Scene scaled(double unit) {
        Scene scene = scene("size 24 16  depth 2", CAMERA + ROOM + """
                sphere ball { material mirror  at 0.2 -0.5 -0.2  scale 0.5 0.5 0.5 }
                light lamp point { at 0.2 0.8 0.3  color 0.7 0.6 0.5 }
                """, new IndirectSettings(2, 16, 4, false));
        return scene
                .withCamera(new Camera(scene.camera().from().times(unit), scene.camera().to(), scene.camera().up(), scene.camera().fov()))
                .withNodes(scene.placedShapes().stream().map(PlacedShape::shape).<SceneNode>map(shape -> scaled(shape, unit)).toList())
                .withLights(scene.lights().stream().map(l -> l.withPosition(l.position().times(unit))).toList());
    }

    /** Returns the room at another place. */
    private static Scene moved(Vec3 by) {
        Scene scene = scene("size 24 16  depth 1", CAMERA + ROOM + LAMP, new IndirectSettings(2, 16, 4, false));
        Camera camera = scene.camera();
        return scene.withCamera(new Camera(camera.from().plus(by), camera.to().plus(by), camera.up(), camera.fov()))
                .withNodes(scene.placedShapes().stream().map(PlacedShape::shape).<SceneNode>map(shape -> shape.withPlacement(
                        new Placement(shape.placement().position().plus(by), shape.placement().rotation(), shape.placement().scale())))
                        .toList())
                .withLights(scene.lights().stream().map(l -> l.withPosition(l.position().plus(by))).toList());
    }

    private static Shape scaled(Shape shape, double unit) {
        Placement p = shape.placement();
        return shape.withPlacement(new Placement(p.position().times(unit), p.rotation(), p.scale().times(unit)));
    }

    /** Returns a scene with indirect light of its lights. */
    public static Scene with(Scene scene) {
        return with(scene, false);
    }

    /** Returns a scene with indirect light of its lights and its background. */
    public static Scene withBackground(Scene scene) {
        return with(scene, true);
    }

    private static Scene with(Scene scene, boolean background) {
        return scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(2, 16, 4, background))));
    }

    /** Returns a scene without anti-aliasing at edges. */
    public static Scene withoutEdges(Scene scene) {
        return scene.picture().sampling().antialias() != AntialiasMode.EDGES ? scene
                : scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
    }
}
