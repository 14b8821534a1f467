package lightning.format.exchange;

import java.util.OptionalDouble;
import lightning.base.math.Rgb;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.gltf.GltfLight;
import lightning.format.mesh.ConversionNotes;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import tools.jackson.databind.JsonNode;

/** Converter from a light to KHR_lights_punctual. */
final class PunctualLightExport {
    /** Largest ratio of the inner to the outer angle, which glTF requires to be larger. */
    private static final double MAX_INNER_RATIO = 1 - 1e-6;

    /** Smallest outer angle in radians, which glTF requires to be above the inner one. */
    private static final double MIN_OUTER = 1e-4;

    private PunctualLightExport() {}

    /**
     * Returns the closest glTF light.
     *
     * @param light effective light, without a light group
     * @param settings settings to store in the extras, read by this program only
     * @param notes receives properties that are not exported exactly
     */
    static GltfLight convert(Light light, LightUnits units, JsonNode settings, ConversionNotes notes) {
        LightType type = light.type();
        double scale = Math.max(light.color().max(), 1);
        Rgb color = light.color().times(1 / scale);
        double intensity = scale * light.intensity() * attenuationFactor(light, notes) / units.intensityOfOneUnit(type);
        double outer = Math.max(Math.toRadians(type.isSurface() ? light.beam().outerAngle() : Math.min(light.angle(), 90)), MIN_OUTER);
        OptionalDouble inner = type.hasCone() ? SpotEdges.inner(light) : OptionalDouble.empty();
        notes.add("area lights, exported as points", light.isArea() ? 1 : 0);
        notes.add("spots wider than 90 degrees", type.hasCone() && light.angle() > 90 ? 1 : 0);
        notes.add("edges of spots, falloff approximated", type.hasCone() && light.dropoff() > 0 || type.isSurface() ? 1 : 0);
        double dropoff = type.isSurface() ? 1 + light.dropoff() : light.dropoff();
        notes.add("faces of visible lights",
                light.isArea() && LightAttribute.VISIBLE.appliesTo(type) && LightAttribute.VISIBLE.get(light) ? 1 : 0);
        notes.add("barn doors", LightAttribute.DOORS.appliesTo(type) && !light.doors().isOpen() ? 1 : 0);
        notes.add("flags of lights", light.flag().on() ? 1 : 0);
        notes.add("light filters", light.filter().isActive() ? 1 : 0);
        notes.add("gobos", LightAttribute.GOBO.appliesTo(type) && light.gobo().isPresent() ? 1 : 0);
        notes.add("textures of lights", light.faceImage().isPresent() ? 1 : 0);
        notes.add("profiles", LightAttribute.PROFILE.appliesTo(type) && light.profile().isPresent() && inner.isEmpty() ? 1 : 0);
        notes.add("light linking, exported as illuminating everything", light.isLinked() ? 1 : 0);
        notes.add("lights without shadows", light.influence().castsShadows() ? 0 : 1);
        notes.add("diffuse and specular gains of lights",
                light.influence().diffuse() != 1 || light.influence().specular() != 1 ? 1 : 0);
        GltfLight.Type gltfType = switch (type) {
            case DIRECTIONAL -> GltfLight.Type.DIRECTIONAL;
            case POINT -> GltfLight.Type.POINT;
            case SPOT, RECT, DISC -> GltfLight.Type.SPOT;
            case TUBE, OBJECT -> GltfLight.Type.POINT;
        };
        return new GltfLight(0, light.name(), gltfType, color, intensity,
                inner.isPresent() ? Math.toRadians(inner.getAsDouble()) : innerAngle(dropoff, outer), outer, false, settings);
    }

    /** Returns the light's intensity factor at distance 1, because glTF lights fall off with the square of the distance. */
    private static double attenuationFactor(Light light, ConversionNotes notes) {
        if (!light.type().hasPosition()) {
            return 1;
        }
        var a = light.distanceTerms();
        notes.add("lights without inverse-square falloff, exact only at distance 1", a.constant() == 0
                && a.linear() == 0 && a.quadratic() > 0 ? 0 : 1);
        double sum = a.constant() + a.linear() + a.quadratic();
        return a.constant() == 0 && a.linear() == 0 && sum > 0 ? 1 / sum : Math.min(1 / sum, 1);
    }

    /** Returns the inner angle at which a spot has half intensity at the same angle as here; see {@code GltfImport}. */
    private static double innerAngle(double dropoff, double outer) {
        double cosHalf = dropoff == 0 ? Math.cos(outer) : Math.pow(0.5, 1 / dropoff);
        double cosOuter = Math.cos(outer);
        return cosHalf <= cosOuter ? outer * MAX_INNER_RATIO : Math.acos(Math.min(1, cosOuter + (cosHalf - cosOuter) / Math.sqrt(0.5)));
    }
}
