package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Falloff;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;

/**
 * Normal form of a scene that keeps only what affects the image. Scenes with equal normal forms give the same image in every bit. Moving a
 * directional light, renaming a light, or rotating a point light edits the document, but not the image.
 */
public final class VisibleState {
    private VisibleState() {}

    /** Returns the scene without shapes and with all ineffective attributes of lights set to fixed values; normalizes only lights. */
    public static Scene of(Scene scene) {
        // Removes the shapes, so that the lights' fixed names cannot conflict with theirs.
        return scene.withRig(LightRig.EMPTY).withNodes(List.of()).withLights(lights(scene));
    }

    /** Returns whether two scenes certainly give the same linear image; their views may differ. */
    public static boolean isSame(Scene a, Scene b) {
        return a.stage().equals(b.stage()) && a.picture().hasSameImage(b.picture()) && a.camera().hasSameView(b.camera())
                && a.hasSameSamples(b)
                && a.world().equals(b.world()) && sameLights(a, b);
    }

    private static boolean sameLights(Scene a, Scene b) {
        List<Light> first = a.rig().effectiveLights();
        List<Light> second = b.rig().effectiveLights();
        boolean same = first.size() == second.size();
        for (int i = 0; same && i < first.size(); i++) {
            Light lightA = first.get(i);
            Light lightB = second.get(i);
            same = lightA.equals(lightB) && a.isActive(lightA) == b.isActive(lightB)
                    || light(a, lightA, "light").equals(light(b, lightB, "light"));
        }
        return same;
    }

    /** Returns the lights with all ineffective attributes, names and groups set to fixed values; the environment adds its own lights. */
    private static List<Light> lights(Scene scene) {
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(light(scene, scene.rig().effectiveLight(light), "light" + lights.size()));
        }
        return lights;
    }

    private static Light light(Scene scene, Light light, String name) {
        // A solo light darkens the environment even if it is dark itself.
        boolean solo = light.on() && light.solo() && scene.world().hasEnvironment();
        if (!scene.isActive(light) || light.weight().isBlack()) {
            Light dark = Light.of(name, LightType.POINT).withIntensity(0).withOn(solo).withSolo(solo);
            // The face of a dark light is black, but hides what is farther away.
            return light.area().visibility() == FaceVisibility.HIDDEN ? dark
                    : dark.withType(light.type()).withPosition(light.position()).withDirection(light.direction()).withArea(light.area());
        }
        Light normalized = Light.of(name, light.type()).withSolo(solo);
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute.term(light).isPresent()) {
                normalized = attribute.copy(light, normalized);
            }
        }
        return normalized.falloff() == Falloff.CUSTOM && normalized.attenuation().isNone() ? normalized.withAttenuation(Attenuation.NONE)
                : normalized;
    }
}
