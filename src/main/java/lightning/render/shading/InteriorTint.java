package lightning.render.shading;

import lightning.base.math.PowerFunction;
import lightning.scene.material.Transmission;

/**
 * Transmittance of paths inside a transparent material: tint<sup>path / tint distance</sup> in red, green, blue. The logarithms of
 * the tint are computed once.
 */
public final class InteriorTint {
    /** log₂ of the tint in red, green, blue; −∞ for 0. */
    private final double[] log2 = new double[3];
    private final double distance;

    public InteriorTint(Transmission transmission) {
        for (int c = 0; c < 3; c++) {
            log2[c] = PowerFunction.log2(LightWeight.channel(transmission.tint(), c));
        }
        distance = transmission.tintDistance();
    }

    /** Returns log₂ of the tint in one channel; −∞ for 0. */
    public double log2(int channel) {
        return log2[channel];
    }

    /** Returns the path after which white light has the color of the tint, scene units. */
    public double distance() {
        return distance;
    }

    /** Returns the transmittance in one channel of a path in scene units; 1 if the path is negative, as for a ray from outside. */
    public float transmittance(int channel, float path) {
        return path >= 0 && log2[channel] != 0 ? (float) PowerFunction.powOfLog2(log2[channel], path / distance) : 1;
    }

    /**
     * Returns log₂ of the transmittance in one channel of a path in scene units, at least 0. Its {@link PowerFunction#exponential}
     * is the transmittance.
     */
    double exponent(int channel, float path) {
        double n = path / distance;
        return n == 0 || log2[channel] == 0 ? 0 : n * log2[channel];
    }

    /** Writes the transmittance of a path: red, green, blue. */
    public void write(float path, float[] to) {
        for (int c = 0; c < 3; c++) {
            to[c] = transmittance(c, path);
        }
    }
}
