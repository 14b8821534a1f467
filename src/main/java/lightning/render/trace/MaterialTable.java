package lightning.render.trace;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.scene.Clarity;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.TextureMap;

/**
 * The materials in use as plain columns: the place where the file's doubles become the floats of
 * the lighting equation. Colours are {@code float[3 * count]}: r g b of material 0, then of 1, ….
 *
 * <p>A material keeps its index however it is edited: indices follow the shapes that name the materials. The rows of a
 * tile are sorted by {@link #rank} instead, clear materials first, then others that are reflective, so that the rows that cast refracted rays are
 * a prefix, and those that cast mirrored ones.
 */
public final class MaterialTable {
    /** The materials that mirror anything: clear ones do. */
    public static final Predicate<Material> MIRRORS = Material::bouncesRays;

    private final List<Material> materials;
    /** Which of them shapes with colours of their own have. */
    private final boolean[] tinted;
    private final int reflectiveCount;
    private final int clearCount;
    private final int[] rank;
    private final int[] ranked;
    private final float[] ambient;
    private final float[] diffuse;
    private final float[] specular;
    private final float[] reflective;
    /** Of metallic materials what a texture multiplies of F0; null where there is none. */
    private final float[] metal;

    /**
     * @param names the materials' names, each once: material {@code m} is that of name {@code m}
     * @param tinted those that shapes have whose vertices are coloured ({@link #tinted})
     * @param scene says what they are
     * @param before  tells those that no shape has and the scene lacks; null where there are none
     * @param mirrors which of them cast mirrored rays: all that mirror, and perhaps others
     */
    MaterialTable(List<String> names, Set<String> tinted, Scene scene, MaterialTable before, Predicate<Material> mirrors) {
        Map<String, Material> byName = scene.materialsByName();
        materials = IntStream.range(0, names.size()).mapToObj(m -> {
            Material material = byName.get(names.get(m));
            return material == null ? before.material(m) : material;
        }).toList();
        int count = materials.size();
        this.tinted = new boolean[count];
        ambient = new float[3 * count];
        diffuse = new float[3 * count];
        specular = new float[3 * count];
        reflective = new float[3 * count];
        metal = materials.stream().anyMatch(Material::isMetallic) ? new float[3 * count] : null;
        rank = new int[count];
        ranked = new int[count];
        int casting = 0;
        int clear = 0;
        for (int m = 0; m < count; m++) {
            Material material = materials.get(m);
            this.tinted[m] = tinted.contains(material.name());
            store(material.ambient(), ambient, 3 * m);
            switch (material.model()) {
                case PHONG -> {
                    store(material.diffuse(), diffuse, 3 * m);
                    store(material.specular(), specular, 3 * m);
                }
                case METALLIC -> {
                    double dielectric = 1 - material.metalness();
                    store(material.base().times(dielectric * (1 - material.f0())), diffuse, 3 * m);
                    store(Rgb.grey(dielectric * material.f0()), specular, 3 * m);
                    store(material.base().times(material.metalness()), metal, 3 * m);
                }
            }
            store(material.reflective(), reflective, 3 * m);
            casting += mirrors.test(material) ? 1 : 0;
            clear += material.clarity().isClear() ? 1 : 0;
        }
        reflectiveCount = casting;
        clearCount = clear;
        int foremost = 0;
        int first = clear;
        int last = casting;
        for (int m = 0; m < count; m++) {
            rank[m] = materials.get(m).clarity().isClear() ? foremost++ : mirrors.test(materials.get(m)) ? first++ : last++;
            ranked[rank[m]] = m;
        }
    }

    /** The names of the materials that shapes use, each once, in the order of their first use. */
    static List<String> names(List<Shape> shapes) {
        return shapes.stream().map(Shape::material).distinct().toList();
    }

    /** The same after some that keep their places, whether shapes use them or not. */
    static List<String> names(List<String> known, List<Shape> shapes) {
        return Stream.concat(known.stream(), shapes.stream().map(Shape::material)).distinct().toList();
    }

    /** The names of the materials of shapes whose vertices have colours, which are shown. */
    static Set<String> tinted(List<Shape> shapes) {
        return shapes.stream().filter(s -> s.solid() instanceof Solid.Triangles t && t.isTinted()).map(Shape::material)
                .collect(Collectors.toUnmodifiableSet());
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
        return rank[m] < reflectiveCount;
    }

    /** How many materials cast reflected rays: those with the lowest ranks. */
    public int reflectiveCount() {
        return reflectiveCount;
    }

    /** How many materials are clear: those with the lowest ranks. */
    public int clearCount() {
        return clearCount;
    }

    /** Whether material {@code m} is clear. */
    public boolean isClear(int m) {
        return rank[m] < clearCount;
    }

    /** What passes through material {@code m}. */
    public Clarity clarity(int m) {
        return materials.get(m).clarity();
    }

    /** The place of material {@code m} in the order of a tile's rows: 0 … {@code count() − 1}. */
    public int rank(int m) {
        return rank[m];
    }

    /** The material of a rank. */
    public int ranked(int r) {
        return ranked[r];
    }

    /** Whether it is of the model {@link lightning.scene.SurfaceModel#METALLIC}. */
    public boolean isMetallic(int m) {
        return metal != null && materials.get(m).isMetallic();
    }

    /** Whether rows of it have specular terms. */
    public boolean isSpecular(int m) {
        return isMetallic(m) || specular[3 * m] > 0 || specular[3 * m + 1] > 0 || specular[3 * m + 2] > 0;
    }

    /** Whether rows of material {@code m} have texels: from its texture, or from the vertices of any shape that has it. */
    public boolean isTextured(int m) {
        return tinted[m] || materials.get(m).texture().isPresent();
    }

    /** The texture of material {@code m}; null where it has none. */
    public TextureMap texture(int m) {
        return materials.get(m).texture().orElse(null);
    }

    public double shininess(int m) {
        return materials.get(m).shininess();
    }

    /** The width α of the highlights of a metallic material. */
    public double alpha(int m) {
        return materials.get(m).alpha();
    }

    /** Whether any throws no shadows. */
    public boolean hasShadowless() {
        return materials.stream().anyMatch(m -> !m.clarity().throwsShadows());
    }

    /** Whether any is metallic. */
    public boolean hasMetallic() {
        return metal != null;
    }

    /** What no term of a light is above over rows of these materials. */
    public double mostTerm() {
        return materials.stream().mapToDouble(Material::mostTerm).reduce(1, Math::max);
    }

    /** k<sub>ambient</sub> before the scene's ambience; {@code channel} 0, 1, 2 for red, green, blue. */
    public float ambient(int m, int channel) {
        return ambient[3 * m + channel];
    }

    /** k<sub>diffuse</sub> before the texture; of a metallic material base·(1 − metalness)·(1 − f0). */
    public float diffuse(int m, int channel) {
        return diffuse[3 * m + channel];
    }

    /** k<sub>specular</sub>; of a metallic material (1 − metalness)·f0: the part of F0 that no texture multiplies. */
    public float specular(int m, int channel) {
        return specular[3 * m + channel];
    }

    /** Of a metallic material base·metalness: the part of F0 that the texture multiplies; else 0. */
    public float metal(int m, int channel) {
        return metal == null ? 0 : metal[3 * m + channel];
    }

    public float reflective(int m, int channel) {
        return reflective[3 * m + channel];
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof MaterialTable t && materials.equals(t.materials) && Arrays.equals(tinted, t.tinted);
    }

    @Override
    public int hashCode() {
        return materials.hashCode();
    }
}
