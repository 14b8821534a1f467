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
    void set(int rows, Lamp lamp, LightLayer layer, float[] ones) {
        switch (layer) {
            case LightRows exact -> set(rows, lamp, exact, ones);
            case RatioRows ratio -> {
                hasSpecular = false;
                copy(rows, ratio.diffuse, diffuseRed, diffuseGreen, diffuseBlue);
                addSpecular(rows, ratio);
            }
        }
    }

    /** Adds one light's contribution. */
    void add(int rows, Lamp lamp, LightLayer layer, float[] ones) {
        switch (layer) {
            case LightRows exact -> add(rows, lamp, exact, ones);
            case RatioRows ratio -> {
                add(rows, ratio.diffuse[0], diffuseRed);
                add(rows, ratio.diffuse[1], diffuseGreen);
                add(rows, ratio.diffuse[2], diffuseBlue);
                addSpecular(rows, ratio);
            }
        }
    }

    private void addSpecular(int rows, RatioRows ratio) {
        if (ratio.specular != null) {
            addOrCopy(rows, ratio.specular[0], specularRed);
            addOrCopy(rows, ratio.specular[1], specularGreen);
            addOrCopy(rows, ratio.specular[2], specularBlue);
            hasSpecular = true;
        }
    }

    private static void copy(int rows, float[][] from, float[] red, float[] green, float[] blue) {
        System.arraycopy(from[0], 0, red, 0, rows);
        System.arraycopy(from[1], 0, green, 0, rows);
        System.arraycopy(from[2], 0, blue, 0, rows);
    }

    private void set(int rows, Lamp lamp, LightRows layer, float[] ones) {
        float[] falloff = layer.falloff == null ? ones : layer.falloff;
        set(rows, lamp, layer.cosine, falloff, diffuseRed, diffuseGreen, diffuseBlue);
        hasSpecular = layer.specular != null;
        if (hasSpecular) {
            set(rows, lamp, layer.specular, falloff, specularRed, specularGreen, specularBlue);
        }
    }

    private void add(int rows, Lamp lamp, LightRows layer, float[] ones) {
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
