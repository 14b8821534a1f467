package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import java.util.Map;
import lightning.base.math.Rgb;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Numbers of an opaque or frosted principled material at one place: its own, multiplied by its maps. One instance per thread. */
public final class MappedSurface {
    private Material material = Material.DEFAULT;
    /** Columns of maps; null without the map. */
    private float @Nullable [] roughnessTexel;
    private float @Nullable [] metalnessTexel;
    private float @Nullable [] f0Texel;
    private float @Nullable [] coatTexel;
    private float @Nullable [] coatRoughnessTexel;
    private float @Nullable [] sheenRoughnessTexel;
    /** Columns of colors; unread without the map. */
    private final float[][] tintTexels = new float[3][0];
    private final float[][] sheenTexels = new float[3][0];
    private final float[][] coatNormals = new float[3][0];
    private boolean hasTintMap;
    private boolean hasCoatNormal;
    private boolean hasSheenMap;

    private double roughness;
    private double metalness;
    private double f0;
    private final double[] tint = new double[3];
    private float nonmetalF0;
    private float coatWeight;
    private double coatRoughness;
    private final float[] coatNormal = new float[3];
    private final float[] sheen = new float[3];
    private double sheenRoughness;

    /** Moves to a place of a material. @param maps colors of its images there, as in {@link SurfacePoint#maps} */
    public void moveTo(Material m, Map<ColumnGroup, float[]> maps) {
        start(m);
        roughness = m.mappedRoughness(number(maps, ColumnGroup.ROUGHNESS_TEXEL));
        metalness = m.mappedMetalness(number(maps, ColumnGroup.METALNESS_TEXEL));
        f0 = m.mappedF0(number(maps, ColumnGroup.F0_TEXEL));
        float[] normal = maps.get(ColumnGroup.COAT_NORMAL);
        hasCoatNormal = normal != null;
        float[] tints = maps.get(ColumnGroup.SPECULAR_TINT_TEXEL);
        float[] sheens = maps.get(ColumnGroup.SHEEN_TEXEL);
        for (int c = 0; c < 3; c++) {
            tint[c] = channel(m.specularTint(), c) * (tints == null ? 1 : tints[c]);
            sheen[c] = (float) channel(m.sheen().color(), c) * (sheens == null ? 1 : sheens[c]);
            coatNormal[c] = normal == null ? 0 : normal[c];
        }
        setNonmetalF0();
        coatWeight = (float) product(m.coat().weight(), number(maps, ColumnGroup.COAT_TEXEL));
        coatRoughness = product(m.coat().roughness(), number(maps, ColumnGroup.COAT_ROUGHNESS_TEXEL));
        sheenRoughness = product(m.sheen().roughness(), number(maps, ColumnGroup.SHEEN_ROUGHNESS_TEXEL));
    }

    private static float number(Map<ColumnGroup, float[]> maps, ColumnGroup group) {
        float[] texel = maps.get(group);
        return texel == null ? 1 : texel[0];
    }

    /** Sets the material of the next rows. */
    public void start(Material m, HitRows rows) {
        start(m);
        roughnessTexel = column(rows, ColumnGroup.ROUGHNESS_TEXEL);
        metalnessTexel = column(rows, ColumnGroup.METALNESS_TEXEL);
        f0Texel = column(rows, ColumnGroup.F0_TEXEL);
        coatTexel = column(rows, ColumnGroup.COAT_TEXEL);
        coatRoughnessTexel = column(rows, ColumnGroup.COAT_ROUGHNESS_TEXEL);
        sheenRoughnessTexel = column(rows, ColumnGroup.SHEEN_ROUGHNESS_TEXEL);
        hasTintMap = ColumnGroup.SPECULAR_TINT_TEXEL.map(m).isPresent();
        hasSheenMap = ColumnGroup.SHEEN_TEXEL.map(m).isPresent();
        // Surfels have none.
        hasCoatNormal = rows.texel(ColumnGroup.COAT_NORMAL, 0) != null && m.hasCoatNormals();
        for (int c = 0; c < 3; c++) {
            tintTexels[c] = hasTintMap ? requireNonNull(rows.texel(ColumnGroup.SPECULAR_TINT_TEXEL, c)) : tintTexels[c];
            sheenTexels[c] = hasSheenMap ? requireNonNull(rows.texel(ColumnGroup.SHEEN_TEXEL, c)) : sheenTexels[c];
            coatNormals[c] = hasCoatNormal ? requireNonNull(rows.texel(ColumnGroup.COAT_NORMAL, c)) : coatNormals[c];
        }
    }

