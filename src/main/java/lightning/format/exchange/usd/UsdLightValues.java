package lightning.format.exchange.usd;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.usd.UsdLayer;
import lightning.scene.light.AreaShape;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.ColorTemperature;

/**
 * Attributes of UsdLux by their declarations, of one light: the inverse of {@link UsdLightImport}.
 *
 * @param type type of the prim
 * @param scale lengths of the axes of its transform, which scale its size
 */
public record UsdLightValues(String type, Light light, double meters, boolean hasZUp, Vec3 scale) {
    public static final String MATRIX = "matrix4d xformOp:transform:lightning";
    /** Name for the type of a mesh whose surface is a light. */
    public static final String MESH = "MeshLight";
    static final String INTENSITY = "float inputs:intensity";
    static final String NORMALIZE = "bool inputs:normalize";
    static final String ANGLE = "float inputs:shaping:cone:angle";
    static final String FOCUS = "float inputs:shaping:focus";
    static final String SOFTNESS = "float inputs:shaping:cone:softness";
    static final String VISIBILITY = "token visibility";
    static final String VISIBLE = "\"inherited\"";
    static final String INVISIBLE = "\"invisible\"";
    static final String POINT = "bool treatAsPoint";
    static final String LINE = "bool treatAsLine";
    /** Values of a cone that holds nothing back. */
    static final Map<String, String> OPEN_CONE = Map.of(ANGLE, "180", SOFTNESS, "0", FOCUS, "0");
    static final Vec3 DOWN = new Vec3(0, -1, 0);
    private static final double SPHERE_FACTOR = 4;
    private static final double FULL_ANGLE = 180;

    /** Creates the values of a light whose transform does not scale. */
    public UsdLightValues(String type, Light light, double meters, boolean hasZUp) {
        this(type, light, meters, hasZUp, new Vec3(1, 1, 1));
    }

    /** Returns the type of prim for a light, that of the original where it can be the same. */
    public static String typeOf(Light light, String original) {
        return switch (light.type()) {
            case DIRECTIONAL -> "DistantLight";
            case POINT -> original.equals("CylinderLight") ? original : "SphereLight";
            case SPOT -> original.equals("DiskLight") && light.dropoff() >= 1 ? original : "SphereLight";
            case RECT -> "RectLight";
            case DISC -> "DiskLight";
            case TUBE -> "CylinderLight";
            case OBJECT -> MESH;
        };
    }

    /** Returns whether a prim of a type can have a cone and a profile. */
    public static boolean isShaped(String type) {
        return type.equals("SphereLight") || type.equals("DiskLight") || type.equals("RectLight");
    }

    /** Returns the values of all attributes that a type has. */
    public Map<String, String> values(boolean isOn) {
        Map<String, String> result = new LinkedHashMap<>();
        boolean isTinted = light.emission().temperature() != ColorTemperature.NEUTRAL;
        Rgb color = isTinted ? usdColor() : light.color();
        result.put("color3f inputs:color",
                "(" + Stream.of(color.r(), color.g(), color.b()).map(UsdLayer::number).collect(Collectors.joining(", ")) + ")");
        boolean hasLuminance = light.emission().unit() == IntensityUnit.NIT && light.hasSamples();
        result.put(INTENSITY, UsdLayer.number(hasLuminance ? light.intensity() : power()));
        result.put("float inputs:exposure", UsdLayer.number(light.emission().exposure()));
        result.put(NORMALIZE, hasLuminance ? "0" : "1");
        result.put("bool inputs:enableColorTemperature", isTinted ? "1" : "0");
        result.put("float inputs:colorTemperature", UsdLayer.number(light.emission().temperature()));
        result.put("float inputs:diffuse", UsdLayer.number(light.influence().diffuse()));
        result.put("float inputs:specular", UsdLayer.number(light.influence().specular()));
        result.put("bool inputs:shadow:enable", light.influence().castsShadows() ? "1" : "0");
        result.put(VISIBILITY, isOn ? VISIBLE : INVISIBLE);
        if (!type.equals(MESH)) {
            addSize(result);
            result.put(MATRIX, matrix());
        }
        return result;
    }

    /** Returns the color with which UsdLux shows the same light at this temperature. */
    private Rgb usdColor() {
        double kelvin = light.emission().temperature();
        Rgb correction = UsdBlackbody.correction(kelvin, kelvin);
        return new Rgb(ratio(light.color().r(), correction.r()), ratio(light.color().g(), correction.g()),
                ratio(light.color().b(), correction.b()));
    }

    private static double ratio(double channel, double correction) {
        return correction > 0 ? channel / correction : channel;
    }

