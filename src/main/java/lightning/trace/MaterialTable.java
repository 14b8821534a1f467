package lightning.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.math.Rgb;
import lightning.scene.Material;
import lightning.scene.PlacedShape;
import lightning.scene.TextureMap;

/**
 * The materials in use as plain columns: the place where the file's doubles become the floats of
 * the lighting equation. Colours are {@code float[3 * count]}: r g b of material 0, then of 1, ….
 *
 * <p>Reflective materials come first, so that the rows of a tile that cast reflected rays are a
 * prefix of its rows.
 */
public final class MaterialTable {
    private final List<Material> materials;
    private final int reflectiveCount;
    private final float[] ambient;
    private final float[] diffuse;
    private final float[] specular;
    private final float[] reflective;

    private MaterialTable(List<Material> materials) {
        this.materials = materials;
        ambient = new float[3 * materials.size()];
        diffuse = new float[3 * materials.size()];
        specular = new float[3 * materials.size()];
        reflective = new float[3 * materials.size()];
        int mirrors = 0;
        for (int m = 0; m < materials.size(); m++) {
            Material material = materials.get(m);
            store(material.ambient(), ambient, 3 * m);
            store(material.diffuse(), diffuse, 3 * m);
            store(material.specular(), specular, 3 * m);
            store(material.reflective(), reflective, 3 * m);
            mirrors += mirrors(material) ? 1 : 0;
        }
        reflectiveCount = mirrors;
    }

    /** The materials that the shapes use, each once; and for each shape its index in them. */
    static MaterialTable of(List<PlacedShape> shapes, int[] materialOf) {
        Map<Material, Integer> index = new HashMap<>();
        List<Material> used = new ArrayList<>();
        for (boolean mirror : new boolean[] {true, false}) {
            for (PlacedShape shape : shapes) {
                Material m = shape.material();
                if (mirrors(m) == mirror && !index.containsKey(m)) {
                    index.put(m, used.size());
                    used.add(m);
                }
            }
        }
        for (int s = 0; s < materialOf.length; s++) {
            materialOf[s] = index.get(shapes.get(s).material());
        }
        return new MaterialTable(used);
    }

    private static boolean mirrors(Material m) {
        return (float) m.reflective().max() > 0;
    }

    private static void store(Rgb c, float[] to, int at) {
        to[at] = (float) c.r();
        to[at + 1] = (float) c.g();
        to[at + 2] = (float) c.b();
    }

    public int count() {
        return materials.size();
    }

    public Material material(int m) {
        return materials.get(m);
    }

    /** Whether material {@code m} casts reflected rays. */
    public boolean isReflective(int m) {
        return m < reflectiveCount;
    }

    /** How many materials cast reflected rays: those with the lowest indices. */
    public int reflectiveCount() {
        return reflectiveCount;
    }

    public boolean isSpecular(int m) {
        return specular[3 * m] > 0 || specular[3 * m + 1] > 0 || specular[3 * m + 2] > 0;
    }

    public boolean isTextured(int m) {
        return materials.get(m).texture().isPresent();
    }

    public TextureMap texture(int m) {
        return materials.get(m).texture().orElseThrow();
    }

    public double shininess(int m) {
        return materials.get(m).shininess();
    }

    /** k<sub>ambient</sub> before the scene's ambience; {@code channel} 0, 1, 2 for red, green, blue. */
    public float ambient(int m, int channel) {
        return ambient[3 * m + channel];
    }

    /** k<sub>diffuse</sub> before the texture. */
    public float diffuse(int m, int channel) {
        return diffuse[3 * m + channel];
    }

    public float specular(int m, int channel) {
        return specular[3 * m + channel];
    }

    public float reflective(int m, int channel) {
        return reflective[3 * m + channel];
    }
}
