package lightning.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * What of a scene the picture shows. Two scenes with equal visible parts give the same picture in every bit: moving a
 * directional light, renaming a light, or turning the cone of a point light is an edit of the document and none of the
 * picture.
 */
public final class VisibleState {
    private VisibleState() {}

    /** The scene with everything that does not act set to one fixed value, without its shapes: only lights take part in this. */
    public static Scene of(Scene scene) {
        // Without shapes their names are out of the way of the lights'.
        return scene.withRig(LightRig.EMPTY).withNodes(List.of()).withLights(lights(scene));
    }

    /** Whether two scenes give the same picture for sure. */
    public static boolean isSame(Scene a, Scene b) {
        return a.stage().equals(b.stage()) && a.picture().equals(b.picture()) && a.camera().equals(b.camera())
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

    /** The lights with everything that does not act set to one fixed value, their names and banks included; an environment brings its own. */
    private static List<Light> lights(Scene scene) {
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(light(scene, scene.rig().effectiveLight(light), "light" + lights.size()));
        }
        return lights;
    }

    private static Light light(Scene scene, Light light, String name) {
        // A solo light darkens what stays of the environment, even if it is dark itself.
        boolean solo = light.on() && light.solo() && scene.world().environment().isPresent();
        if (!scene.isActive(light) || light.weight().isBlack()) {
            return Light.of(name, LightType.POINT).withIntensity(0).withOn(solo).withSolo(solo);
        }
        Light normalized = Light.of(name, light.type()).withSolo(solo);
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute.term(light).isPresent()) {
                normalized = attribute.copy(light, normalized);
            }
        }
        return normalized.attenuation().isNone() ? normalized.withAttenuation(Attenuation.NONE) : normalized;
    }
}
