package lightning.document;

import java.util.Locale;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ViewFocus;
import lightning.scene.Scene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Emission;
import lightning.scene.light.Falloff;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;

/**
 * Creates lights that suit the scene's size. Their light falls off with the square of the distance, and their exposure makes white paper at
 * the point that they face as bright as intensity 1 without falloff would.
 */
public final class NewLight {
    /** Exposures are multiples of one over this, stops. */
    private static final double STEPS_PER_STOP = 10;

    /** A fill light has a quarter of the key light's brightness in a usual portrait. */
    private static final double STOPS_BELOW_KEY = 2;
    /** Least brightness of a key light, in stops below white paper: a scene that is nearly dark needs no fainter light. */
    private static final double DARKEST_KEY = 8;
    /** Share of the surface of a convex object that is seen, projected: a quarter (Cauchy 1850). */
    private static final double CONVEX_SHARE = 0.25;

    private NewLight() {}

    /**
     * Returns a white light at the upper right of the camera, aimed at the point that the camera looks at. It makes white paper there white
     * at the picture's exposure, or a quarter as bright as the strongest light makes it if the scene is lit already.
     */
    public static Light of(Scene scene, LightType type) {
        var view = PreviewCamera.of(scene);
        Vec3 focus = ViewFocus.of(scene);
        Vec3 from = view.camera().from();
        double side = focus.minus(from).length() / 2;
        Light light = of(type, from.plus(view.right().times(side)).plus(view.up().times(side)), focus);
        return light.withEmission(light.emission().withExposure(rounded(light.emission().exposure() + stops(scene, focus))));
    }

    /** Returns the brightness that suits white paper at a point, in stops above intensity 1. */
    private static double stops(Scene scene, Vec3 at) {
        double white = -scene.picture().view().exposure();
        if (scene.lights().stream().noneMatch(Light::on) && !scene.world().hasEnvironment()) {
            return white;
        }
        double key = scene.lights().stream().filter(scene.rig()::isActive).mapToDouble(l -> brightness(scene.rig().effectiveLight(l), at))
                .max().orElse(0);
        return (key > 0 ? Math.clamp(Math.log(key) / Math.log(2), white - DARKEST_KEY, white) : white) - STOPS_BELOW_KEY;
    }

    /** Returns how bright a light makes white paper that faces it, at a point that nothing shades. */
    private static double brightness(Light effective, Vec3 at) {
        Vec3 toPoint = at.minus(effective.position());
        double distance = toPoint.length();
        double cosine = effective.type() == LightType.DIRECTIONAL || effective.type() == LightType.POINT || distance == 0 ? 1
                : effective.direction().normalized().dot(toPoint) / distance;
        boolean isOutside = effective.type() == LightType.SPOT && cosine < Math.cos(Math.toRadians(effective.angle()));
        double share = effective.type() == LightType.TUBE ? Math.sqrt(Math.max(0, 1 - cosine * cosine))
                : effective.type() == LightType.OBJECT ? CONVEX_SHARE : effective.type().isSurface() ? Math.max(0, cosine) : isOutside ? 0
                : 1;
        return effective.weight().luminance() * share * strength(effective, distance);
    }

    /** Returns a white light at a position, aimed at another point. */
    public static Light of(LightType type, Vec3 position, Vec3 target) {
        double distance = target.minus(position).length();
        // Typical size in a studio: about four tenths of the distance.
        double size = Math.min(distance * 0.4, SceneLimits.MAX_EXTENT);
        double radius = switch (type) {
            case DISC -> size / 2;
            case TUBE -> size / 40;
            case DIRECTIONAL, POINT, SPOT, RECT, OBJECT -> 0;
        };
        Light light = Light.of(type.name().toLowerCase(Locale.ROOT), type).withPosition(position);
        light = type == LightType.TUBE ? light.withDirection(AreaShape.DEFAULT.right(target.minus(position).normalized()))
                : light.withDirection(target.minus(position));
        Light sized = light.withArea(light.area().withWidth(size).withHeight(size).withRadius(radius));
        return !type.hasPosition() ? sized
                : keepBrightness(sized, sized.withFalloff(Falloff.INVERSE_SQUARE), distance);
    }

    /** Returns {@code after} with the exposure that gives it the strength of {@code before} at a distance; rounded. */
    static Light keepBrightness(Light before, Light after, double distance) {
        double ratio = strength(before, distance) / strength(after, distance);
        if (!(ratio > 0 && ratio < Double.POSITIVE_INFINITY)) {
            return after;
        }
        double stops = after.emission().exposure() + Math.log(ratio) / Math.log(2);
        return after.withEmission(after.emission().withExposure(rounded(stops)));
    }

    private static double rounded(double stops) {
        double steps = Math.rint(stops * STEPS_PER_STOP) / STEPS_PER_STOP;
        return Math.clamp(steps, -Emission.MAX_EXPOSURE, Emission.MAX_EXPOSURE) + 0.0;
    }

    private static double strength(Light light, double distance) {
        if (!light.type().hasPosition()) {
            return 1;
        }
        var terms = light.distanceTerms();
        return Math.min(1 / (terms.constant() + terms.linear() * distance + terms.quadratic() * distance * distance), light.maxFalloff());
    }
}
