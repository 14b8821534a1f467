package lightning.textures;

import lightning.base.math.Rgb;

/** Color mixing and shaping functions. */
final class PatternMath {

    private PatternMath() {}

    static Rgb hex(int rgb) {
        return new Rgb((rgb >> 16 & 0xFF) / 255.0, (rgb >> 8 & 0xFF) / 255.0, (rgb & 0xFF) / 255.0);
    }

    static Rgb mix(Rgb a, Rgb b, double share) {
        double t = Math.clamp(share, 0, 1);
        return new Rgb(a.r() + t * (b.r() - a.r()), a.g() + t * (b.g() - a.g()), a.b() + t * (b.b() - a.b()));
    }

    static Rgb add(Rgb a, Rgb b) {
        return new Rgb(a.r() + b.r(), a.g() + b.g(), a.b() + b.b());
    }

    /** Returns the color at a position 0…1 of equally spaced colors. */
    static Rgb gradient(double share, Rgb... colours) {
        double at = Math.clamp(share, 0, 1) * (colours.length - 1);
        int i = Math.min((int) at, colours.length - 2);
        return mix(colours[i], colours[i + 1], at - i);
    }

    /** Returns 0 below {@code from}, 1 above {@code to}, smooth between. */
    static double smoothstep(double from, double to, double x) {
        double t = Math.clamp((x - from) / (to - from), 0, 1);
        return t * t * (3 - 2 * t);
    }

    /** Returns 1 on a line at distance 0, falling smoothly to 0 at {@code halfWidth + soft}. */
    static double line(double distance, double halfWidth, double soft) {
        return 1 - smoothstep(halfWidth, halfWidth + soft, Math.abs(distance));
    }

    static double fraction(double x) {
        return x - Math.floor(x);
    }

    /** Returns the distance from u to the nearest of the numbers {@code at + integer}. */
    static double wrappedDistance(double u, double at) {
        return fraction(u - at + 0.5) - 0.5;
    }
}
