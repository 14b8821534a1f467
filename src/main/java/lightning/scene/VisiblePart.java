package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import lightning.math.Rgb;
import lightning.math.Vec3;

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
                && a.world().equals(b.world()) && (a.rig().equals(b.rig()) || lights(a).equals(lights(b)));
    }

    /** The lights with everything that does not act set to one fixed value, their names included. */
    private static List<Light> lights(Scene scene) {
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(light(scene, light, "light" + lights.size()));
        }
        return lights;
    }

    private static Light light(Scene scene, Light light, String name) {
        Light plain = Light.of(name, LightType.POINT);
        Rgb weight = light.color().times(light.intensity());
        if (!scene.shines(light) || weight.isBlack()) {
            return plain.withOn(false);
        }
        LightType type = light.type();
        Vec3 place = type.hasPosition() ? light.position() : Vec3.ZERO;
        Light acting = plain.withType(type).withColor(light.color()).withIntensity(light.intensity()).withPosition(place);
        if (type.hasDirection()) {
            acting = acting.withDirection(light.direction());
        }
        if (type.hasPosition()) {
            acting = acting.withAttenuation(light.attenuation().isNone() ? Attenuation.NONE : light.attenuation());
        }
        return type.hasCone() ? acting.withAngle(light.angle()).withDropoff(light.dropoff()) : acting;
    }
}
