package lightning.scene;

import lightning.math.Rgb;
import lightning.math.Vec3;

/**
 * A light with all attributes, whatever its type; the type decides which of them act (paper §4.5).
 *
 * @param name        unique among all shapes, groups and lights
 * @param color       linear, 0…1000 per channel
 * @param intensity   ≥ 0
 * @param position    scene units
 * @param direction   where it shines to, any length
 * @param attenuation point and spot lights
 * @param angle       half the opening of a spot's cone, degrees, 0…180
 * @param dropoff     the exponent of a spot's fall from its axis, ≥ 0
 * @param on          whether it shines
 * @param solo        whether it shines alone: where any light is solo, the others are dark
 */
public record Light(String name, LightType type, Rgb color, double intensity, Vec3 position, Vec3 direction,
        Attenuation attenuation, double angle, double dropoff, boolean on, boolean solo) {

    public Light {
        Limits.name(name);
        Limits.range("color", color, Limits.MAX_LIGHT_COLOR);
        Limits.range("intensity", intensity, 0, Limits.MAX_INTENSITY);
        Limits.position("position", position);
        Limits.direction("direction", direction);
        Limits.range("angle", angle, 0, Limits.MAX_ANGLE);
        Limits.range("dropoff", dropoff, 0, Limits.MAX_DROPOFF);
    }

    /** A white light of intensity 1 at the origin, shining down, without fading. */
    public static Light of(String name, LightType type) {
        return new Light(name, type, Rgb.WHITE, 1, Vec3.ZERO, new Vec3(0, -1, 0), Attenuation.NONE, 30, 0, true, false);
    }

    public Light withName(String v) {
        return new Light(v, type, color, intensity, position, direction, attenuation, angle, dropoff, on, solo);
    }

    public Light withType(LightType v) {
        return new Light(name, v, color, intensity, position, direction, attenuation, angle, dropoff, on, solo);
    }

    public Light withColor(Rgb v) {
        return new Light(name, type, v, intensity, position, direction, attenuation, angle, dropoff, on, solo);
    }

    public Light withIntensity(double v) {
        return new Light(name, type, color, v, position, direction, attenuation, angle, dropoff, on, solo);
    }

    public Light withPosition(Vec3 v) {
        return new Light(name, type, color, intensity, v, direction, attenuation, angle, dropoff, on, solo);
    }

    public Light withDirection(Vec3 v) {
        return new Light(name, type, color, intensity, position, v, attenuation, angle, dropoff, on, solo);
    }

    public Light withAttenuation(Attenuation v) {
        return new Light(name, type, color, intensity, position, direction, v, angle, dropoff, on, solo);
    }

    public Light withAngle(double v) {
        return new Light(name, type, color, intensity, position, direction, attenuation, v, dropoff, on, solo);
    }

    public Light withDropoff(double v) {
        return new Light(name, type, color, intensity, position, direction, attenuation, angle, v, on, solo);
    }

    public Light withOn(boolean v) {
        return new Light(name, type, color, intensity, position, direction, attenuation, angle, dropoff, v, solo);
    }

    public Light withSolo(boolean v) {
        return new Light(name, type, color, intensity, position, direction, attenuation, angle, dropoff, on, v);
    }
}
