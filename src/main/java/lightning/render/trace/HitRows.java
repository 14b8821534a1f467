package lightning.render.trace;

import java.io.IOException;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import lightning.render.column.ColumnKind;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnSet;
import lightning.render.column.ColumnWriter;
import lightning.render.column.ElementType;
import lightning.render.trace.tree.PointBox;

/**
 * Hit rows of one tile at one level: what the first pass learned of each ray that hit something, in
 * plain columns that share one index.
 *
 * <p>Rows are sorted by material, reflective materials first; each material's rows are one
 * <em>run</em>, whose colors are read once. Columns are a little longer than {@link #count}, so that
 * lanes may run over the end; what stands there is never used.
 */
public final class HitRows {
    /** When a tile's rows have a column. */
    public enum ColumnGroup {
        /** Always. */
        HIT,
        /** Where any row's material is textured. */
        TEXEL,
        /** Where anti-aliasing looks for edges. */
        CODE,
        /** Where a light of the scene shines on some shapes only. */
        OWNER,
        /** Where any row's material is clear. */
        TRANSPARENT;

        /** The columns that come and go together. */
        Set<Column> columns() {
            Set<Column> columns = EnumSet.allOf(Column.class);
            columns.removeIf(column -> column.group != this);
            return columns;
        }

        /** The bytes of a row in them. */
        public int bytesPerRow() {
            return ColumnKind.bytesPerRow(columns());
        }
    }

