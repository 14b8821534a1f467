package lightning.render.trace;

import java.util.Collection;
import java.util.List;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.scene.material.Material;

/**
 * Which colors of images rows have: some of {@link ColumnGroup#TEXELS}. Tangents are handled as these are: they depend on the material, and
 * follow from the place on the surface.
 *
 * @param bits the bit of each group's ordinal is set
 */
public record TexelColumns(int bits) {
    public static final TexelColumns NONE = new TexelColumns(0);
    /** Colors of textures and of vertices, which multiply the main color. */
    public static final TexelColumns COLORS = NONE.with(ColumnGroup.TEXEL);
    /** Factors of the roughness. */
    public static final TexelColumns ROUGHNESS = NONE.with(ColumnGroup.ROUGHNESS_TEXEL);
    /** Tangents. */
    public static final TexelColumns TANGENTS = NONE.with(ColumnGroup.TANGENT);
    public static final TexelColumns ALL = ColumnGroup.BY_MATERIAL.stream().map(NONE::with).reduce(NONE, TexelColumns::or);

    /** Returns these and the columns of a group. */
    TexelColumns with(ColumnGroup group) {
        return new TexelColumns(bits | 1 << group.ordinal());
    }

    /** Returns what the runs of some rows have. */
    static TexelColumns of(MaterialTable materials, HitRows rows) {
        TexelColumns found = NONE;
        for (int r = 0; r < rows.runCount; r++) {
            found = found.or(materials.texels(rows.runMaterial[r]));
        }
        return found;
    }

    /** Returns which images a material has, and tangents if it is anisotropic. */
    static TexelColumns of(Material material) {
        TexelColumns found = material.isAnisotropic() ? TANGENTS : NONE;
        for (ColumnGroup group : ColumnGroup.TEXELS) {
            found = group.isIn(material) ? found.with(group) : found;
        }
        return found;
    }

    /** Returns what rows of any material may have: colors of vertices, and its images. */
    public static TexelColumns ofAny(Collection<Material> materials) {
        return materials.stream().map(TexelColumns::of).reduce(COLORS, TexelColumns::or);
    }

    /** Returns what either has. */
    public TexelColumns or(TexelColumns o) {
        return new TexelColumns(bits | o.bits);
    }

    /** Returns what both have. */
    TexelColumns and(TexelColumns o) {
        return new TexelColumns(bits & o.bits);
    }

    /** Returns whether rows have the columns of a group. */
    public boolean has(ColumnGroup group) {
        return (bits >> group.ordinal() & 1) != 0;
    }

    /** Returns the groups of columns. */
    List<ColumnGroup> groups() {
        return ColumnGroup.BY_MATERIAL.stream().filter(this::has).toList();
    }

    /** Returns the bytes of a row. */
    public int bytesPerRow() {
        return groups().stream().mapToInt(ColumnGroup::bytesPerRow).sum();
    }

    /** Returns whether rows have none. */
    public boolean isNone() {
        return bits == 0;
    }
}
