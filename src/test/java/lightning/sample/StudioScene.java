package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.Placement;

/** Simple scene with all basic effects: a matte ball and a mirror ball over a mirror floor, and one light. */
public final class StudioScene {
    /** Name of the light. */
    public static final String KEY = "key";

    private StudioScene() {}

    /** Returns the scene, 30 × 24 pixels, depth 2, with a light of the given type. */
    public static Scene of(LightType type) {
        return new Scene(new PictureSettings(30, 24, 2), new Camera(new Vec3(0, 2, 7), Vec3.ZERO, Vec3.Y, 40), World.DEFAULT,
                List.of(material("matt", Rgb.BLACK), material("glass", Rgb.gray(0.5))), nodes(), List.of(key(type)));
    }

    /** Returns the scene with a spot, two point lights and a directional one, at a size. */
    public static Scene withFourLights(int width, int height) {
        Scene scene = of(LightType.SPOT);
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(key(LightType.POINT).withName("fill").withPosition(new Vec3(-3, 3, 3)));
        lights.add(key(LightType.POINT).withName("back").withPosition(new Vec3(0, 2, -4)).withIntensity(0.3));
        lights.add(key(LightType.DIRECTIONAL).withName("sun").withColor(new Rgb(1, 0.9, 0.7)));
        return scene.withLights(lights).withPicture(scene.picture().withSize(width, height));
    }

    /** Returns a point-sized light, or the light of the ball, with rows of every state: lit, shadowed and, for a spot, outside its cone. */
    public static Light key(LightType type) {
        return Light.of(KEY, type).withPosition(new Vec3(2, 4, 2)).withDirection(new Vec3(-2, -4.5, -2.2))
                .withAttenuation(new Attenuation(0.1, 0.2, 0.01)).withAngle(20).withDropoff(2)
                .withArea(AreaShape.DEFAULT.withWidth(0).withHeight(0).withShape(type == LightType.OBJECT ? "ball" : ""));
    }

    private static Material material(String name, Rgb reflective) {
        return Material.of(name).withAmbient(Rgb.gray(0.1)).withDiffuse(Rgb.gray(0.7)).withSpecular(Rgb.gray(0.2)).withShininess(8)
                .withReflective(reflective);
    }

    private static List<SceneNode> nodes() {
        return List.of(new Shape(Solid.PLANE, "floor", "glass", placement(new Vec3(0, -1, 0), new Vec3(9, 1, 9))),
                new Shape(Solid.SPHERE, "ball", "matt", placement(Vec3.ZERO, Vec3.ONE)),
                new Shape(Solid.SPHERE, "mirror", "glass", placement(new Vec3(-2, 0, -1), Vec3.ONE)));
    }

    private static Placement placement(Vec3 at, Vec3 scale) {
        return new Placement(at, Vec3.ZERO, scale);
    }
}
