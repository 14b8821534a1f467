package lightning.format.pov;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Scene;

/** Writes lights; those that do not shine are left out. */
final class PovLight {
    /** How far away a directional light is put, in sizes of the scene. */
    private static final double FAR = 100;

    private final Extent extent;
    private final List<String> losses;

    PovLight(Extent extent, List<String> losses) {
        this.extent = extent;
        this.losses = losses;
    }

    String text(Scene scene, Light light) {
        if (!scene.shines(light)) {
            return "// light " + light.name() + " is off\n";
        }
        PovFade fade = light.type().hasPosition() ? fade(light) : new PovFade(1, 0, 0, true);
        if (!fade.exact()) {
            losses.add("light " + light.name() + ": attenuation is POV-Ray's nearest, 2/(1+(d/distance)^power), without the limit 1");
        }
        if (LightAttribute.PROFILE.acts(light.type()) && light.profile().isPresent()) {
            losses.add("light " + light.name() + ": its profile is left out, POV-Ray reads no IES file");
        }
        if (LightAttribute.DOORS.acts(light.type()) && !light.doors().isOpen()) {
            losses.add("light " + light.name() + ": its barn doors are left out");
        }
        if (light.isLinked()) {
            // A light group takes its shapes out of all others, so that it can say only links of one light.
            losses.add("light " + light.name() + ": its links are left out, it lights all shapes and all throw shadows");
        }
        List<String> words = new ArrayList<>();
        words.add(PovText.vector(place(light)));
        words.add(color(light, fade.gain()));
        switch (light.type()) {
            case DIRECTIONAL -> words.add("parallel point_at " + PovText.vector(extent.center()));
            case POINT -> {}
            case SPOT -> words.addAll(spot(light));
            case RECT, DISC -> words.addAll(surface(light));
        }
        words.addAll(area(light));
        if (fade.distance() > 0) {
            words.add("fade_distance " + fade.distance() + " fade_power " + fade.power());
        }
        return "// " + light.name() + "\nlight_source {\n  " + String.join("\n  ", words) + "\n}\n";
    }

    private PovFade fade(Light light) {
        double middle = light.position().minus(extent.center()).length();
        double near = Math.max(middle - extent.radius(), extent.radius() / 20);
        return PovFade.of(light.attenuation(), near, middle + extent.radius());
    }

    private Vec3 place(Light light) {
        return light.type().hasPosition() ? light.position()
                : extent.center().minus(light.direction().normalized().times(FAR * extent.radius()));
    }

    private static String color(Light light, double gain) {
        Rgb c = light.color().times(light.intensity() * gain);
        return PovText.rgb(c);
    }

    /** A hard edge at the angle, and the axis' cosine to the power of the dropoff. */
    private List<String> spot(Light light) {
        if (light.angle() == 180 && light.dropoff() == 0 && light.doors().isOpen() && light.gobo().isEmpty()) {
            return List.of();
        }
        if (light.angle() >= 90) {
            losses.add("light " + light.name() + ": a cone of 90 degrees and more ends at 90 in POV-Ray");
        }
        if (light.gobo().isPresent()) {
            losses.add("light " + light.name() + ": its gobo is left out");
        }
        double angle = Math.min(light.angle(), 90);
        Vec3 target = light.position().plus(light.direction().normalized().times(extent.radius()));
        return List.of("spotlight point_at " + PovText.vector(target),
                "radius " + angle + " falloff " + angle + " tightness " + light.dropoff());
    }

    /** A half space, fading by the cosine. */
    private List<String> surface(Light light) {
        Vec3 target = light.position().plus(light.direction().normalized().times(extent.radius()));
        return List.of("spotlight point_at " + PovText.vector(target), "radius 90 falloff 90 tightness 1");
    }

    /** POV-Ray has a grid on a rectangle, whole or cut to an ellipse; a ball is one that always faces the point that is lit. */
    private List<String> area(Light light) {
        if (!light.isArea()) {
            return List.of();
        }
        Vec3 axis = light.direction().normalized();
        Vec3 right = light.area().right(axis);
        Vec3 top = right.cross(axis);
        boolean rect = light.type() == LightType.RECT;
        double far = FAR * extent.radius();
        double radius = light.type().hasPosition() ? light.area().radius()
                : far * Transform.sinDegrees(light.area().spread()) / Math.max(Transform.cosDegrees(light.area().spread()), 0.01);
        double width = rect ? light.area().width() : 2 * radius;
        double height = rect ? light.area().height() : 2 * radius;
        // A side of more than half the samples leaves no grid.
        int across = Math.max(2, (int) Math.round(Math.sqrt(light.area().samples())));
        losses.add("light " + light.name() + ": POV-Ray's area light has a grid of " + across + " × " + across
                + " samples, and fades and highlights as its centre does");
        String shape = switch (light.type()) {
            case RECT -> "";
            case DISC, DIRECTIONAL -> " circular";
            case POINT, SPOT -> " circular orient";
        };
        return List.of("area_light " + PovText.vector(right.times(width)) + ", " + PovText.vector(top.times(height)) + ", " + across + ", "
                + across + shape + " jitter adaptive 2");
    }
}
