package lightning.shading;

/** A sum of lights' contributions over the rows of a tile: diffuse and specular, three channels each. */
final class SumRows {
    final float[] diffuseRed = new float[LightLanes.ROWS];
    final float[] diffuseGreen = new float[LightLanes.ROWS];
    final float[] diffuseBlue = new float[LightLanes.ROWS];
    final float[] specularRed = new float[LightLanes.ROWS];
    final float[] specularGreen = new float[LightLanes.ROWS];
    final float[] specularBlue = new float[LightLanes.ROWS];
    /** Whether any light summed here has specular terms; else those columns are undefined. */
    boolean hasSpecular;

    /** Sets this to one light's contribution. */
    void set(int rows, Lamp lamp, LightRows layer, float[] ones) {
        float[] falloff = layer.falloff == null ? ones : layer.falloff;
        set(rows, lamp, layer.cosine, falloff, diffuseRed, diffuseGreen, diffuseBlue);
        hasSpecular = layer.specular != null;
        if (hasSpecular) {
            set(rows, lamp, layer.specular, falloff, specularRed, specularGreen, specularBlue);
        }
    }

    /** Adds one light's contribution. */
    void add(int rows, Lamp lamp, LightRows layer, float[] ones) {
        float[] falloff = layer.falloff == null ? ones : layer.falloff;
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
        add(rows, other.diffuseRed, diffuseRed);
        add(rows, other.diffuseGreen, diffuseGreen);
        add(rows, other.diffuseBlue, diffuseBlue);
        if (other.hasSpecular) {
            addOrCopy(rows, other.specularRed, specularRed);
            addOrCopy(rows, other.specularGreen, specularGreen);
            addOrCopy(rows, other.specularBlue, specularBlue);
            hasSpecular = true;
        }
    }

    private void addOrCopy(int rows, float[] from, float[] to) {
        if (hasSpecular) {
            add(rows, from, to);
        } else {
            System.arraycopy(from, 0, to, 0, rows);
        }
    }

    private static void set(int rows, Lamp lamp, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = lamp.red();
        float g = lamp.green();
        float b = lamp.blue();
        for (int i = 0; i < rows; i++) {
            float faded = term[i] * falloff[i];
            red[i] = r * faded;
            green[i] = g * faded;
            blue[i] = b * faded;
        }
    }

    private static void add(int rows, Lamp lamp, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = lamp.red();
        float g = lamp.green();
        float b = lamp.blue();
        for (int i = 0; i < rows; i++) {
            float faded = term[i] * falloff[i];
            red[i] += r * faded;
            green[i] += g * faded;
            blue[i] += b * faded;
        }
    }

    private static void add(int rows, float[] from, float[] to) {
        for (int i = 0; i < rows; i++) {
            to[i] += from[i];
        }
    }
}
