package lightning.base.math;

/** Conversion from CIE XYZ with the white D65 to linear sRGB (IEC 61966-2-1). Channels outside the gamut are below 0. */
public final class CieXyz {
    private CieXyz() {}

    public static double red(double x, double y, double z) {
        return 3.2406 * x - 1.5372 * y - 0.4986 * z;
    }

    public static double green(double x, double y, double z) {
        return -0.9689 * x + 1.8758 * y + 0.0415 * z;
    }

    public static double blue(double x, double y, double z) {
        return 0.0557 * x - 0.2040 * y + 1.0570 * z;
    }

    /** Returns the color, with 0 in place of channels below 0. */
    public static Rgb rgb(double x, double y, double z) {
        return new Rgb(Math.max(red(x, y, z), 0), Math.max(green(x, y, z), 0), Math.max(blue(x, y, z), 0));
    }
}
