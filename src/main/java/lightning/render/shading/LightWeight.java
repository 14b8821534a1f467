package lightning.render.shading;

import lightning.base.math.Rgb;

/** Factor of a light's diffuse or specular contributions, by channel. */
public record LightWeight(float red, float green, float blue) {
    static final LightWeight ZERO = new LightWeight(0, 0, 0);

    static LightWeight of(Rgb weight) {
        return new LightWeight((float) weight.r(), (float) weight.g(), (float) weight.b());
    }

    /** Returns one channel: 0 is red, 1 green, 2 blue. */
    public float channel(int c) {
        return c == 0 ? red : c == 1 ? green : blue;
    }

    /** Returns whether it is 0 in every channel. */
    boolean isZero() {
        return red == 0 && green == 0 && blue == 0;
    }

    /** Returns each channel rounded to the nearest power of two (in its logarithm). */
    LightWeight toPowersOfTwo() {
        return new LightWeight(nearestPowerOfTwo(red), nearestPowerOfTwo(green), nearestPowerOfTwo(blue));
    }

    public static float nearestPowerOfTwo(float weight) {
        return weight == 0 ? 0 : Math.scalb(1f, Math.min(Math.getExponent(weight * Math.sqrt(2)), Float.MAX_EXPONENT));
    }
}
