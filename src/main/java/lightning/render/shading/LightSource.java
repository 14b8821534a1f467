package lightning.render.shading;

import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;

/**
 * Where a light shines from, in render space: all that decides which rows it reaches and the terms there, and not how strongly
 * it shines.
 *
 * @param light    what it was made from
 * @param position   the position of a light that has one; for a directional light the unit vector
 *                 towards it
 * @param axis     the unit direction in which the light shines
 * @param cosAngle the cosine of half the cone's opening; that of a surface is a half space
 * @param dropoff  the exponent of the fall from the axis; 1 for a surface (Lambert's cosine)
 * @param samples     the samples of which its light is the mean; null for a point, whose only one is the source
 */
public record LightSource(Light light, Vec3 position, Vec3 axis, double cosAngle, double dropoff, AreaSamples samples) {

    /** The lamp of a light as the scene's camera sees it. */
    public static LightSource of(Light light, Scene scene) {
        Vec3 axis = light.direction().normalized();
        Vec3 source = light.type().hasPosition() ? light.position().minus(scene.camera().origin()) : axis.negated();
        boolean surface = light.type().isSurface();
        return new LightSource(light, source, axis, surface ? 0 : Transform.cosDegrees(light.angle()), surface ? 1 : light.dropoff(),
                light.isArea() ? AreaSamples.of(light, source, axis) : null);
    }

    public LightType type() {
        return light.type();
    }

    /** Whether it is larger than a point. */
    public boolean isArea() {
        return samples != null;
    }

    /** Whether rows away from its axis may be outside its cone. */
    public boolean hasCone() {
        return type().hasCone() || type().isSurface();
    }

    /** Whether it fades: its falloff is not 1 everywhere. */
    boolean hasFalloff() {
        return switch (type()) {
            case DIRECTIONAL -> false;
            case POINT -> !light.attenuation().isNone() || AngularMask.isActive(this);
            case SPOT -> !light.attenuation().isNone() || dropoff != 0 || AngularMask.isActive(this);
            case RECT, DISC -> true;
        };
    }

    /** Whether a column is needed for its falloff; that of each sample of an area is in the terms already. */
    public boolean needsFalloffColumn() {
        return samples == null && hasFalloff();
    }

    /** One of its samples alone, as rows of a turn see it. */
    LightSource sample(int rotation, int s) {
        return new LightSource(light, samples.position(rotation, s), axis, cosAngle, dropoff, null);
    }
}
