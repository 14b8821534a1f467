package lightning.base.math;

/** Linear color or triple of color factors; the range depends on its use. */
public record Rgb(double r, double g, double b) {
    public static final Rgb BLACK = new Rgb(0, 0, 0);
    public static final Rgb WHITE = new Rgb(1, 1, 1);

    /** Returns the gray with all three channels at {@code v}. */
    public static Rgb gray(double v) {
        return new Rgb(v, v, v);
    }

    public Rgb times(double s) {
        return new Rgb(r * s, g * s, b * s);
    }

    /** Returns the product per channel. */
    public Rgb times(Rgb c) {
        return new Rgb(r * c.r, g * c.g, b * c.b);
    }

    /** Returns the sum per channel. */
    public Rgb plus(Rgb c) {
        return new Rgb(r + c.r, g + c.g, b + c.b);
    }

    public boolean isBlack() {
        return r == 0 && g == 0 && b == 0;
    }

    /** Returns the luminance 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). */
    public double luminance() {
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    }

    /** The smallest channel; NaN if any is NaN. */
    public double min() {
        return Math.min(Math.min(r, g), b);
    }

    /** The largest channel; NaN if any is NaN. */
    public double max() {
        return Math.max(Math.max(r, g), b);
    }
}
