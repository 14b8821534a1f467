package lightning.render.shading;

import lightning.base.math.Vec3;
import lightning.render.fog.FogMedium;
import lightning.render.trace.HitRows;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.Texture;
import lightning.scene.light.Beam;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.Photometry;
import org.jspecify.annotations.Nullable;

/**
 * Mask of a light: the product of its barn doors, beam, gobo and photometric profile in a direction, and of what its flag, its filter and fog let
 * through to a point. It multiplies the falloff.
 *
 * <p>The light looks along its axis, with y upwards. A point has an angle to the right and one to the top, each measured in the
 * plane of the axis and that side.
 *
 * <p>A door at angle θ passes 1 up to θ minus the feather, and 0 beyond θ. Between them it passes t²(3 − 2t), where t is the angle
 * inside θ over the feather. Without a feather, a point on the edge is lit. The factors of the four doors are multiplied.
 *
 * <p>A gobo is a square that just contains the cone, or a cone of 89 degrees if the light's is wider. The
 * cone of a rectangle or disc is {@link Beam#outerAngle}. Seen from the light, its left
 * is left and its top is up. It is sampled bilinearly between pixel centers and clamped beyond them. It passes its luminance,
 * 0.2126 R + 0.7152 G + 0.0722 B of linear light (ITU-R BT.709). For a light that looks straight up or down, z is upwards.
 *
 * <p>A rectangle or disc is oriented by its {@code up}. The mask acts at each of its samples by the same angles, like the slats of a
 * honeycomb grid, so that the edges of doors, gobo, cone and profile fade over the width of the face.
 *
 * <p>A profile is a function of two angles. Type C measures from the axis and around it, counterclockwise from the right as the
 * light looks out, so that 90 is its top; on the axis the second angle is 0. Type A has vertical planes: one angle is from the axis
 * to the right, the other upwards in that plane. Type B planes share the left-to-right axis: one angle is upwards, the other to the
 * right in that plane. The axis of a point light is −y.
 */
public final class AngularMask {
    /** If axis × y is shorter than this, the light looks straight up or down. */
    private static final double MIN_SIDE_LENGTH = 1e-6;
    /** Largest cone half-angle that a gobo covers, in degrees. */
    private static final double MAX_GOBO_ANGLE = 89;
    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private final Vec3 position;
    private final Vec3 axis;
    private final Vec3 right;
    private final Vec3 up;
    private final BarnDoors doors;
    private final double feather;
    private final @Nullable Beam beam;
    private final @Nullable Texture gobo;
    private final @Nullable Photometry photometry;
    /** Half the gobo's side at distance 1 along the axis. */
    private final double goboHalfSize;
    private final float[] color = new float[3];
    private final @Nullable FogMedium fog;
    private final @Nullable FilterMask filter;
    private final boolean isDirectional;
    private final boolean isTube;
    private final boolean isObject;
    private final boolean bothSides;

    private AngularMask(LightSource source) {
        position = source.position();
        fog = source.fog();
        isDirectional = source.type() == LightType.DIRECTIONAL;
        isTube = source.type() == LightType.TUBE;
        isObject = source.type() == LightType.OBJECT;
        bothSides = source.cosAngle() < 0;
        filter = FilterMask.of(source.light(), source.origin(), isDirectional);
        boolean isSurface = source.type().isSurface();
        boolean hasDoors = LightAttribute.DOORS.appliesTo(source.type());
        axis = hasDoors || isTube || isObject ? source.axis() : DOWN;
        right = isSurface ? source.light().area().right(axis) : right(axis);
        up = right.cross(axis);
        doors = hasDoors ? source.light().doors() : BarnDoors.OPEN;
        feather = source.light().feather();
        gobo = hasDoors ? source.light().gobo().map(Gobo::image).orElse(null) : null;
        photometry =
                LightAttribute.PROFILE.appliesTo(source.type()) ? source.light().profile().map(IesProfile::photometry).orElse(null) : null;
        beam = isSurface && !source.light().beam().isOpen() ? source.light().beam() : null;
        goboHalfSize = StrictMath.tan(Math.toRadians(
                Math.min(isSurface ? source.light().beam().outerAngle() : source.light().angle(), MAX_GOBO_ANGLE)));
    }

    private static Vec3 right(Vec3 axis) {
        Vec3 side = axis.cross(Vec3.Y);
        return (side.length() < MIN_SIDE_LENGTH ? axis.cross(new Vec3(0, 0, 1)) : side).normalized();
    }

    /** Returns whether the light has a mask. */
    public static boolean isActive(LightSource source) {
        return source.fog() != null || FilterMask.isActive(source.light()) || switch (source.type()) {
            case SPOT -> isShaped(source.light());
            case POINT -> source.light().profile().isPresent();
            case RECT, DISC -> isShaped(source.light()) || !source.light().beam().isOpen();
            case DIRECTIONAL -> false;
            case TUBE -> true;
            case OBJECT -> source.light().isArea();
        };
    }

    private static boolean isShaped(Light light) {
        return !light.doors().isOpen() || light.gobo().isPresent() || light.profile().isPresent();
    }

    /** Returns the mask of a light, or null if it has none. */
    public static @Nullable AngularMask of(LightSource source) {
        return isActive(source) ? new AngularMask(source) : null;
    }

    /** Returns the factor at a point in render space, 0…1. */
    public double factor(float px, float py, float pz) {
        return factor(px, py, pz, position.x(), position.y(), position.z());
    }

    /** Returns the factor at a point for a sample of the light at {@code sx}, {@code sy}, {@code sz}, 0…1. */
    public double factor(float px, float py, float pz, double sx, double sy, double sz) {
        return transmitted(px, py, pz, sx, sy, sz) * (isDirectional ? 1
                : isObject ? lambert(px - sx, py - sy, pz - sz, axis.x(), axis.y(), axis.z(), bothSides)
                : angularFactor(px - sx, py - sy, pz - sz));
    }

