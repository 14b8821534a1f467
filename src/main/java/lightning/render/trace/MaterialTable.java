package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.Scene;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.jspecify.annotations.Nullable;

/**
 * Materials in use as columns, in which the file's doubles become the floats of the lighting equation. Colors are
 * {@code float[3 * count]}: r g b of material 0, then of 1, ….
 *
 * <p>A material keeps its index when it is edited: indices follow the order in which shapes name the materials. A tile's rows
 * are sorted by {@link #rank} instead: transparent materials first, then other reflective ones. So the rows that cast refracted
 * rays are a prefix, and so are the rows that cast reflected rays.
 */
public final class MaterialTable {
    /** Selects reflective materials; transparent ones are included. */
    public static final Predicate<Material> CASTS_REFLECTIONS = Material::spawnsSecondaryRays;

    private final List<Material> materials;
    /** Materials used by shapes with vertex colors. */
    private final boolean[] vertexColored;
    private final int reflectiveCount;
    private final int clearCount;
    private final boolean hasTransparent;
    private final int[] rank;
    private final int[] materialByRank;
    private final float[] ambient;
    private final float[] glow;
    /** Glow without that of bulbs. */
    private final float[] ownGlow;
    /** Glow of bulbs of lights of weight 1; null if there are none. */
    private final float @Nullable [] bulbGlow;
    /** Columns of images by material, and of any of them. */
    private final TexelColumns[] texels;
    private final TexelColumns anyTexels;
    private final float[] diffuse;
    private final float[] specular;
    private final float[] reflective;
    /** Part of F0 of metallic materials that a texture multiplies; null if there are none. */
    private final float @Nullable [] metalF0;

    /**
     * @param names unique material names; the index of a name is the index of the material
     * @param vertexColorMaterials materials of shapes with vertex colors ({@link #vertexColored})
     * @param scene defines the materials
     * @param previous provides materials that no shape uses and the scene lacks; null if there are none
     * @param castsReflections selects the materials that cast reflected rays: all reflective ones, and possibly others
     */
    MaterialTable(List<String> names, Set<String> vertexColorMaterials, Scene scene, @Nullable MaterialTable previous,
            Predicate<Material> castsReflections) {
        Map<String, Material> byName = scene.stage().rendered().materialsByName();
        materials = IntStream.range(0, names.size()).mapToObj(m -> {
            Material material = byName.get(names.get(m));
            return material == null ? requireNonNull(previous).material(m) : material;
        }).toList();
        int count = materials.size();
        this.vertexColored = new boolean[count];
        ambient = new float[3 * count];
        glow = new float[3 * count];
        ownGlow = new float[3 * count];
        bulbGlow = materials.stream().allMatch(m -> m.bulb().unit().isBlack()) ? null : new float[3 * count];
        texels = new TexelColumns[count];
        anyTexels = TexelColumns.ofAny(materials);
        diffuse = new float[3 * count];
        specular = new float[3 * count];
        reflective = new float[3 * count];
        metalF0 = materials.stream().anyMatch(Material::isMetallic) ? new float[3 * count] : null;
        rank = new int[count];
        materialByRank = new int[count];
        int reflectiveTotal = 0;
        int clearTotal = 0;
        boolean anyTransparent = false;
        for (int m = 0; m < count; m++) {
            Material material = materials.get(m);
            this.vertexColored[m] = vertexColorMaterials.contains(material.name());
            texels[m] = vertexColored[m] ? TexelColumns.of(material).or(TexelColumns.COLORS) : TexelColumns.of(material);
            store(material.ambient(), ambient, 3 * m);
            store(material.glow(), ownGlow, 3 * m);
            store(material.emission(), glow, 3 * m);
            if (bulbGlow != null) {
                store(material.bulb().unit(), bulbGlow, 3 * m);
            }
            switch (material.model()) {
                case PHONG -> {
                    store(material.diffuse(), diffuse, 3 * m);
                    store(material.specular(), specular, 3 * m);
                }
                case METALLIC, PRINCIPLED -> {
                    double dielectric = 1 - material.metalness();
                    // What a principled surface reflects depends on the view.
                    double entering = material.isPrincipled() ? 1 : 1 - material.f0();
                    store(material.base().times(dielectric * entering * PrincipledColors.body(material)), diffuse, 3 * m);
                    store(material.specularTint().times(dielectric * material.f0()), specular, 3 * m);
                    store(material.base().times(material.metalness()), requireNonNull(metalF0), 3 * m);
                }
            }
            store(material.reflective(), reflective, 3 * m);
            reflectiveTotal += castsReflections.test(material) ? 1 : 0;
            clearTotal += material.isClear() ? 1 : 0;
            anyTransparent |= material.transmission().isTransparent();
        }
        reflectiveCount = reflectiveTotal;
        clearCount = clearTotal;
        hasTransparent = anyTransparent;
        int nextClear = 0;
        int nextReflective = clearTotal;
        int nextOther = reflectiveTotal;
        for (int m = 0; m < count; m++) {
            rank[m] = materials.get(m).isClear() ? nextClear++
                    : castsReflections.test(materials.get(m)) ? nextReflective++ : nextOther++;
            materialByRank[rank[m]] = m;
        }
    }

