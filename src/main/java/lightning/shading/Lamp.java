package lightning.shading;

import lightning.math.Transform;
import lightning.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/**
 * Where a light shines from, in render space: all that decides which rows it reaches and the terms there, and not how strongly
 * it shines.
 *
 * @param light    what it was made from
 * @param source   the position of a point or spot light; for a directional light the unit vector
 *                 towards it
 * @param axis     the unit direction in which a spot light shines
 * @param cosAngle the cosine of half the cone's opening
 */
public record Lamp(Light light, Vec3 source, Vec3 axis, double cosAngle) {

    /** The lamp of a light as the scene's camera sees it. */
    public static Lamp of(Light light, Scene scene) {
        Vec3 axis = light.direction().normalized();
        Vec3 source = light.type().hasPosition() ? light.position().minus(scene.camera().origin()) : axis.negated();
        return new Lamp(light, source, axis, Transform.cosDegrees(light.angle()));
    }

    public LightType type() {
        return light.type();
    }

    /** Whether its falloff is 1 everywhere, so that no column is needed for it. */
    public boolean fallsOff() {
        return switch (type()) {
            case DIRECTIONAL -> false;
            case POINT -> !light.attenuation().isNone();
            case SPOT -> !light.attenuation().isNone() || light.dropoff() != 0 || DoorFactor.acts(this);
        };
    }
}