    /** Returns the factor at a point for sample {@code i} of the light, 0…1. */
    public double factor(float px, float py, float pz, AreaSamples samples, int i) {
        SampleNormals normals = samples.normals();
        double sx = samples.x[i];
        double sy = samples.y[i];
        double sz = samples.z[i];
        return normals == null ? factor(px, py, pz, sx, sy, sz) : transmitted(px, py, pz, sx, sy, sz)
                * lambert(px - sx, py - sy, pz - sz, normals.x()[i], normals.y()[i], normals.z()[i], normals.bothSides()[i]);
    }

    /** Returns the cosine of the angle of a vector of any length from a unit vector: its absolute value for both sides, or at least 0. */
    private static double lambert(double x, double y, double z, double nx, double ny, double nz, boolean both) {
        double length = Math.sqrt(x * x + y * y + z * z);
        double cosine = length > 0 ? SampleNormals.height(x, y, z, nx, ny, nz) / length : 1;
        return Math.min(both ? Math.abs(cosine) : Math.max(0, cosine), 1);
    }

    /** Returns the share of the light of a sample that filters and fog let through to a point. */
    private double transmitted(float px, float py, float pz, double sx, double sy, double sz) {
        double transmitted = (fog == null ? 1 : transmittance(fog, px, py, pz, sx, sy, sz))
                * (filter == null ? 1 : filter.factor(px, py, pz, sx, sy, sz));
        return transmitted;
    }

    /** Returns the share of the light that reaches a point through fog. */
    private double transmittance(FogMedium medium, double px, double py, double pz, double sx, double sy, double sz) {
        if (isDirectional) {
            return FogMedium.transmittance(medium.depth(px, py, pz, sx, sy, sz, Double.POSITIVE_INFINITY));
        }
        double x = sx - px;
        double y = sy - py;
        double z = sz - pz;
        double distance = Math.sqrt(x * x + y * y + z * z);
        return distance < LightingEquation.MIN_DISTANCE ? 1
                : FogMedium.transmittance(medium.depth(px, py, pz, x / distance, y / distance, z / distance, distance));
    }

    /** Returns the factor in the direction from the light, a vector of any length. */
    private double angularFactor(double x, double y, double z) {
        double forward = x * axis.x() + y * axis.y() + z * axis.z();
        double side = x * right.x() + y * right.y() + z * right.z();
        double height = x * up.x() + y * up.y() + z * up.z();
        if (isTube) {
            // Each part of the side shines by Lambert's law, and a thin tube is seen as wide as the sine of the angle from its axis.
            double across = Math.sqrt(side * side + height * height);
            double distance = Math.sqrt(across * across + forward * forward);
            return distance > 0 ? across / distance : 1;
        }
        return doorFactor(-side, forward, doors.left()) * doorFactor(side, forward, doors.right())
                * doorFactor(-height, forward, doors.bottom()) * doorFactor(height, forward, doors.top())
                * (beam == null ? 1 : beam.factor(Math.sqrt(side * side + height * height), forward))
                * (gobo == null ? 1 : goboFactor(side, height, forward * goboHalfSize))
                * (photometry == null ? 1 : profileFactor(side, height, forward));
    }

    /** Returns the gobo's factor; {@code extent} is half its side at the point's distance. */
    private double goboFactor(double side, double height, double extent) {
        // A cone without an opening passes all light through the middle of the gobo.
        assert gobo != null;
        boolean middle = !(extent > 0);
        double x = middle ? 0.5 * gobo.width() : (1 + side / extent) / 2 * gobo.width();
        double y = middle ? 0.5 * gobo.height() : (1 - height / extent) / 2 * gobo.height();
        double column = Math.clamp(x - 0.5, 0, gobo.width() - 1.0);
        double row = Math.clamp(y - 0.5, 0, gobo.height() - 1.0);
        int x0 = (int) column;
        int y0 = (int) row;
        gobo.interpolate(x0, y0, Math.min(x0 + 1, gobo.width() - 1), Math.min(y0 + 1, gobo.height() - 1), column - x0, row - y0, color);
        return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    }

    private double profileFactor(double side, double height, double forward) {
        assert photometry != null;
        return switch (photometry.type()) {
            case C -> {
                double around = degrees(height, side);
                yield photometry.sample(degrees(Math.sqrt(side * side + height * height), forward), around < 0 ? around + 360 : around);
            }
            case B -> photometry.sample(degrees(height, forward), degrees(side, Math.sqrt(forward * forward + height * height)));
            case A -> photometry.sample(degrees(height, Math.sqrt(side * side + forward * forward)), degrees(side, forward));
        };
    }

    /** Returns an angle in degrees. Uses StrictMath for the same result on every machine. */
    private static double degrees(double y, double x) {
        return Math.toDegrees(StrictMath.atan2(y, x));
    }

    /** Returns the factor of one door for a point {@code across} to its side and {@code forward} along the axis. */
    private double doorFactor(double across, double forward, double door) {
        if (door == BarnDoors.OPEN_ANGLE) {
            return 1;
        }
        double inside = door - degrees(across, forward);
        if (feather == 0) {
            return inside >= 0 ? 1 : 0;
        }
        double t = Math.clamp(inside / feather, 0, 1);
        return t * t * (3 - 2 * t);
    }

    /** Multiplies the factors of all rows of a tile. */
    public void multiply(HitRows rows, double[] factors) {
        for (int i = 0; i < rows.count; i++) {
            factors[i] *= factor(rows.px[i], rows.py[i], rows.pz[i]);
        }
    }
}
