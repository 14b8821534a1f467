package lightning.scene.asset;

import lightning.base.file.ContentDigest;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;

/**
 * Disc of even radiance in an environment, brighter and smaller than pixels can be.
 *
 * @param direction unit direction to its center, before the environment's rotation
 * @param light     linear color of its light on a surface that faces it: radiance times solid angle, ≥ 0
 * @param radius    half its angle, degrees, 0 … 90 without 0
 */
public record EnvironmentSun(Vec3 direction, Rgb light, double radius) {
    /** Returns its radiance. */
    Rgb radiance() {
        double sin = Transform.sinDegrees(radius);
        return light.times(1 / (Math.PI * sin * sin));
    }

    /** Adds all numbers that determine it. */
    void addTo(ContentDigest digest) {
        digest.add(new double[] {direction.x(), direction.y(), direction.z(), light.r(), light.g(), light.b(), radius});
    }

    /** Returns it as a light. */
    EnvironmentLight toLight() {
        double mean = (1 + Transform.cosDegrees(radius)) / 2;
        double scale = 1 / (Math.PI * mean);
        return new EnvironmentLight(direction, mean, radius, light.r() * scale, light.g() * scale, light.b() * scale);
    }
}