    private void addSize(Map<String, String> result) {
        switch (type) {
            case "DistantLight" -> result.put("float inputs:angle", UsdLayer.number(2 * light.area().spread()));
            case "RectLight" -> {
                result.put("float inputs:width", unscaled(light.area().width(), scale.x()));
                result.put("float inputs:height", unscaled(light.area().height(), scale.y()));
                addBeam(result);
            }
            case "CylinderLight" -> {
                if (light.type() == LightType.TUBE) {
                    result.put("float inputs:length", unscaled(light.area().height(), scale.x()));
                    if (light.area().radius() > 0) {
                        result.put("float inputs:radius", unscaled(light.area().radius(), LightScales.tube(scale)));
                    }
                    result.put(LINE, light.area().radius() == 0 ? "1" : "0");
                    return;
                }
                // The ball that stands for it has its area; a ball of another size scales both.
                double ball = Math.sqrt(light.area().width() * light.area().height() / 4);
                double size = ball > 0 && Math.abs(light.area().radius() - ball) > 1e-6 * ball ? light.area().radius() / ball : 1;
                result.put("float inputs:length", unscaled(light.area().width() * size, scale.x()));
                result.put("float inputs:radius", unscaled(light.area().height() / 2 * size, LightScales.tube(scale)));
            }
            default -> {
                result.put("float inputs:radius",
                        unscaled(light.area().radius(), type.equals("DiskLight") ? LightScales.disk(scale) : LightScales.sphere(scale)));
                if (light.type() == LightType.DISC) {
                    addBeam(result);
                    return;
                }
                boolean isSpot = light.type() == LightType.SPOT;
                if (type.equals("SphereLight")) {
                    result.put(POINT, light.area().radius() == 0 ? "1" : "0");
                }
                result.put(ANGLE, UsdLayer.number(isSpot ? light.angle() : FULL_ANGLE));
                result.put(SOFTNESS, UsdLayer.number(isSpot ? SoftCones.softness(light).orElse(0) : 0));
                result.put(FOCUS,
                        UsdLayer.number(!isSpot ? 0 : type.equals("DiskLight") ? light.dropoff() - 1 : light.dropoff()));
            }
        }
    }

    /** Adds the cone of a rectangle or disc. That of USD's fallback, 90 degrees, holds nothing back either. */
    private void addBeam(Map<String, String> result) {
        result.put(ANGLE, UsdLayer.number(light.beam().cone()));
        result.put(SOFTNESS, UsdLayer.number(light.beam().softness()));
        result.put(FOCUS, UsdLayer.number(light.dropoff()));
    }

    /** Returns a size before it is scaled. */
    private static String unscaled(double size, double factor) {
        return UsdLayer.number(factor > 0 ? size / factor : size);
    }

    /** Returns the normalized intensity: luminance times area, in square units of the stage. */
    double power() {
        double relative = light.emission().unit().relative(light, meters) * light.intensity();
        if (light.type().hasPosition()) {
            var terms = light.distanceTerms();
            relative *= 1 / (terms.constant() + terms.linear() + terms.quadratic());
        }
        if (light.type() == LightType.TUBE) {
            return Double.isFinite(relative) ? relative * Math.PI * Math.PI : 0;
        }
        boolean isRound = type.equals("SphereLight") || type.equals("CylinderLight");
        return Double.isFinite(relative) ? relative * Math.PI * (isRound ? SPHERE_FACTOR : 1) : 0;
    }

    private String matrix() {
        Vec3 direction = hangs(light) ? DOWN : light.direction().normalized();
        if (light.type() == LightType.TUBE) {
            return matrix(direction, AreaShape.DEFAULT.right(direction), light.position(), hasZUp);
        }
        return matrix(light.area().right(direction), direction.times(-1), light.type().hasPosition() ? light.position() : Vec3.ZERO,
                hasZUp);
    }

    /** Returns whether the profile of a light without direction points down. */
    static boolean hangs(Light light) {
        return light.type() == LightType.POINT && light.profile().isPresent();
    }

    /** Returns the transform from the scene to the axes of the stage. */
    static Transform tilt(boolean hasZUp) {
        return hasZUp ? Transform.rotation(new Vec3(90, 0, 0)) : Transform.IDENTITY;
    }

    /** Returns the text of a matrix with these x and z axes, unit vectors in the scene, and this place. */
    public static String matrix(Vec3 x, Vec3 z, Vec3 place, boolean hasZUp) {
        Transform tilt = tilt(hasZUp);
        return Stream.of(row(tilt.transformVector(x), 0), row(tilt.transformVector(z.cross(x)), 0), row(tilt.transformVector(z), 0),
                row(tilt.transformVector(place), 1)).collect(Collectors.joining(", ", "( ", " )"));
    }

    /** Returns the text of the matrix of a transform. */
    static String matrix(Transform m) {
        return Stream.of(row(m.transformVector(new Vec3(1, 0, 0)), 0), row(m.transformVector(Vec3.Y), 0),
                row(m.transformVector(new Vec3(0, 0, 1)), 0), row(m.transformPoint(Vec3.ZERO), 1))
                .collect(Collectors.joining(", ", "( ", " )"));
    }

    private static String row(Vec3 v, int last) {
        return "(" + Stream.of(v.x(), v.y(), v.z()).map(c -> String.valueOf(c + 0.0)).collect(Collectors.joining(", ")) + ", " + last + ")";
    }
}
