package lightning.shading;

import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/**
 * A light as the equation needs it, in render space.
 *
 * @param light     what it was made from
 * @param source    the position of a point or spot light; for a directional light the unit vector
 *                  towards it
 * @param axis      the unit direction in which a spot light shines
 * @param cosAngle  the cosine of half the cone's opening
 * @param red       colour · intensity of the red channel; 0 in all three where the light is off
 * @param green     likewise
 * @param blue      likewise
 */
public record Lamp(Light light, Vec3 source, Vec3 axis, double cosAngle, float red, float green, float blue) {

    /** Prepares a light of a scene. */
    public static Lamp of(Light light, Scene scene) {
        return of(light, scene.camera().from(), scene.shines(light) ? light.intensity() : 0);
    }

    /** Prepares all lights of a scene, in its order. */
    public static Lamp[] all(Scene scene) {
        return scene.lights().stream().map(light -> of(light, scene)).toArray(Lamp[]::new);
    }

    /** Prepares a light as if it were on and no other were solo. */
    public static Lamp shining(Light light, Scene scene) {
        return of(light, scene.camera().from(), light.intensity());
    }

    private static Lamp of(Light light, Vec3 camera, double power) {
        Vec3 axis = light.direction().normalized();
        Vec3 source = light.type().hasPosition() ? light.position().minus(camera) : axis.negated();
        return new Lamp(light, source, axis, Transform.cosDegrees(light.angle()),
                (float) (light.color().r() * power), (float) (light.color().g() * power), (float) (light.color().b() * power));
    }

    public LightType type() {
        return light.type();
    }

    /** Whether it adds nothing anywhere: off, or a weight that is 0 in every channel. */
    public boolean isDark() {
        return red == 0 && green == 0 && blue == 0;
    }

    /** Whether its falloff is 1 everywhere, so that no column is needed for it. */
    public boolean fallsOff() {
        return switch (type()) {
            case DIRECTIONAL -> false;
            case POINT -> !light.attenuation().isNone();
            case SPOT -> !light.attenuation().isNone() || light.dropoff() != 0;
        };
    }
}
