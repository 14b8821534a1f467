package lightning.scene.value;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.function.Supplier;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.DecimalNumber;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.OverflowCheck;
import lightning.scene.light.Light;
import lightning.scene.material.Material;

/**
 * Limits of all values in a scene.
 *
 * <p>They are wide enough for any image, and narrow enough that no product in the lighting equation overflows a float. A light's weight is
 * at most 1e3·1e30 = 1e33, including its group, exposure, unit and gains ({@link Light#limitedGain}), and divided by its largest falloff if that is above 1. Terms are at most 1, so a thousand lights sum to 1e36 ({@link #MAX_TOTAL_LIGHT}). Material
 * factors are at most 1. Ten mirrors add at most eleven such sums, each of a diffuse, a specular and a grazing one: 3.3e37. Emitted light
 * adds at most 1e6·1e6 + 1e6 per surface, less than a rounding error of this sum. Terms of metallic materials can reach 6.1e7; for such
 * scenes {@link OverflowCheck} limits the sum over the lights to the same bound.
 */
public final class SceneLimits {
    private static final MathContext DISPLAY_PRECISION = new MathContext(4);

    public static final int MAX_SIZE = 16384;
    public static final int MAX_DEPTH = 10;
    public static final int MIN_SAMPLES = 2;
    public static final int MAX_SAMPLES = 8;
    public static final int MAX_LIGHTS = 1000;
    public static final int MAX_LIGHT_GROUPS = 1000;
    public static final int MAX_DOMES = 16;
    public static final int MAX_CAMERAS = 1000;
    /** Number of shapes and groups in one link of a light. */
    public static final int MAX_LINKS = 1000;
    public static final int MAX_SHAPES = 1_000_000;
    public static final int MAX_MATERIALS = 32_000;
    public static final int MAX_NESTING = 32;
    /** Positions, in scene units, either sign. */
    public static final double MAX_COORDINATE = 1e12;
    /** Absolute scale factors of a shape or a group. */
    public static final double MIN_SCALE = 1e-9;
    public static final double MAX_SCALE = 1e9;
    /** Radius of a frustum's top, relative to its base. */
    public static final double MAX_TOP = 1e6;
    /** Ambient color, glow and background, per channel. */
    public static final double MAX_EMISSION = 1e6;
    public static final double MAX_AMBIENCE = 1e6;
    public static final double MAX_LIGHT_COLOR = 1e3;
    public static final double MAX_INTENSITY = 1e30;
    /** Intensity of an environment light: so far below {@link #MAX_TOTAL_LIGHT} that no environment is too bright for any material. */
    public static final double MAX_ENVIRONMENT_LIGHT_INTENSITY = 1e22;
    /** Sum of the weights of all lights times the largest term of any material. */
    public static final double MAX_TOTAL_LIGHT = 1e36;
    public static final double MAX_GROUP_INTENSITY = 1e3;
    /** Gains of a light: diffuse, specular, and on single objects. */
    public static final double MAX_GAIN = 100;
    /** Meters per scene unit. */
    public static final double MIN_METERS = 1e-9;
    public static final double MAX_METERS = 1e9;
    public static final double MAX_ATTENUATION = 1e30;
    public static final double MAX_ANGLE = 180;
    /** Extinction of fog and its decrease with height, per scene unit. */
    public static final double MAX_FOG_DENSITY = 1e9;
    /** Mean cosine of scattering in fog, either sign. */
    public static final double MAX_ANISOTROPY = 0.9;
    public static final double MAX_FEATHER = 90;
    public static final double MAX_DROPOFF = 1e6;
    /** Radius, width and height of a light. */
    public static final double MAX_EXTENT = 1e9;
    public static final double MAX_SPREAD = 90;
    /** Smallest half-angle of the beam of a rectangle or disc, in degrees. */
    public static final double MIN_BEAM_SPREAD = 1;
    public static final int MIN_LIGHT_SAMPLES = 4;
    public static final int MAX_LIGHT_SAMPLES = 64;
    public static final double MAX_SHININESS = 1e6;
    public static final double MIN_FOV = 0.01;
    public static final double MAX_FOV = 170;
    /** Largest lens shift, in pictures. */
    public static final double MAX_SHIFT = 10;
    public static final double MAX_REPEAT = 1e6;
    public static final double MAX_HEIGHT = 1e9;
    public static final double MAX_STRENGTH = 1e6;
    public static final double MAX_ROTATION = 1e6;
    public static final double MAX_IOR = 4;
    public static final double MIN_TINT_DISTANCE = 1e-9;
    public static final double MAX_TINT_DISTANCE = 1e9;