    /** All columns that there are: what makes, counts, shares and splices rows knows no others. */
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
        PARENT(ColumnGroup.HIT, ElementType.SHORT),
        CODE(ColumnGroup.CODE, ElementType.INT),
        OWNER(ColumnGroup.OWNER, ElementType.INT),
        BACK_X(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        BACK_Y(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        BACK_Z(ColumnGroup.TRANSPARENT, ElementType.FLOAT),
        INSIDE_DISTANCE(ColumnGroup.TRANSPARENT, ElementType.FLOAT);

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

    /** Those that are often the same on all rows of a tile. */
    private static final Set<Column> OFTEN_UNIFORM = EnumSet.of(Column.PX, Column.PY, Column.PZ, Column.NX, Column.NY, Column.NZ);

    /** How many rows are in use. */
    public int count;
    /** Points, off the surface, render space. */
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
    /** The texture's color, 0…1, for rows of textured materials; null where the tile has none. */
    public final float[] texelRed;
    public final float[] texelGreen;
    public final float[] texelBlue;
    /** Where the row's color goes: a pixel of the tile at the first level, a row of the level above at others. */
    public final short[] parent;
    /** What anti-aliasing sees of each hit, its texture left out ({@link HitCode}); null where nobody asks. */
    public final int[] code;
    /** The primitive that was hit; null where nobody asks. */
    public final int[] owner;
    /** Of rows of clear materials the points behind the surface, off it, render space; null where the tile has none. */
    public final float[] backX;
    public final float[] backY;
    public final float[] backZ;
    /** Of rows of clear materials the way that the ray came inside, scene units; below 0 where it came from outside. */
    public final float[] insideDistance;
    /** How many runs there are. */
    public int runCount;
    /** The material of each run. */
    public int[] runMaterial = new int[4];
    /** The row after each run's last. */
    public int[] runEnd = new int[4];
    /** How many rows, the first ones, are of reflective materials. */
    public int reflectiveCount;
    /** How many rows, the first ones, are of clear materials; all of them are reflective. */
    public int transparentCount;
    /** Of the points, once someone asked; whoever writes other points forgets it. */
    PointBox bounds;

    private final ColumnSet<Column> columns;

    /** Makes room for {@code rows} rows without codes and owners. */
    public HitRows(int rows, boolean textured) {
        this(rows, textured, false, false, false);
    }

    /** Makes room for {@code rows} rows. */
    public HitRows(int rows, boolean textured, boolean transparent, boolean hasCodes, boolean hasOwners) {
        this(ColumnSet.allocate(Column.class, columns(textured, transparent, hasCodes, hasOwners), rows));
    }

    /** Rows in columns that are filled already; there are no runs yet. */
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
        texelRed = (float[]) columns.get(Column.TEXEL_RED);
        texelGreen = (float[]) columns.get(Column.TEXEL_GREEN);
        texelBlue = (float[]) columns.get(Column.TEXEL_BLUE);
        parent = (short[]) columns.get(Column.PARENT);
        code = (int[]) columns.get(Column.CODE);
        owner = (int[]) columns.get(Column.OWNER);
        backX = (float[]) columns.get(Column.BACK_X);
        backY = (float[]) columns.get(Column.BACK_Y);
        backZ = (float[]) columns.get(Column.BACK_Z);
        insideDistance = (float[]) columns.get(Column.INSIDE_DISTANCE);
    }

    private static Set<Column> columns(boolean textured, boolean transparent, boolean hasCodes, boolean hasOwners) {
        Set<Column> columns = ColumnGroup.HIT.columns();
        if (textured) {
            columns.addAll(ColumnGroup.TEXEL.columns());
        }
        if (transparent) {
            columns.addAll(ColumnGroup.TRANSPARENT.columns());
        }
        if (hasCodes) {
            columns.addAll(ColumnGroup.CODE.columns());
        }
        if (hasOwners) {
            columns.addAll(ColumnGroup.OWNER.columns());
        }
        return columns;
    }

    /** The same rows in other columns, with other materials that mirror. */
    private HitRows withColumns(ColumnSet<Column> others, int newReflectiveCount) {
        HitRows rows = new HitRows(others);
        rows.count = count;
        rows.runCount = runCount;
        rows.runMaterial = runMaterial;
        rows.runEnd = runEnd;
        rows.reflectiveCount = newReflectiveCount;
        rows.transparentCount = transparentCount;
        rows.bounds = bounds;
        return rows;
    }

    /** These rows, with columns that others share where all points or normals have one coordinate. */
    public HitRows compact() {
        ColumnSet<Column> shared = columns.withUniform(OFTEN_UNIFORM, count);
        return shared == columns ? this : withColumns(shared, reflectiveCount);
    }

    /** These rows without texels. */
    HitRows withoutTexels() {
        return withColumns(columns.without(ColumnGroup.TEXEL.columns()), reflectiveCount);
    }

    /** These rows with texels of their own, copies of these. */
    HitRows withCopiedTexels() {
        ColumnSet<Column> copies = ColumnSet.allocate(Column.class, ColumnGroup.TEXEL.columns(), count);
        copies.copy(columns, 0, 0, count);
        return withColumns(columns.with(copies), reflectiveCount);
    }

    /** These rows with other codes, or null for none. */
    public HitRows withCode(int[] to) {
        return withColumns(columns.with(Column.CODE, to), reflectiveCount);
    }

    /** These rows with other owners, or null for none. */
    public HitRows withOwner(int[] to) {
        return withColumns(columns.with(Column.OWNER, to), reflectiveCount);
    }

    /**
     * The owners of rows that were traced before these, perhaps in another order, whose rays are known by their parents; 0 for rays
     * that hit nothing now.
     */
    public int[] ownersFor(HitRows otherRows) {
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

    /** These rows, in this order, seen from other parents, with other materials that mirror. */
    HitRows withParents(short[] parents, int newReflectiveCount) {
        return withColumns(columns.with(Column.PARENT, parents), newReflectiveCount);
    }

    /** The length of a column of floats for {@code rows} rows: a multiple of 16. */
    public static int paddedLength(int rows) {
        return ElementType.FLOAT.length(rows);
    }

    /** The texels' red, green or blue for channel 0, 1, 2; null where the tile has none. */
    public float[] texel(int channel) {
        return switch (channel) {
            case 0 -> texelRed;
            case 1 -> texelGreen;
            case 2 -> texelBlue;
            default -> throw new IllegalArgumentException("channel " + channel);
        };
    }

    /** Writes all that is known of the rows. */
    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(count);
        out.writeInt(reflectiveCount);
        out.writeInt(transparentCount);
        out.writeArray(Arrays.copyOf(runMaterial, runCount));
        out.writeArray(Arrays.copyOf(runEnd, runCount));
        out.writeColumns(columns);
    }

    /**
     * Reads rows.
     *
     * @throws IOException if they are cut off
     */
    public static HitRows readFrom(ColumnReader in) throws IOException {
        int count = in.readInt();
        int reflectiveCount = in.readInt();
        int transparentCount = in.readInt();
        int[] runMaterial = in.readInts();
        int[] runEnd = in.readInts();
        HitRows rows = new HitRows(in.readColumns(Column.class));
        rows.count = count;
        rows.reflectiveCount = reflectiveCount;
        rows.transparentCount = transparentCount;
        for (int r = 0; r < runEnd.length; r++) {
            rows.addRun(runMaterial[r], runEnd[r]);
        }
        return rows.compact();
    }

    /** The columns that these rows have. */
    ColumnSet<Column> columns() {
        return columns;
    }

    /** The first row of run {@code r}. */
    public int runStart(int r) {
        return r == 0 ? 0 : runEnd[r - 1];
    }

    /** The material of a row. */
    public int material(int row) {
        int r = 0;
        while (row >= runEnd[r]) {
            r++;
        }
        return runMaterial[r];
    }

    /** Whether the ray came to a row of a clear material from inside. */
    public boolean isInside(int row) {
        return insideDistance[row] >= 0;
    }

    /** Where the points lie; there must be a row. */
    public PointBox bounds(Tracer tracer) {
        if (bounds == null) {
            bounds = tracer.bounds(px, py, pz, 0, count);
        }
        return bounds;
    }

    /** The bytes of the columns, array headers left out. */
    public long bytes() {
        return columns.bytes();
    }

    /** The bytes of the columns of a part. */
    public long bytes(ColumnGroup group) {
        long bytes = 0;
        for (Column column : group.columns()) {
            bytes += columns.bytes(column);
        }
        return bytes;
    }

    void addRun(int material, int end) {
        if (runCount == runEnd.length) {
            runMaterial = Arrays.copyOf(runMaterial, 2 * runCount);
            runEnd = Arrays.copyOf(runEnd, 2 * runCount);
        }
        runMaterial[runCount] = material;
        runEnd[runCount++] = end;
    }
}
