package lightning.render.shading;

import lightning.base.math.Vec3;

/**
 * Directions to which the samples of an object's light shine, by {@link AreaSamples#index}. Each shines by Lambert's law: in proportion to the
 * cosine of the angle from its normal.
 *
 * @param x unit vector, with {@code y} and {@code z}; {@code double[samples]}
 * @param bothSides whether it shines to both sides, by the absolute value of the cosine
 */
public record SampleNormals(double[] x, double[] y, double[] z, boolean[] bothSides) {
    SampleNormals(int samples) {
        this(new double[samples], new double[samples], new double[samples], new boolean[samples]);
    }

    void set(int i, Vec3 normal, boolean both) {
        x[i] = normal.x();
        y[i] = normal.y();
        z[i] = normal.z();
        bothSides[i] = both;
    }

    Vec3 normal(int i) {
        return new Vec3(x[i], y[i], z[i]);
    }

    /** Returns the height above a plane through the origin with a normal. */
    static double height(double px, double py, double pz, double nx, double ny, double nz) {
        return px * nx + py * ny + pz * nz;
    }

    /** Returns whether a point is behind a sample that shines to one side only; both in render space. */
    public boolean isBehind(AreaSamples samples, int i, double px, double py, double pz) {
        return !bothSides[i] && height(px - samples.x[i], py - samples.y[i], pz - samples.z[i], x[i], y[i], z[i]) < 0;
    }
}
