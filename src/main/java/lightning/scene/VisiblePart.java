package lightning.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * What of a scene the picture shows. Two scenes with equal visible parts give the same picture in every bit: moving a
 * directional light, renaming a light, or turning the cone of a point light is an edit of the document and none of the
 * picture.
 */
public final class VisiblePart {
    private VisiblePart() {}

    /** The scene with everything that does not act set to one fixed value, without its shapes: only lights take part in this. */
    public static Scene of(Scene scene) {
        // Without shapes their names are out of the way of the lights'.
        return scene.withRig(Rig.DARK).withNodes(List.of()).withLights(lights(scene));
    }

    /** Whether two scenes give the same picture for sure. */
    public static boolean same(Scene a, Scene b) {
        return a.stage().equals(b.stage()) && a.picture().equals(b.picture()) && a.camera().equals(b.camera())
                && a.world().equals(b.world()) && sameLights(a, b);
    }

    private static boolean sameLights(Scene a, Scene b) {
        List<Light> of = a.rig().actingLights();
        List<Light> and = b.rig().actingLights();
        boolean same = of.size() == and.size();
        for (int i = 0; same && i < of.size(); i++) {
            Light one = of.get(i);
            Light other = and.get(i);
            same = one.equals(other) && a.shines(one) == b.shines(other) || light(a, one, "light").equals(light(b, other, "light"));
        }
        return same;
    }

    /** The lights with everything that does not act set to one fixed value, their names and banks included; an environment brings its own. */
    private static List<Light> lights(Scene scene) {
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(light(scene, scene.rig().acting(light), "light" + lights.size()));
        }
        return lights;
    }

    private static Light light(Scene scene, Light light, String name) {
        // A solo light darkens what stays of the environment, even if it is dark itself.
        boolean solo = light.on() && light.solo() && scene.world().environment().isPresent();
        if (!scene.shines(light) || light.weight().isBlack()) {
            return Light.of(name, LightType.POINT).withIntensity(0).withOn(solo).withSolo(solo);
        }
        Light acting = Light.of(name, light.type()).withSolo(solo);
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute.term(light).isPresent()) {
                acting = attribute.copy(light, acting);
            }
        }
        return acting.attenuation().isNone() ? acting.withAttenuation(Attenuation.NONE) : acting;
    }
}
