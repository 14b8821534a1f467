package lightning.shading;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;
import lightning.trace.HitRows;

/**
 * A sum of lights' contributions over the rows of a tile: diffuse and specular, three channels each.
 *
 * <p>Columns are as long as whole lanes over the rows, so that loops run over the end. Plain loops
 * with three stores were not vectorised and took eight times as long.
 */
final class SumRows {
    private static final VectorSpecies<Float> F = FloatVector.SPECIES_PREFERRED;
    private static final float[] ONES = new float[LightLanes.ROWS];

    static {
        java.util.Arrays.fill(ONES, 1);
    }

    final float[] diffuseRed;
    final float[] diffuseGreen;
    final float[] diffuseBlue;
    /** Null where no specular term will ever be stored. */
    final float[] specularRed;
    final float[] specularGreen;
    final float[] specularBlue;
    /** Whether any light summed here has specular terms; else those columns are undefined. */
    boolean hasSpecular;

    /** @param length of the columns: whole lanes */
    SumRows(int length) {
        this(length, true);
    }

    private SumRows(int length, boolean specular) {
        diffuseRed = new float[length];
        diffuseGreen = new float[length];
        diffuseBlue = new float[length];
        specularRed = specular ? new float[length] : null;
        specularGreen = specular ? new float[length] : null;
        specularBlue = specular ? new float[length] : null;
    }

    /** A copy that is just long enough. */
    SumRows compact(int rows) {
        SumRows copy = new SumRows(HitRows.padded(rows), hasSpecular);
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
    void set(int rows, Lamp lamp, LightLayer layer) {
        switch (layer) {
            case LightRows exact -> {
                float[] falloff = exact.falloff == null ? ONES : exact.falloff;
                set(rows, lamp, exact.cosine, falloff, diffuseRed, diffuseGreen, diffuseBlue);
                hasSpecular = exact.specular != null;
                if (hasSpecular) {
                    set(rows, lamp, exact.specular, falloff, specularRed, specularGreen, specularBlue);
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
    void add(int rows, Lamp lamp, LightLayer layer) {
        switch (layer) {
            case LightRows exact -> addExact(rows, lamp, exact);
            case RatioRows ratio -> {
                addDiffuse(rows, ratio.diffuse[0], ratio.diffuse[1], ratio.diffuse[2]);
                addSpecular(rows, ratio.specular);
            }
        }
    }

    private void addExact(int rows, Lamp lamp, LightRows layer) {
        float[] falloff = layer.falloff == null ? ONES : layer.falloff;
        add(rows, lamp, layer.cosine, falloff, diffuseRed, diffuseGreen, diffuseBlue);
        if (layer.specular != null) {
            if (hasSpecular) {
                add(rows, lamp, layer.specular, falloff, specularRed, specularGreen, specularBlue);
            } else {
                set(rows, lamp, layer.specular, falloff, specularRed, specularGreen, specularBlue);
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
        add(rows, red, diffuseRed);
        add(rows, green, diffuseGreen);
        add(rows, blue, diffuseBlue);
    }

    private void addSpecular(int rows, float[][] specular) {
        if (specular != null) {
            addSpecular(rows, specular[0], specular[1], specular[2]);
        }
    }

    private void addSpecular(int rows, float[] red, float[] green, float[] blue) {
        if (hasSpecular) {
            add(rows, red, specularRed);
            add(rows, green, specularGreen);
            add(rows, blue, specularBlue);
        } else {
            System.arraycopy(red, 0, specularRed, 0, rows);
            System.arraycopy(green, 0, specularGreen, 0, rows);
            System.arraycopy(blue, 0, specularBlue, 0, rows);
        }
        hasSpecular = true;
    }

    /** As {@link LightingEquation#contribution}, in lanes. */
    private static void set(int rows, Lamp lamp, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = lamp.red();
        float g = lamp.green();
        float b = lamp.blue();
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector faded = FloatVector.fromArray(F, term, i).mul(FloatVector.fromArray(F, falloff, i));
            faded.mul(r).intoArray(red, i);
            faded.mul(g).intoArray(green, i);
            faded.mul(b).intoArray(blue, i);
        }
    }

    private static void add(int rows, Lamp lamp, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = lamp.red();
        float g = lamp.green();
        float b = lamp.blue();
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector faded = FloatVector.fromArray(F, term, i).mul(FloatVector.fromArray(F, falloff, i));
            FloatVector.fromArray(F, red, i).add(faded.mul(r)).intoArray(red, i);
            FloatVector.fromArray(F, green, i).add(faded.mul(g)).intoArray(green, i);
            FloatVector.fromArray(F, blue, i).add(faded.mul(b)).intoArray(blue, i);
        }
    }

    private static void add(int rows, float[] from, float[] to) {
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector.fromArray(F, to, i).add(FloatVector.fromArray(F, from, i)).intoArray(to, i);
        }
    }
}
