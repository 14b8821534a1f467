package lightning.render.shading;

import lightning.base.math.Rgb;

/** Factor of a light's diffuse or specular contributions, by channel. */
public record LightWeight(float red, float green, float blue) {
    public static final LightWeight ZERO = new LightWeight(0, 0, 0);
    public static final LightWeight ONE = new LightWeight(1, 1, 1);

    static LightWeight of(Rgb weight) {
        return new LightWeight((float) weight.r(), (float) weight.g(), (float) weight.b());
    }

    static LightWeight gray(float weight) {
        return new LightWeight(weight, weight, weight);
    }

    /** Returns one channel: 0 is red, 1 green, 2 blue. */
    public float channel(int c) {
        return c == 0 ? red : c == 1 ? green : blue;
    }

    /** Returns a color's channel, rounded as the equation uses it. */
    public static float channel(Rgb color, int channel) {
        return (float) switch (channel) {
            case 0 -> color.r();
            case 1 -> color.g();
            default -> color.b();
        };
    }

    /** Returns a color's channels, rounded as the equation uses them. */
    static float[] channels(Rgb color) {
        return new float[] {channel(color, 0), channel(color, 1), channel(color, 2)};
    }

    /** Returns whether it is 0 in every channel. */
    public boolean isZero() {
        return red == 0 && green == 0 && blue == 0;
    }

    /** Returns each channel rounded to the nearest power of two (in its logarithm). */
    public LightWeight toPowersOfTwo() {
        return new LightWeight(nearestPowerOfTwo(red), nearestPowerOfTwo(green), nearestPowerOfTwo(blue));
    }

    public static float nearestPowerOfTwo(float weight) {
        return weight == 0 ? 0 : Math.scalb(1f, Math.min(Math.getExponent(weight * Math.sqrt(2)), Float.MAX_EXPONENT));
    }
}