    public static final int MAX_NAME = 100;

    private SceneLimits() {}

    /**
     * Returns {@code value} if it is within the bounds.
     *
     * @throws RefusalException if it is NaN or outside; the message says which
     */
    public static double checkRange(String name, double value, double min, double max) {
        if (isWithin(value, min, max)) {
            return value;
        }
        String expected = min == 0 && value < 0 ? "must be ≥ 0" : "must be from " + format(min) + " to " + format(max);
        throw new RefusalException(name + " " + expected + ", was " + format(value));
    }

    public static int checkRange(String name, int value, int min, int max) {
        return (int) checkRange(name, (double) value, min, max);
    }

    public static Vec3 checkRange(String name, Vec3 v, double min, double max) {
        // Builds names only for an error: a scene may have a million positions.
        if (!(isWithin(v.x(), min, max) && isWithin(v.y(), min, max) && isWithin(v.z(), min, max))) {
            checkRange(name + " x", v.x(), min, max);
            checkRange(name + " y", v.y(), min, max);
            checkRange(name + " z", v.z(), min, max);
        }
        return v;
    }

    private static boolean isWithin(double v, double min, double max) {
        return v >= min && v <= max;
    }

    public static Rgb checkRange(String name, Rgb c, double max) {
        checkRange(name + " red", c.r(), 0, max);
        checkRange(name + " green", c.g(), 0, max);
        checkRange(name + " blue", c.b(), 0, max);
        return c;
    }

    public static Vec3 checkPosition(String name, Vec3 p) {
        return checkRange(name, p, -MAX_COORDINATE, MAX_COORDINATE);
    }

    /** Checks a direction: within the coordinate range, and long enough to be normalized. */
    public static Vec3 checkDirection(String name, Vec3 d) {
        checkPosition(name, d);
        if (!(d.maxAbs() >= 1e-12)) {
            throw new RefusalException(name + " must not be zero, was "
                    + format(d.x()) + " " + format(d.y()) + " " + format(d.z()));
        }
        return d;
    }

    /**
     * Checks that the scale of a shape times that of all enclosing groups is within the range of a single placement, so that its transform
     * can be inverted at any depth.
     *
     * @param name the shape's or group's name in messages
     * @param min  product of the smallest absolute factors
     * @param max  product of the largest absolute factors
     */
    public static void checkCombinedScale(Supplier<String> name, double min, double max) {
        if (min < MIN_SCALE || max > MAX_SCALE) {
            throw new RefusalException(name.get() + ": scale times that of its groups must be from " + format(MIN_SCALE) + " to "
                    + format(MAX_SCALE) + ", was " + format(min < MIN_SCALE ? min : max));
        }
    }

    /**
     * Checks a name: 1 to 100 printable code points, with neither a space nor a joiner at its ends. Names are equal if all their code
     * points are.
     */
    public static String checkName(String name) {
        if (name.isEmpty() || name.codePointCount(0, name.length()) > MAX_NAME || !PrintableText.isPrintable(name)
                || isBlank(name.codePointAt(0)) || isBlank(name.codePointBefore(name.length()))) {
            throw new RefusalException("a name must have 1 to " + MAX_NAME + " characters, no control characters and no spaces "
                    + "at its ends, was " + Quote.of(name));
        }
        return name;
    }

    private static boolean isBlank(int c) {
        return Character.getType(c) == Character.SPACE_SEPARATOR || Character.getType(c) == Character.FORMAT;
    }

    /** Formats a number as in a scene file; zero has no sign here. */
    public static String format(double v) {
        return DecimalNumber.format(v == 0 ? 0 : v);
    }

    /** Formats a number for the user with four digits, enough to recognize it. */
    public static String formatShort(double v) {
        return format(new BigDecimal(v).round(DISPLAY_PRECISION).doubleValue());
    }
}
