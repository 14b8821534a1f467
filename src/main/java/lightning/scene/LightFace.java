package lightning.scene;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureWrap;
import lightning.scene.light.AreaShape;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/**
 * Surface of a visible area light, as rays of the camera meet it: a shape with the light's name that glows, casts no shadows and reflects
 * nothing. It is no part of the document.
 *
 * @param shape    one-sided plane of a rectangle or disc, ball of a point or spot light, or cylinder of a tube
 * @param material its material, with a name that no material of the document has
 */
record LightFace(Shape shape, Material material) {
    /** Prefix of a material's name; the light's name follows as far as names may be long. */
    private static final String PREFIX = "light ";
    private static final int MAX_STEM = SceneLimits.MAX_NAME - 20;

    /**
     * Returns the faces of a rig's visible lights, in the order of the lights. A stage with the maximum number of shapes or materials has
     * room for no more.
     */
    static List<LightFace> of(LightRig rig, int shapeCount, Set<String> materials) {
        List<LightFace> faces = null;
        Set<String> names = null;
        for (Light light : rig.lights()) {
            int room = Math.min(SceneLimits.MAX_SHAPES - shapeCount, SceneLimits.MAX_MATERIALS - materials.size());
            if (isVisible(light) && (faces == null ? 0 : faces.size()) < room) {
                faces = faces == null ? new ArrayList<>() : faces;
                names = names == null ? new HashSet<>(materials) : names;
                Material material = material(light, rig, names);
                faces.add(new LightFace(shape(light, material.name()), material));
            }
        }
        return faces == null ? List.of() : List.copyOf(faces);
    }

    private static boolean isVisible(Light light) {
        AreaShape area = light.area();
        return area.visibility() != FaceVisibility.HIDDEN && switch (light.type()) {
            case DIRECTIONAL, OBJECT -> false;
            case RECT -> area.width() >= SceneLimits.MIN_SCALE && area.height() >= SceneLimits.MIN_SCALE;
            case POINT, SPOT, DISC -> area.radius() >= SceneLimits.MIN_SCALE;
            case TUBE -> area.radius() >= SceneLimits.MIN_SCALE && area.height() >= SceneLimits.MIN_SCALE;
        };
    }

    private static Shape shape(Light light, String material) {
        AreaShape area = light.area();
        return switch (light.type()) {
            case RECT -> plane(light, area.right(light.direction().normalized()), area.width(), area.height(), material);
            case DISC ->
                    plane(light, area.right(light.direction().normalized()), 2 * area.radius(), 2 * area.radius(), material);
            case TUBE -> {
                Vec3 axis = light.direction().normalized();
                double height = Math.min(area.height(), SceneLimits.MAX_SCALE);
                double radius = Math.min(area.radius(), SceneLimits.MAX_SCALE);
                yield new Shape(Solid.CYLINDER, light.name(), material, new Placement(light.position().minus(axis.times(height / 2)),
                        rotation(AreaShape.DEFAULT.right(axis), axis), new Vec3(radius, height, radius)));
            }
            case POINT, SPOT, DIRECTIONAL, OBJECT -> new Shape(Solid.SPHERE, light.name(), material,
                    new Placement(light.position(), Vec3.ZERO, Vec3.ONE.times(area.radius())));
        };
    }

    /** Returns a plane whose upper side faces the light's direction. */
    private static Shape plane(Light light, Vec3 right, double width, double height, String material) {
        return new Shape(Solid.PLANE, light.name(), material,
                new Placement(light.position(), rotation(right, light.direction().normalized()),
                        new Vec3(Math.min(width, SceneLimits.MAX_SCALE), 1, Math.min(height, SceneLimits.MAX_SCALE))));
    }

    /**
     * Returns the angles about x, y and z, in degrees, of the rotation that maps the axis x to {@code x} and the axis y to {@code y}.
     *
     * @param x unit vector
     * @param y unit vector perpendicular to it
     */
    static Vec3 rotation(Vec3 x, Vec3 y) {
        Vec3 z = x.cross(y);
        double cosine = StrictMath.hypot(y.z(), z.z());
        double aroundY = StrictMath.atan2(-x.z(), cosine);
        // Without a cosine, only the sum or difference of the two other angles is defined.
        boolean isLocked = cosine < 1e-9;
        double aroundX = isLocked ? StrictMath.atan2(-z.y(), y.y()) : StrictMath.atan2(y.z(), z.z());
        double aroundZ = isLocked ? 0 : StrictMath.atan2(x.y(), x.x());
        return new Vec3(StrictMath.toDegrees(aroundX), StrictMath.toDegrees(aroundY), StrictMath.toDegrees(aroundZ));
    }

    private static Material material(Light light, LightRig rig, Set<String> names) {
        Material black = Material.of(uniqueName(light.name(), names)).withAmbient(Rgb.BLACK).withDiffuse(Rgb.BLACK)
                .withSpecular(Rgb.BLACK).withTransmission(Transmission.NONE.withShadows(ShadowCasting.NONE))
                .withCutout(AlphaCutout.NONE.withClip(switch (light.type()) {
                    case RECT -> AlphaCutout.Clip.BACK;
                    case DISC -> AlphaCutout.Clip.BACK_AND_CORNERS;
                    case POINT, SPOT, DIRECTIONAL, TUBE, OBJECT -> AlphaCutout.Clip.NONE;
                }));
        if (light.area().visibility() != FaceVisibility.GLOWING) {
            return black;
        }
        // A view without soft shadows does not change the face.
        Light soft = light.withArea(light.area().withHardShadows(false));
        double factor = rig.radianceFactor(soft);
        // A dark light keeps its texture, so that switching it on looks up no texel.
        double brightest = soft.faceImage().map(image -> Math.max(1.0, image.areas().max())).orElse(1.0);
        Material face = soft.faceImage().isEmpty() ? black : black.withGlowMap(glowMap(light));
        return face.withBulb(Bulb.NONE.litBy(soft, rig, factor, SceneLimits.MAX_EMISSION / brightest));
    }

    /** Returns the light's image on its plane, upright and not mirrored for a viewer, who looks against the light's direction. */
    private static Optional<TextureMap> glowMap(Light light) {
        return light.texture().map(t -> new TextureMap(t.file(), -1, 1, t.image(), TextureWrap.CLAMP));
    }

    /** Returns a name that is not among the given ones, the same for the same light if possible, and adds it to them. */
    private static String uniqueName(String light, Set<String> names) {
        int end = light.offsetByCodePoints(0, Math.min(light.codePointCount(0, light.length()), MAX_STEM));
        String stem = PREFIX + light.substring(0, end).strip();
        String name = stem;
        for (int n = 2; !names.add(name); n++) {
            name = stem + " " + n;
        }
        return name;
    }
}
