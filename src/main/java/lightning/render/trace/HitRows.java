package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.render.column.ColumnKind;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnSet;
import lightning.render.column.ColumnWriter;
import lightning.render.column.ElementType;
import lightning.render.trace.tree.PointBox;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import org.jspecify.annotations.Nullable;

/**
 * Hits of one tile at one level as columns that share one index: the cached result of the visibility pass.
 *
 * <p>Rows are sorted by material, reflective materials first. Each material's rows form one <em>run</em>, whose colors are read
 * once. Columns are padded beyond {@link #count} so that lanes may overrun the end; the padding is never used.
 */
public final class HitRows {
    /** Columns that exist under the same condition. */
    public enum ColumnGroup {
        /** Always present. */
        HIT,
        /** Present if any row's material is textured. */
        TEXEL(MaterialAttribute.TEXTURE),
        /** Present if any row's material has a glow map. */
        GLOW_TEXEL(MaterialAttribute.GLOW_MAP),
        /** Present if any row's material has a roughness map. */
        ROUGHNESS_TEXEL(MaterialAttribute.ROUGHNESS_MAP, MaterialAttribute.ROUGHNESS_CHANNEL),
        /** Present if any row's material has a metalness map. */
        METALNESS_TEXEL(MaterialAttribute.METALNESS_MAP, MaterialAttribute.METALNESS_CHANNEL),
        /** Present if any row's material is anisotropic. */
        TANGENT,
        /** Present if any row's material has a map of f0. */
        F0_TEXEL(MaterialAttribute.F0_MAP, MaterialAttribute.F0_CHANNEL),
        /** Present if any row's material has a map of its specular tint. */
        SPECULAR_TINT_TEXEL(MaterialAttribute.SPECULAR_TINT_MAP),
        /** Present if any row's material has a map of its coat's weight. */
        COAT_TEXEL(MaterialAttribute.COAT_MAP, MaterialAttribute.COAT_CHANNEL),
        /** Present if any row's material has a map of its coat's roughness. */
        COAT_ROUGHNESS_TEXEL(MaterialAttribute.COAT_ROUGHNESS_MAP, MaterialAttribute.COAT_ROUGHNESS_CHANNEL),
        /** Present if the coat of any row's material has other normals than the surface: components x, y and z. */
        COAT_NORMAL(MaterialAttribute.COAT_NORMAL_MAP),
        /** Present if any row's material has a map of its sheen's color. */
        SHEEN_TEXEL(MaterialAttribute.SHEEN_MAP),
        /** Present if any row's material has a map of its sheen's roughness. */
        SHEEN_ROUGHNESS_TEXEL(MaterialAttribute.SHEEN_ROUGHNESS_MAP, MaterialAttribute.SHEEN_ROUGHNESS_CHANNEL),
        /** Present in rows of finer samples. */
        PATTERN,
        /** Present if a light of the scene illuminates only some shapes. */
        OWNER,
        /** Present if any row's material is transparent. */
        TRANSPARENT;

        /** Groups for the colors of images of the materials: red, green and blue each, or the one channel that a map reads. */
        public static final List<ColumnGroup> TEXELS = Arrays.stream(values()).filter(group -> group.map != null).toList();

        /** Groups that exist if the material of any row needs them: those of {@link #TEXELS}, and tangents. */
        static final List<ColumnGroup> BY_MATERIAL =
                Arrays.stream(values()).filter(group -> group.map != null || group == TANGENT).toList();

        /** Image whose colors the columns contain; null if they contain something else. */
        private final @Nullable MaterialAttribute<Optional<TextureMap>> map;
        /** Channel of the image that the only column contains; null if there are columns for all channels. */
        private final @Nullable MaterialAttribute<TextureChannel> channel;

        ColumnGroup() {
            this(null, null);
        }

        ColumnGroup(MaterialAttribute<Optional<TextureMap>> map) {
            this(map, null);
        }

        ColumnGroup(@Nullable MaterialAttribute<Optional<TextureMap>> map, @Nullable MaterialAttribute<TextureChannel> channel) {
            this.map = map;
            this.channel = channel;
        }

        /** Returns the attribute whose image the columns contain; empty if they contain something else. */
        public Optional<MaterialAttribute<Optional<TextureMap>>> map() {
            return Optional.ofNullable(map);
        }

