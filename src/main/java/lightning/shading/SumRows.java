package lightning.shading;

import lightning.trace.HitRows;

/**
 * A sum of lights' contributions over the rows of a tile: diffuse and specular, three channels each.
 */
final class SumRows {
    private static final float[] ONES = new float[Terms.ROWS];

    static {
        java.util.Arrays.fill(ONES, 1);
    }

    private final Sums sums;
    final float[] diffuseRed;
    final float[] diffuseGreen;
    final float[] diffuseBlue;
    /** Null where no specular term will ever be stored. */
    final float[] specularRed;
    final float[] specularGreen;
    final float[] specularBlue;
    /** Whether any light summed here has specular terms; else those columns are undefined. */
    boolean hasSpecular;

    /**
     * @param sums   who adds
     * @param length of the columns, as {@link HitRows#padded}
     */
    SumRows(Sums sums, int length) {
        this(sums, length, true);
    }

    private SumRows(Sums sums, int length, boolean specular) {
        this.sums = sums;
        diffuseRed = new float[length];
        diffuseGreen = new float[length];
        diffuseBlue = new float[length];
        specularRed = specular ? new float[length] : null;
        specularGreen = specular ? new float[length] : null;
        specularBlue = specular ? new float[length] : null;
    }

    /** A copy that is just long enough. */
    SumRows compact(int rows) {
        SumRows copy = new SumRows(sums, HitRows.padded(rows), hasSpecular);
        copy.copy(rows, this);
        return copy;
    }

    /** Sets this to another sum. */
    void copy(int rows, SumRows other) {
        System.arraycopy(other.diffuseRed, 0, diffuseRed, 0, rows);
        System.arraycopy(other.diffuseGreen, 0, diffuseGreen, 0, rows);
        System.arraycopy(other.diffuseBlue, 0, diffuseBlue, 0, rows);
        hasSpecular = false;
        if (other.hasSpecular) {
            addSpecular(rows, other.specularRed, other.specularGreen, other.specularBlue);
        }
    }

    /** The bytes of the columns, array headers left out. */
    long bytes() {
        return (specularRed == null ? 12L : 24L) * diffuseRed.length;
    }

    /** Sets this to one light's contribution. */
    void set(int rows, Luminaire light, LightLayer layer) {
        switch (layer) {
            case LightRows exact -> {
                float[] falloff = exact.falloff == null ? ONES : exact.falloff;
                sums.set(rows, light, exact.cosine, falloff, diffuseRed, diffuseGreen, diffuseBlue);
                hasSpecular = exact.specular != null;
                if (hasSpecular) {
                    sums.set(rows, light, exact.specular, falloff, specularRed, specularGreen, specularBlue);
                }
            }
            case RatioRows ratio -> {
                hasSpecular = false;
                System.arraycopy(ratio.diffuse[0], 0, diffuseRed, 0, rows);
                System.arraycopy(ratio.diffuse[1], 0, diffuseGreen, 0, rows);
                System.arraycopy(ratio.diffuse[2], 0, diffuseBlue, 0, rows);
                addSpecular(rows, ratio.specular);
            }
        }
    }

    /** Adds one light's contribution. */
    void add(int rows, Luminaire light, LightLayer layer) {
        switch (layer) {
            case LightRows exact -> addExact(rows, light, exact);
            case RatioRows ratio -> {
                addDiffuse(rows, ratio.diffuse[0], ratio.diffuse[1], ratio.diffuse[2]);
                addSpecular(rows, ratio.specular);
            }
        }
    }

    private void addExact(int rows, Luminaire light, LightRows layer) {
        float[] falloff = layer.falloff == null ? ONES : layer.falloff;
        sums.add(rows, light, layer.cosine, falloff, diffuseRed, diffuseGreen, diffuseBlue);
        if (layer.specular != null) {
            if (hasSpecular) {
                sums.add(rows, light, layer.specular, falloff, specularRed, specularGreen, specularBlue);
            } else {
                sums.set(rows, light, layer.specular, falloff, specularRed, specularGreen, specularBlue);
            }
            hasSpecular = true;
        }
    }

    /** Adds another sum. */
    void add(int rows, SumRows other) {
        addDiffuse(rows, other.diffuseRed, other.diffuseGreen, other.diffuseBlue);
        if (other.hasSpecular) {
            addSpecular(rows, other.specularRed, other.specularGreen, other.specularBlue);
        }
    }

    private void addDiffuse(int rows, float[] red, float[] green, float[] blue) {
        sums.add(rows, red, diffuseRed);
        sums.add(rows, green, diffuseGreen);
        sums.add(rows, blue, diffuseBlue);
    }

    private void addSpecular(int rows, float[][] specular) {
        if (specular != null) {
            addSpecular(rows, specular[0], specular[1], specular[2]);
        }
    }

    private void addSpecular(int rows, float[] red, float[] green, float[] blue) {
        if (hasSpecular) {
            sums.add(rows, red, specularRed);
            sums.add(rows, green, specularGreen);
            sums.add(rows, blue, specularBlue);
        } else {
            System.arraycopy(red, 0, specularRed, 0, rows);
            System.arraycopy(green, 0, specularGreen, 0, rows);
            System.arraycopy(blue, 0, specularBlue, 0, rows);
        }
        hasSpecular = true;
    }
}
