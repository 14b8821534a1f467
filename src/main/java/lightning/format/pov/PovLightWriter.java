package lightning.format.pov;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.Scene;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;

/** Writer for lights; omits lights that are off. */
record PovLightWriter(BoundingSphere bounds, List<String> warnings) {
    /** Distance of a directional light, in multiples of the scene's size. */
    private static final double DIRECTIONAL_DISTANCE = 100;

    String text(Scene scene, Light light) {
        if (light.type() == LightType.OBJECT) {
            warnings.add("light " + light.name() + ": it is left out, since POV-Ray has no lights that are objects; the object glows");
            return "";
        }
        if (!scene.isActive(light)) {
            return "// light " + light.name() + " is off\n";
        }
        PovFade fade = light.type().hasPosition() ? fade(light) : new PovFade(1, 0, 0, true);
        if (!fade.isExact()) {
            warnings.add("light " + light.name() + ": attenuation is approximated by 2/(1+(d/distance)^power), without the limit 1");
        }
        if (LightAttribute.PROFILE.appliesTo(light.type()) && light.profile().isPresent()) {
            warnings.add("light " + light.name() + ": its profile is left out, POV-Ray does not support IES files");
        }
        if (LightAttribute.DOORS.appliesTo(light.type()) && !light.doors().isOpen()) {
            warnings.add("light " + light.name() + ": its barn doors are left out");
        }
        if (light.flag().on() || light.filter().isActive()) {
            warnings.add("light " + light.name() + ": its flag and its filter are left out");
        }
        if (LightAttribute.GOBO.appliesTo(light.type()) && light.gobo().isPresent()) {
            warnings.add("light " + light.name() + ": its gobo is left out");
        }
        if (light.type().isSurface() && !light.beam().isOpen()) {
            warnings.add("light " + light.name() + ": its cone has a hard edge, and its beam spread is left out");
        }
        if (light.isLinked()) {
            // POV-Ray's light_group excludes its shapes from all other lights, so it can express links of a single light
            // only.
            warnings.add("light " + light.name() + ": its light links are left out, it illuminates all objects and all cast shadows");
        }
        if (light.influence().diffuse() != 1 || light.influence().specular() != 1) {
            warnings.add("light " + light.name() + ": its diffuse and specular gains are left out");
        }
        if (!light.influence().castsShadows()) {
            // POV-Ray's shadowless lights have neither a cone nor highlights.
            warnings.add("light " + light.name() + ": it casts shadows here");
        }
        if (light.isArea() && light.type().hasPosition() && light.area().visibility() != FaceVisibility.HIDDEN) {
            warnings.add("light " + light.name() + ": its face is left out, the camera does not see it");
        }
        if (light.faceImage().isPresent()) {
            warnings.add("light " + light.name() + ": its texture is left out");
        }
        List<String> statements = new ArrayList<>();
        statements.add(PovFormat.vector(position(light)));
        statements.add(color(light, fade.gain()));
        switch (light.type()) {
            case DIRECTIONAL -> statements.add("parallel point_at " + PovFormat.vector(bounds.center()));
            case POINT, TUBE, OBJECT -> {}
            case SPOT -> statements.addAll(spot(light));
            case RECT, DISC -> statements.addAll(surface(light));
        }
        statements.addAll(area(light));
        if (fade.distance() > 0) {
            statements.add("fade_distance " + fade.distance() + " fade_power " + fade.power());
        }
        return "// " + light.name() + "\nlight_source {\n  " + String.join("\n  ", statements) + "\n}\n";
    }

    private PovFade fade(Light light) {
        double middle = light.position().minus(bounds.center()).length();
        double near = Math.max(middle - bounds.radius(), bounds.radius() / 20);
        return PovFade.of(light.distanceTerms(), near, middle + bounds.radius());
    }

    private Vec3 position(Light light) {
        return light.type().hasPosition() ? light.position()
                : bounds.center().minus(light.direction().normalized().times(DIRECTIONAL_DISTANCE * bounds.radius()));
    }

    private static String color(Light light, double gain) {
        Rgb c = light.color().times(light.intensity() * light.wideningFactor() * gain);
        return PovFormat.rgb(c);
    }

    /** Returns a spot with a hard edge at the angle, and the axis cosine to the power of the dropoff. */
    private List<String> spot(Light light) {
        if (light.angle() == 180 && light.dropoff() == 0 && light.doors().isOpen() && light.gobo().isEmpty()) {
            return List.of();
        }
        if (light.angle() >= 90) {
            warnings.add("light " + light.name() + ": its cone is limited to 90 degrees");
        }
        double angle = Math.min(light.angle(), 90);
        Vec3 target = light.position().plus(light.direction().normalized().times(bounds.radius()));
        return List.of("spotlight point_at " + PovFormat.vector(target),
                "radius " + angle + " falloff " + angle + " tightness " + light.dropoff());
    }

    /** Returns a half space with cosine falloff. */
    private List<String> surface(Light light) {
        Vec3 target = light.position().plus(light.direction().normalized().times(bounds.radius()));
        return List.of("spotlight point_at " + PovFormat.vector(target), "radius " + light.beam().cone() + " falloff " + light.beam().cone()
                + " tightness " + (1 + light.dropoff()));
    }

    /**
     * Returns an area light. POV-Ray has a grid on a rectangle, whole or cut to an ellipse; a sphere light is a disc that
     * faces the shaded point.
     */
    private List<String> area(Light light) {
        if (!light.isArea()) {
            return List.of();
        }
        Vec3 axis = light.direction().normalized();
        Vec3 right = light.area().right(axis);
        Vec3 up = right.cross(axis);
        boolean rect = light.type() == LightType.RECT;
        double far = DIRECTIONAL_DISTANCE * bounds.radius();
        double radius = light.type().hasPosition() ? light.area().radius()
                : far * Transform.sinDegrees(light.area().spread()) / Math.max(Transform.cosDegrees(light.area().spread()), 0.01);
        boolean tube = light.type() == LightType.TUBE;
        double width = rect ? light.area().width() : 2 * radius;
        double height = rect || tube ? light.area().height() : 2 * radius;
        if (tube) {
            warnings.add("light " + light.name() + ": its tube is exported as a rectangle that shines evenly in all directions");
            up = axis;
        }
        // If one side is longer than half the number of samples, no grid fits.
        int gridSize = Math.max(2, (int) Math.round(Math.sqrt(light.area().samples())));
        warnings.add("light " + light.name() + ": POV-Ray's area light has a grid of " + gridSize + " × " + gridSize
                + " samples; falloff and highlights use its center");
        String shape = switch (light.type()) {
            case RECT, TUBE -> "";
            case DISC, DIRECTIONAL -> " circular";
            case POINT, SPOT, OBJECT -> " circular orient";
        };
        // The outermost samples lie at the ends of the vectors, and jitter moves each by up to half their spacing.
        double inset = (gridSize - 1.0) / gridSize;
        return List.of(
                "area_light " + PovFormat.vector(right.times(inset * width)) + ", " + PovFormat.vector(up.times(inset * height)) + ", "
                        + gridSize + ", "
                        + gridSize + shape + " jitter adaptive 2");
    }
}