    /** Returns the unique names of the materials that shapes use, in order of first use. */
    static List<String> materialNames(List<Shape> shapes) {
        return shapes.stream().map(Shape::material).distinct().toList();
    }

    /** Returns existing names, used or not, at their indices, followed by new names that shapes use. */
    static List<String> materialNames(List<String> existing, List<Shape> shapes) {
        return Stream.concat(existing.stream(), shapes.stream().map(Shape::material)).distinct().toList();
    }

    /** Returns the names of the materials of shapes whose vertex colors are visible. */
    static Set<String> vertexColorMaterials(List<Shape> shapes) {
        return shapes.stream().filter(s -> s.solid() instanceof Solid.TriangleMesh t && t.hasVertexColors()).map(Shape::material)
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

    /** Returns whether rays pass material {@code m} as in another table, and its surfels have the same textures. */
    public boolean hasSamePaths(int m, MaterialTable o) {
        return isTextured(m) == o.isTextured(m) && material(m).hasSameTextures(o.material(m)) && transmission(m).equals(o.transmission(m))
                && (!isTransparent(m) || material(m).reflective().equals(o.material(m).reflective()));
    }

    public Material material(int m) {
        return materials.get(m);
    }

    /** Returns whether material {@code m} casts reflected rays. */
    public boolean isReflective(int m) {
        return rank[m] < reflectiveCount;
    }

    /** Returns the number of materials that cast reflected rays; they have the lowest ranks. */
    public int reflectiveCount() {
        return reflectiveCount;
    }

    /** Returns the number of clear materials; they have the lowest ranks. */
    public int clearCount() {
        return clearCount;
    }

    /** Returns {@link Material#isClear}. */
    public boolean isClear(int m) {
        return rank[m] < clearCount;
    }

    /** Returns whether light passes material {@code m}, which may be frosted. */
    public boolean isTransparent(int m) {
        return hasTransparent && materials.get(m).transmission().isTransparent();
    }

    /** Returns whether light passes any material. */
    public boolean hasTransparent() {
        return hasTransparent;
    }

    /** Returns the transmission of material {@code m}. */
    public Transmission transmission(int m) {
        return materials.get(m).transmission();
    }

    /**
     * Returns one channel of the share of light that passes a surface of a transparent material.
     *
     * @param reflectance Fresnel reflectance, 0…1
     */
    public float transmitted(int m, float reflectance, int channel) {
        Rgb color = transmission(m).color();
        return Refraction.transmitted(reflective(m, channel), reflectance,
                (float) (channel == 0 ? color.r() : channel == 1 ? color.g() : color.b()));
    }

    /** Returns the position of material {@code m} in the order of a tile's rows: 0 … {@code count() − 1}. */
    public int rank(int m) {
        return rank[m];
    }

    /** Returns the material of a rank. */
    public int materialAtRank(int r) {
        return materialByRank[r];
    }

    /** Returns whether rows of the material have specular terms. */
    public boolean isSpecular(int m) {
        return materials.get(m).isMetallic() || specular[3 * m] > 0 || specular[3 * m + 1] > 0 || specular[3 * m + 2] > 0;
    }

    /**
     * Returns whether rows of material {@code m} have texture colors, from its texture or from vertex colors of any shape that uses it.
     */
    public boolean isTextured(int m) {
        return texels[m].has(ColumnGroup.TEXEL);
    }

    /** Returns the texture of material {@code m}; null if it has none. */
    public @Nullable TextureMap texture(int m) {
        return materials.get(m).texture().orElse(null);
    }

    public double shininess(int m) {
        return materials.get(m).shininess();
    }

    /** Returns the width α of the highlights of a metallic material. */
    public double alpha(int m) {
        return materials.get(m).alpha();
    }

    /** Returns whether any material casts no shadows. */
    public boolean hasShadowlessMaterials() {
        return materials.stream().anyMatch(m -> !m.transmission().castsShadows());
    }

    /** Returns whether rays other than shadow rays pass any material. */
    boolean hasUnseenMaterials() {
        return materials.stream().anyMatch(m -> !m.transmission().isSeen());
    }

    /** Returns whether any material is metallic. */
    public boolean hasMetallic() {
        return metalF0 != null;
    }

    /** Returns an upper bound of any light's terms over rows of these materials. */
    public double maxTerm() {
        return materials.stream().mapToDouble(Material::maxTerm).reduce(1, Math::max);
    }

    /** Returns k<sub>ambient</sub> without the scene's ambient light; {@code channel} is 0, 1, 2 for red, green, blue. */
    public float ambient(int m, int channel) {
        return ambient[3 * m + channel];
    }

    /** Returns the light that the surface emits itself, before its glow map. */
    public float glow(int m, int channel) {
        return glow[3 * m + channel];
    }

    /**
     * Returns the image of material {@code m} whose colors its rows have in some columns; null if it has none.
     *
     * @param group one of {@link ColumnGroup#TEXELS}
     */
    public @Nullable TextureMap map(ColumnGroup group, int m) {
        return group.map(materials.get(m)).orElse(null);
    }

    /** Returns which colors of images rows of material {@code m} have. */
    public TexelColumns texels(int m) {
        return texels[m];
    }

    /** Returns which colors of images rows of any material may have. */
    public TexelColumns anyTexels() {
        return anyTexels;
    }

    /**
     * Returns one channel of the glow that lights other surfaces, before its glow map: without that of a bulb, whose light does so
     * itself.
     */
    public float ownGlow(int m, int channel) {
        return ownGlow[3 * m + channel];
    }

    /** Returns one channel of the glow of a bulb before its glow map, if its light has weight 1; 0 without a bulb. */
    public float bulbGlow(int m, int channel) {
        return bulbGlow == null ? 0 : bulbGlow[3 * m + channel];
    }

    /** Returns the materials that are bulbs of a light: {@code boolean[count]}; null if none is. */
    public boolean @Nullable [] bulbsOf(String light) {
        boolean[] bulbs = null;
        for (int m = 0; bulbGlow != null && m < materials.size(); m++) {
            if (materials.get(m).bulb().light().equals(light) && !materials.get(m).bulb().unit().isBlack()) {
                bulbs = bulbs == null ? new boolean[materials.size()] : bulbs;
                bulbs[m] = true;
            }
        }
        return bulbs;
    }

    /**
     * Returns k<sub>diffuse</sub> without the texture; base·(1 − metalness)·(1 − f0) for a metallic material, without the last for a
     * principled one.
     */
    public float diffuse(int m, int channel) {
        return diffuse[3 * m + channel];
    }

    /** Returns k<sub>specular</sub>; for a metallic material (1 − metalness)·f0·tint, the part of F0 that no texture multiplies. */
    public float specular(int m, int channel) {
        return specular[3 * m + channel];
    }

    /** Returns the part of F0 that the texture multiplies: base·metalness for a metallic material, otherwise 0. */
    public float metalF0(int m, int channel) {
        return metalF0 == null ? 0 : metalF0[3 * m + channel];
    }

    public float reflective(int m, int channel) {
        return reflective[3 * m + channel];
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof MaterialTable t && materials.equals(t.materials) && Arrays.equals(vertexColored, t.vertexColored);
    }

    @Override
    public int hashCode() {
        return materials.hashCode();
    }
}