    private float @Nullable [] column(HitRows rows, ColumnGroup group) {
        return group.map(material).isPresent() ? requireNonNull(rows.texel(group, 0)) : null;
    }

    /** Sets the numbers of a material without its maps. */
    private void start(Material m) {
        material = m;
        roughness = m.roughness();
        metalness = m.metalness();
        f0 = m.f0();
        for (int c = 0; c < 3; c++) {
            tint[c] = channel(m.specularTint(), c);
            sheen[c] = (float) channel(m.sheen().color(), c);
        }
        setNonmetalF0();
        coatWeight = (float) m.coat().weight();
        coatRoughness = m.coat().roughness();
        sheenRoughness = m.sheen().roughness();
    }

    /** Moves to a row of the material. */
    public void moveTo(int row) {
        if (roughnessTexel != null) {
            roughness = material.mappedRoughness(roughnessTexel[row]);
        }
        if (metalnessTexel != null) {
            metalness = material.mappedMetalness(metalnessTexel[row]);
        }
        if (f0Texel != null) {
            f0 = material.mappedF0(f0Texel[row]);
        }
        if (hasTintMap) {
            for (int c = 0; c < 3; c++) {
                tint[c] = channel(material.specularTint(), c) * tintTexels[c][row];
            }
        }
        if (hasTintMap || f0Texel != null) {
            setNonmetalF0();
        }
        if (coatTexel != null) {
            coatWeight = (float) product(material.coat().weight(), coatTexel[row]);
        }
        if (coatRoughnessTexel != null) {
            coatRoughness = product(material.coat().roughness(), coatRoughnessTexel[row]);
        }
        if (hasCoatNormal) {
            for (int c = 0; c < 3; c++) {
                coatNormal[c] = coatNormals[c][row];
            }
        }
        if (hasSheenMap) {
            for (int c = 0; c < 3; c++) {
                sheen[c] = (float) channel(material.sheen().color(), c) * sheenTexels[c][row];
            }
        }
        if (sheenRoughnessTexel != null) {
            sheenRoughness = product(material.sheen().roughness(), sheenRoughnessTexel[row]);
        }
    }

    private void setNonmetalF0() {
        nonmetalF0 = (float) (f0 * Math.max(tint[0], Math.max(tint[1], tint[2])));
    }

    private static double product(double number, float texel) {
        return Math.clamp(number * texel, 0, 1);
    }

    static double channel(Rgb color, int channel) {
        return channel == 0 ? color.r() : channel == 1 ? color.g() : color.b();
    }

    /** Returns the material. */
    public Material material() {
        return material;
    }

    /** Returns the roughness below the coat, 0…1. */
    public double roughness() {
        return roughness;
    }

    /** Returns the metalness, 0…1. */
    public double metalness() {
        return metalness;
    }

    /** Returns one channel of the reflectance of the nonmetal part at normal incidence. */
    public double nonmetalF0(int channel) {
        return tint[channel] * f0;
    }

    /** Returns one channel of the part of F0 that no texture multiplies: tint·(1 − metalness)·f0. */
    public float specular(int channel) {
        return (float) (tint[channel] * ((1 - metalness) * f0));
    }

    /** Returns the largest channel of the reflectance of the nonmetal part at normal incidence. */
    public float largestNonmetalF0() {
        return nonmetalF0;
    }

    /** Returns the share of the surface that the coat covers, 0…1. */
    public float coatWeight() {
        return coatWeight;
    }

    /** Returns the roughness of the coat, 0…1. */
    public double coatRoughness() {
        return coatRoughness;
    }

    /**
     * Returns the cosine between a direction and the normal of the coat, negated.
     *
     * @param otherwise value if the coat has the normals of the surface
     */
    public float coatCosine(float x, float y, float z, float otherwise) {
        return hasCoatNormal ? Math.clamp(-(coatNormal[0] * x + coatNormal[1] * y + coatNormal[2] * z), 0, 1) : otherwise;
    }

    /** Returns one channel of the color of the sheen. */
    public float sheen(int channel) {
        return sheen[channel];
    }

    /** Returns the largest channel of the color of the sheen. */
    public float largestSheen() {
        return Math.max(sheen[0], Math.max(sheen[1], sheen[2]));
    }

    /** Returns the roughness of the sheen, 0…1. */
    public double sheenRoughness() {
        return sheenRoughness;
    }
}