        /** Returns whether rows of a material have the columns of one of {@link #TEXELS}. */
        boolean isIn(Material material) {
            return this == COAT_NORMAL ? material.hasCoatNormals() : map(material).isPresent();
        }

        /** Returns a material's image for the columns of one of {@link #TEXELS}. */
        Optional<TextureMap> map(Material material) {
            return requireNonNull(map).get(material);
        }

        /** Returns the channel of a material's image in the first column of one of {@link #TEXELS}; the next columns have the next channels. */
        int firstChannel(Material material) {
            return channel == null ? 0 : channel.get(material).ordinal();
        }

        /** Returns the number of columns. */
        public int columnCount() {
            return COLUMNS[ordinal()].length;
        }

        /** Returns the columns of this group. */
        Set<Column> columns() {
            Set<Column> columns = EnumSet.allOf(Column.class);
            columns.removeIf(column -> column.group != this);
            return columns;
        }

        /** Returns the bytes per row of these columns. */
        public int bytesPerRow() {
            return ColumnKind.bytesPerRow(columns());
        }
    }

    /** All columns. Code that allocates, counts, shares or splices rows handles exactly these. */
    public enum Column implements ColumnKind {
        PX(ColumnGroup.HIT, ElementType.FLOAT),
        PY(ColumnGroup.HIT, ElementType.FLOAT),
        PZ(ColumnGroup.HIT, ElementType.FLOAT),
        NX(ColumnGroup.HIT, ElementType.FLOAT),
        NY(ColumnGroup.HIT, ElementType.FLOAT),
        NZ(ColumnGroup.HIT, ElementType.FLOAT),
        VX(ColumnGroup.HIT, ElementType.FLOAT),
        VY(ColumnGroup.HIT, ElementType.FLOAT),
        VZ(ColumnGroup.HIT, ElementType.FLOAT),
        TEXEL_RED(ColumnGroup.TEXEL, ElementType.FLOAT),
        TEXEL_GREEN(ColumnGroup.TEXEL, ElementType.FLOAT),
        TEXEL_BLUE(ColumnGroup.TEXEL, ElementType.FLOAT),
        GLOW_TEXEL_RED(ColumnGroup.GLOW_TEXEL, ElementType.FLOAT),
        GLOW_TEXEL_GREEN(ColumnGroup.GLOW_TEXEL, ElementType.FLOAT),
        GLOW_TEXEL_BLUE(ColumnGroup.GLOW_TEXEL, ElementType.FLOAT),
        ROUGHNESS_TEXEL(ColumnGroup.ROUGHNESS_TEXEL, ElementType.FLOAT),
        METALNESS_TEXEL(ColumnGroup.METALNESS_TEXEL, ElementType.FLOAT),
        TANGENT_X(ColumnGroup.TANGENT, ElementType.FLOAT),
        TANGENT_Y(ColumnGroup.TANGENT, ElementType.FLOAT),
        TANGENT_Z(ColumnGroup.TANGENT, ElementType.FLOAT),
        PARENT(ColumnGroup.HIT, ElementType.SHORT),
        PATTERN(ColumnGroup.PATTERN, ElementType.BYTE),
        OWNER(ColumnGroup.OWNER, ElementType.INT),
        BACK_X(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        BACK_Y(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        BACK_Z(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        INSIDE_DISTANCE(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        // Last, as column sets end with the last column that exists.
        F0_TEXEL(ColumnGroup.F0_TEXEL, ElementType.FLOAT),
        SPECULAR_TINT_TEXEL_RED(ColumnGroup.SPECULAR_TINT_TEXEL, ElementType.FLOAT),
        SPECULAR_TINT_TEXEL_GREEN(ColumnGroup.SPECULAR_TINT_TEXEL, ElementType.FLOAT),
        SPECULAR_TINT_TEXEL_BLUE(ColumnGroup.SPECULAR_TINT_TEXEL, ElementType.FLOAT),
        COAT_TEXEL(ColumnGroup.COAT_TEXEL, ElementType.FLOAT),
        COAT_ROUGHNESS_TEXEL(ColumnGroup.COAT_ROUGHNESS_TEXEL, ElementType.FLOAT),
        COAT_NX(ColumnGroup.COAT_NORMAL, ElementType.FLOAT),
        COAT_NY(ColumnGroup.COAT_NORMAL, ElementType.FLOAT),
        COAT_NZ(ColumnGroup.COAT_NORMAL, ElementType.FLOAT),
        SHEEN_TEXEL_RED(ColumnGroup.SHEEN_TEXEL, ElementType.FLOAT),
        SHEEN_TEXEL_GREEN(ColumnGroup.SHEEN_TEXEL, ElementType.FLOAT),
        SHEEN_TEXEL_BLUE(ColumnGroup.SHEEN_TEXEL, ElementType.FLOAT),
        SHEEN_ROUGHNESS_TEXEL(ColumnGroup.SHEEN_ROUGHNESS_TEXEL, ElementType.FLOAT);

        private final ColumnGroup group;
        private final ElementType element;

        Column(ColumnGroup group, ElementType element) {
            this.group = group;
            this.element = element;
        }

        @Override
        public ElementType element() {
            return element;
        }
    }

    /** Columns of each group, by its ordinal. */
    private static final Column[][] COLUMNS =
            Arrays.stream(ColumnGroup.values()).map(group -> group.columns().toArray(Column[]::new)).toArray(Column[][]::new);

    /** Columns that often have one value for all rows of a tile. */
    private static final Set<Column> OFTEN_UNIFORM = EnumSet.of(Column.PX, Column.PY, Column.PZ, Column.NX, Column.NY, Column.NZ);

    /** Number of rows in use. */
    public int count;
    /** Points, offset from the surface, render space. */
    public final float[] px;
    public final float[] py;
    public final float[] pz;
    /** Unit normals, facing the ray. */
    public final float[] nx;
    public final float[] ny;
    public final float[] nz;
    /** Unit directions of the rays. */
    public final float[] vx;
    public final float[] vy;
    public final float[] vz;
    /** Texture color, 0…1, of rows with textured materials; null if the tile has none. */
    public final float @Nullable [] texelRed;
    public final float @Nullable [] texelGreen;
    public final float @Nullable [] texelBlue;
    /** Unit tangents of rows with anisotropic materials, perpendicular to the normals, before any rotation; null if the tile has none. */
    public final float @Nullable [] tangentX;
    public final float @Nullable [] tangentY;
    public final float @Nullable [] tangentZ;
    /** Destination of the row's color: a pixel of the tile at the first level, a row of the previous level at others. */
    public final short[] parent;
    /** Pattern of area light samples of each row of finer samples, unsigned ({@link SamplePattern}); null for pixel centers. */
    public final byte @Nullable [] pattern;
    /** Primitive that was hit; null if unused. */
    public final int @Nullable [] owner;
    /** Points behind the surface for rows of transparent materials, offset from it, render space; null if the tile has none. */
    public final float @Nullable [] backX;
    public final float @Nullable [] backY;
    public final float @Nullable [] backZ;
    /** Length of the ray inside the body for rows of transparent materials, scene units; below 0 if it came from outside. */
    public final float @Nullable [] insideDistance;
    /** Number of runs. */
    public int runCount;
    /** Material of each run. */
    public int[] runMaterial = new int[4];
    /** Exclusive end row of each run. */
    public int[] runEnd = new int[4];
    /** Number of rows with reflective materials; they come first. */
    public int reflectiveCount;
    /** Number of rows with transparent materials; they come first, and all of them are reflective. */
    public int clearCount;
    /** Bounds of the points, computed on first use; code that overwrites the points must reset it. */
    @Nullable
    PointBox bounds;

    private final ColumnSet<Column> columns;

    /** Allocates {@code rows} rows of pixel centers without owners. */
    public HitRows(int rows, TexelColumns texels) {
        this(rows, texels, false, false, false);
    }

    /** Allocates {@code rows} rows. */
    public HitRows(int rows, TexelColumns texels, boolean transparent, boolean hasPatterns, boolean hasOwners) {
        this(ColumnSet.allocate(Column.class, columns(texels, transparent, hasPatterns, hasOwners), rows));
    }

    /** Wraps columns that are already filled; there are no runs yet. */
    HitRows(ColumnSet<Column> columns) {
        this.columns = columns;
        px = (float[]) columns.get(Column.PX);
        py = (float[]) columns.get(Column.PY);
        pz = (float[]) columns.get(Column.PZ);
        nx = (float[]) columns.get(Column.NX);
        ny = (float[]) columns.get(Column.NY);
        nz = (float[]) columns.get(Column.NZ);
        vx = (float[]) columns.get(Column.VX);
        vy = (float[]) columns.get(Column.VY);
        vz = (float[]) columns.get(Column.VZ);
        texelRed = (float[]) columns.find(Column.TEXEL_RED);
        texelGreen = (float[]) columns.find(Column.TEXEL_GREEN);
        texelBlue = (float[]) columns.find(Column.TEXEL_BLUE);
        tangentX = (float[]) columns.find(Column.TANGENT_X);
        tangentY = (float[]) columns.find(Column.TANGENT_Y);
        tangentZ = (float[]) columns.find(Column.TANGENT_Z);
        parent = (short[]) columns.get(Column.PARENT);
        pattern = (byte[]) columns.find(Column.PATTERN);
        owner = (int[]) columns.find(Column.OWNER);
        backX = (float[]) columns.find(Column.BACK_X);
        backY = (float[]) columns.find(Column.BACK_Y);
        backZ = (float[]) columns.find(Column.BACK_Z);
        insideDistance = (float[]) columns.find(Column.INSIDE_DISTANCE);
    }

    private static Set<Column> columns(TexelColumns texels, boolean transparent, boolean hasPatterns, boolean hasOwners) {
        Set<Column> columns = ColumnGroup.HIT.columns();
        columns.addAll(columns(texels));
        if (transparent) {
            columns.addAll(ColumnGroup.TRANSPARENT.columns());
        }
        if (hasPatterns) {
            columns.addAll(ColumnGroup.PATTERN.columns());
        }
        if (hasOwners) {
            columns.addAll(ColumnGroup.OWNER.columns());
        }
        return columns;
    }

    private static Set<Column> columns(TexelColumns texels) {
        Set<Column> columns = EnumSet.noneOf(Column.class);
        texels.groups().forEach(group -> columns.addAll(group.columns()));
        return columns;
    }

    /** Returns these rows with other columns and another number of reflective rows. */
    private HitRows withColumns(ColumnSet<Column> others, int newReflectiveCount) {
        HitRows rows = new HitRows(others);
        rows.count = count;
        rows.runCount = runCount;
        rows.runMaterial = runMaterial;
        rows.runEnd = runEnd;
        rows.reflectiveCount = newReflectiveCount;
        rows.clearCount = clearCount;
        rows.bounds = bounds;
        return rows;
    }

    /** Returns these rows with shared columns where all points or normals have equal coordinates. */
    public HitRows compact() {
        ColumnSet<Column> shared = columns.withUniform(OFTEN_UNIFORM, count);
        return shared == columns ? this : withColumns(shared, reflectiveCount);
    }

    /** Returns which texels these rows have. */
    TexelColumns texels() {
        TexelColumns found = TexelColumns.NONE;
        for (ColumnGroup group : ColumnGroup.BY_MATERIAL) {
            found = texel(group, 0) == null ? found : found.with(group);
        }
        return found;
    }

    /** Returns these rows with copies of some texels, 0 where these rows have none, and without the others. */
    HitRows withCopiedTexels(TexelColumns texels) {
        ColumnSet<Column> copies = ColumnSet.allocate(Column.class, columns(texels), count);
        copies.copy(columns, 0, 0, count);
        return withColumns(columns.without(columns(TexelColumns.ALL)).with(copies), reflectiveCount);
    }

    /** Returns these rows with other owners, or null for none. */
    public HitRows withOwner(int @Nullable [] to) {
        return withColumns(columns.with(Column.OWNER, to), reflectiveCount);
    }

    /**
     * Returns the owners of rows that were traced earlier, possibly in another order. Matches rays by their parents; 0 for rays
     * that now hit nothing.
     */
    public int[] ownersFor(HitRows otherRows) {
        assert owner != null;
        int[] ownerByParent = new int[RayColumns.MAX_RAYS];
        for (int i = 0; i < count; i++) {
            ownerByParent[parent[i]] = owner[i];
        }
        int[] owners = new int[ElementType.INT.length(otherRows.count)];
        for (int i = 0; i < otherRows.count; i++) {
            owners[i] = ownerByParent[otherRows.parent[i]];
        }
        return owners;
    }

    /** Returns these rows in this order with other parents and another number of reflective rows. */
    HitRows withParents(short[] parents, int newReflectiveCount) {
        return withColumns(columns.with(Column.PARENT, parents), newReflectiveCount);
    }

    /** Returns these rows with the normals of their coats, in the rows whose materials have some. */
    public HitRows withCoatNormals() {
        return withColumns(columns.with(Column.NX, requireNonNull(columns.find(Column.COAT_NX)))
                .with(Column.NY, requireNonNull(columns.find(Column.COAT_NY)))
                .with(Column.NZ, requireNonNull(columns.find(Column.COAT_NZ))),
                reflectiveCount);
    }

    /** Returns the length of a float column for {@code rows} rows: a multiple of 16. */
    public static int paddedLength(int rows) {
        return ElementType.FLOAT.length(rows);
    }

    /**
     * Returns red, green or blue of an image for column 0, 1, 2, ≥ 0, in the rows whose materials have it; null if the tile has none. Column
     * 0 of a map that reads one channel has this channel.
     *
     * @param group one of {@link ColumnGroup#TEXELS}, or {@link ColumnGroup#TANGENT} with columns x, y, z
     */
    public float @Nullable [] texel(ColumnGroup group, int column) {
        return (float[]) columns.find(COLUMNS[group.ordinal()][column]);
    }

    /** Returns the columns of an image that these rows have, as {@link #texel(ColumnGroup, int)}. */
    public float[][] texels(ColumnGroup group) {
        float[][] texels = new float[group.columnCount()][];
        for (int c = 0; c < texels.length; c++) {
            texels[c] = requireNonNull(texel(group, c));
        }
        return texels;
    }

    /** Returns the red, green or blue texels for channel 0, 1, 2; null if the tile has none. */
    public float @Nullable [] texel(int channel) {
        return switch (channel) {
            case 0 -> texelRed;
            case 1 -> texelGreen;
            case 2 -> texelBlue;
            default -> throw new IllegalArgumentException("channel " + channel);
        };
    }

    /** Writes the rows. */
    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(count);
        out.writeInt(reflectiveCount);
        out.writeInt(clearCount);
        out.writeArray(Arrays.copyOf(runMaterial, runCount));
        out.writeArray(Arrays.copyOf(runEnd, runCount));
        out.writeColumns(columns);
    }

    /**
     * Reads rows.
     *
     * @throws IOException if the data is truncated
     */
    public static HitRows readFrom(ColumnReader in) throws IOException {
        int count = in.readInt();
        int reflectiveCount = in.readInt();
        int clearCount = in.readInt();
        int[] runMaterial = in.readInts();
        int[] runEnd = in.readInts();
        HitRows rows = new HitRows(in.readColumns(Column.class));
        rows.count = count;
        rows.reflectiveCount = reflectiveCount;
        rows.clearCount = clearCount;
        for (int r = 0; r < runEnd.length; r++) {
            rows.addRun(runMaterial[r], runEnd[r]);
        }
        return rows.compact();
    }

    /** Returns the columns that are present. */
    ColumnSet<Column> columns() {
        return columns;
    }

    /** Returns the first row of run {@code r}. */
    public int runStart(int r) {
        return r == 0 ? 0 : runEnd[r - 1];
    }

    /** Returns the material of a row. */
    public int material(int row) {
        int r = 0;
        while (row >= runEnd[r]) {
            r++;
        }
        return runMaterial[r];
    }

    /** Returns whether the ray reached a row of a transparent material from inside. */
    public boolean isInside(int row) {
        assert insideDistance != null;
        return insideDistance[row] >= 0;
    }

    /** Removes all rows, so that other points can be written. */
    public void clear() {
        count = 0;
        bounds = null;
    }

    /** Returns the bounds of the points; there must be at least one row. */
    public PointBox bounds(Tracer tracer) {
        if (bounds == null) {
            bounds = tracer.bounds(px, py, pz, 0, count);
        }
        return bounds;
    }

    /** Returns the bytes of the columns without array headers. */
    public long bytes() {
        return columns.bytes();
    }

    /** Returns the bytes of the columns of a group. */
    public long bytes(ColumnGroup group) {
        long bytes = 0;
        for (Column column : group.columns()) {
            bytes += columns.bytes(column);
        }
        return bytes;
    }

    /** Appends a run of a material that ends before row {@code end}. */
    public void addRun(int material, int end) {
        if (runCount == runEnd.length) {
            runMaterial = Arrays.copyOf(runMaterial, 2 * runCount);
            runEnd = Arrays.copyOf(runEnd, 2 * runCount);
        }
        runMaterial[runCount] = material;
        runEnd[runCount++] = end;
    }
}
