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
 * <em>run</em>, whose colours are read once. Columns are a little longer than {@link #count}, so that
 * lanes may run over the end; what stands there is never used.
 */
public final class HitRows {
    /** When a tile's rows have a column. */
    public enum Part {
        /** Always. */
        HIT,
        /** Where any row's material is textured. */
        TEXEL,
        /** Where anti-aliasing looks for edges. */
        CODE,
        /** Where a light of the scene shines on some shapes only. */
        OWNER,
        /** Where any row's material is clear. */
        CLEAR;

        /** The columns that come and go together. */
        Set<Column> columns() {
            Set<Column> columns = EnumSet.allOf(Column.class);
            columns.removeIf(column -> column.part != this);
            return columns;
        }

        /** The bytes of a row in them. */
        public int bytesPerRow() {
            return ColumnKind.bytesPerRow(columns());
        }
    }

    /** All columns that there are: what makes, counts, shares and splices rows knows no others. */
    public enum Column implements ColumnKind {
        PX(Part.HIT, ElementType.FLOAT),
        PY(Part.HIT, ElementType.FLOAT),
        PZ(Part.HIT, ElementType.FLOAT),
        NX(Part.HIT, ElementType.FLOAT),
        NY(Part.HIT, ElementType.FLOAT),
        NZ(Part.HIT, ElementType.FLOAT),
        VX(Part.HIT, ElementType.FLOAT),
        VY(Part.HIT, ElementType.FLOAT),
        VZ(Part.HIT, ElementType.FLOAT),
        TEXEL_RED(Part.TEXEL, ElementType.FLOAT),
        TEXEL_GREEN(Part.TEXEL, ElementType.FLOAT),
        TEXEL_BLUE(Part.TEXEL, ElementType.FLOAT),
        PARENT(Part.HIT, ElementType.SHORT),
        CODE(Part.CODE, ElementType.INT),
        OWNER(Part.OWNER, ElementType.INT),
        BEHIND_X(Part.CLEAR, ElementType.FLOAT),
        BEHIND_Y(Part.CLEAR, ElementType.FLOAT),
        BEHIND_Z(Part.CLEAR, ElementType.FLOAT),
        INSIDE(Part.CLEAR, ElementType.FLOAT);

        private final Part part;
        private final ElementType element;

        Column(Part part, ElementType element) {
            this.part = part;
            this.element = element;
        }

        @Override
        public ElementType element() {
            return element;
        }
    }

    /** Those that are often the same on all rows of a tile. */
    private static final Set<Column> UNIFORM = EnumSet.of(Column.PX, Column.PY, Column.PZ, Column.NX, Column.NY, Column.NZ);

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
    /** The texture's colour, 0…1, for rows of textured materials; null where the tile has none. */
    public final float[] texelRed;
    public final float[] texelGreen;
    public final float[] texelBlue;
    /** Where the row's colour goes: a pixel of the tile at the first level, a row of the level above at others. */
    public final short[] parent;
    /** What anti-aliasing sees of each hit, its texture left out ({@link HitCode}); null where nobody asks. */
    public final int[] code;
    /** The primitive that was hit; null where nobody asks. */
    public final int[] owner;
    /** Of rows of clear materials the points behind the surface, off it, render space; null where the tile has none. */
    public final float[] behindX;
    public final float[] behindY;
    public final float[] behindZ;
    /** Of rows of clear materials the way that the ray came inside, scene units; below 0 where it came from outside. */
    public final float[] inside;
    /** How many runs there are. */
    public int runs;
    /** The material of each run. */
    public int[] runMaterial = new int[4];
    /** The row after each run's last. */
    public int[] runEnd = new int[4];
    /** How many rows, the first ones, are of reflective materials. */
    public int reflective;
    /** How many rows, the first ones, are of clear materials; all of them are reflective. */
    public int clear;
    /** Of the points, once someone asked; whoever writes other points forgets it. */
    PointBox box;

    private final ColumnSet<Column> columns;

    /** Makes room for {@code rows} rows without codes and owners. */
    public HitRows(int rows, boolean textured) {
        this(rows, textured, false, false, false);
    }

    /** Makes room for {@code rows} rows. */
    public HitRows(int rows, boolean textured, boolean clear, boolean coded, boolean owned) {
        this(ColumnSet.room(Column.class, columns(textured, clear, coded, owned), rows));
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
        behindX = (float[]) columns.get(Column.BEHIND_X);
        behindY = (float[]) columns.get(Column.BEHIND_Y);
        behindZ = (float[]) columns.get(Column.BEHIND_Z);
        inside = (float[]) columns.get(Column.INSIDE);
    }

    private static Set<Column> columns(boolean textured, boolean clear, boolean coded, boolean owned) {
        Set<Column> columns = Part.HIT.columns();
        if (textured) {
            columns.addAll(Part.TEXEL.columns());
        }
        if (clear) {
            columns.addAll(Part.CLEAR.columns());
        }
        if (coded) {
            columns.addAll(Part.CODE.columns());
        }
        if (owned) {
            columns.addAll(Part.OWNER.columns());
        }
        return columns;
    }

    /** The same rows in other columns, with other materials that mirror. */
    private HitRows in(ColumnSet<Column> others, int mirrors) {
        HitRows rows = new HitRows(others);
        rows.count = count;
        rows.runs = runs;
        rows.runMaterial = runMaterial;
        rows.runEnd = runEnd;
        rows.reflective = mirrors;
        rows.clear = clear;
        rows.box = box;
        return rows;
    }

    /** These rows, with columns that others share where all points or normals have one coordinate. */
    public HitRows compact() {
        ColumnSet<Column> shared = columns.withUniform(UNIFORM, count);
        return shared == columns ? this : in(shared, reflective);
    }

    /** These rows without texels. */
    HitRows withoutTexels() {
        return in(columns.without(Part.TEXEL.columns()), reflective);
    }

    /** These rows with texels of their own, copies of these. */
    HitRows withOwnTexels() {
        ColumnSet<Column> own = ColumnSet.room(Column.class, Part.TEXEL.columns(), count);
        own.copy(columns, 0, 0, count);
        return in(columns.with(own), reflective);
    }

    /** These rows with other codes, or null for none. */
    public HitRows withCode(int[] to) {
        return in(columns.with(Column.CODE, to), reflective);
    }

    /** These rows with other owners, or null for none. */
    public HitRows withOwner(int[] to) {
        return in(columns.with(Column.OWNER, to), reflective);
    }

    /**
     * The owners of rows that were traced before these, perhaps in another order, whose rays are known by their parents; 0 for rays
     * that hit nothing now.
     */
    public int[] ownersOf(HitRows rows) {
        int[] of = new int[RayColumns.MOST];
        for (int i = 0; i < count; i++) {
            of[parent[i]] = owner[i];
        }
        int[] owners = new int[ElementType.INT.length(rows.count)];
        for (int i = 0; i < rows.count; i++) {
            owners[i] = of[rows.parent[i]];
        }
        return owners;
    }

    /** These rows, in this order, seen from other parents, with other materials that mirror. */
    HitRows seenFrom(short[] parents, int mirrors) {
        return in(columns.with(Column.PARENT, parents), mirrors);
    }

    /** The length of a column of floats for {@code rows} rows: a multiple of 16. */
    public static int padded(int rows) {
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
        out.number(count);
        out.number(reflective);
        out.number(clear);
        out.array(Arrays.copyOf(runMaterial, runs));
        out.array(Arrays.copyOf(runEnd, runs));
        out.columns(columns);
    }

    /**
     * Reads rows.
     *
     * @throws IOException if they are cut off
     */
    public static HitRows readFrom(ColumnReader in) throws IOException {
        int count = in.number();
        int reflective = in.number();
        int clear = in.number();
        int[] runMaterial = in.ints();
        int[] runEnd = in.ints();
        HitRows rows = new HitRows(in.columns(Column.class));
        rows.count = count;
        rows.reflective = reflective;
        rows.clear = clear;
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
        return inside[row] >= 0;
    }

    /** Where the points lie; there must be a row. */
    public PointBox box(Tracer tracer) {
        if (box == null) {
            box = tracer.box(px, py, pz, 0, count);
        }
        return box;
    }

    /** The bytes of the columns, array headers left out. */
    public long bytes() {
        return columns.bytes();
    }

    /** The bytes of the columns of a part. */
    public long bytes(Part part) {
        long bytes = 0;
        for (Column column : part.columns()) {
            bytes += columns.bytes(column);
        }
        return bytes;
    }

    void addRun(int material, int end) {
        if (runs == runEnd.length) {
            runMaterial = Arrays.copyOf(runMaterial, 2 * runs);
            runEnd = Arrays.copyOf(runEnd, 2 * runs);
        }
        runMaterial[runs] = material;
        runEnd[runs++] = end;
    }
}
