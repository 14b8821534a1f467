package lightning.relight.plan;

import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Light;
import lightning.shading.ConeChange;

/**
 * What differs between the light that a layer was computed for and the light wanted, in the terms
 * that decide the update; attributes that the type does not act on do not count.
 *
 * @param moved   the source is another: position, or direction of a directional light, or one for the other
 * @param cone    which rows may enter or leave the cone
 * @param falloff whether the falloff of any row may change
 * @param weight  whether colour · intensity changes
 */
record LightDifference(boolean moved, ConeChange cone, boolean falloff, boolean weight) {

    static LightDifference between(Light before, Light wanted) {
        ConeChange cone = cone(before, wanted);
        return new LightDifference(moved(before, wanted), cone,
                falloff(before, wanted) || cone == ConeChange.TURN, weight(before, wanted));
    }

    private static boolean moved(Light before, Light wanted) {
        if (before.type().hasPosition() != wanted.type().hasPosition()) {
            return true;
        }
        return wanted.type().hasPosition()
                ? !samePoint(before.position(), wanted.position())
                : !sameDirection(before, wanted);
    }

    private static boolean samePoint(Vec3 a, Vec3 b) {
        return a.x() == b.x() && a.y() == b.y() && a.z() == b.z();
    }

    private static boolean sameDirection(Light before, Light wanted) {
        return samePoint(before.direction().normalized(), wanted.direction().normalized());
    }

    private static ConeChange cone(Light before, Light wanted) {
        if (before.type().hasCone() != wanted.type().hasCone()) {
            return ConeChange.TURN;
        }
        if (!wanted.type().hasCone()) {
            return ConeChange.NONE;
        }
        if (!sameDirection(before, wanted)) {
            return ConeChange.TURN;
        }
        return before.angle() == wanted.angle() ? ConeChange.NONE
                : before.angle() > wanted.angle() ? ConeChange.ANGLE_REMOVE : ConeChange.ANGLE_ADD;
    }

    private static boolean falloff(Light before, Light wanted) {
        boolean attenuation = wanted.type().hasPosition() && !before.attenuation().equals(wanted.attenuation());
        boolean dropoff = wanted.type().hasCone() && before.dropoff() != wanted.dropoff();
        return attenuation || dropoff;
    }

    private static boolean weight(Light before, Light wanted) {
        Rgb a = before.color();
        Rgb b = wanted.color();
        return before.intensity() != wanted.intensity() || a.r() != b.r() || a.g() != b.g() || a.b() != b.b();
    }
}
