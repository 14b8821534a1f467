package lightning.trace;

/**
 * Hit rows of one tile at one level: what the first pass learned of each ray that hit something, in
 * plain columns that share one index.
 *
 * <p>Rows are sorted by material, reflective materials first; each material's rows are one
 * <em>run</em>, whose colours are read once. Columns are a little longer than {@link #count}, so that
 * lanes may run over the end; what stands there is never used.
 */
public final class HitRows {
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
    /** How many runs there are. */
    public int runs;
    /** The material of each run. */
    public int[] runMaterial = new int[4];
    /** The row after each run's last. */
    public int[] runEnd = new int[4];
    /** How many rows, the first ones, are of reflective materials. */
    public int reflective;
    /** Of the points, once someone asked; whoever writes other points forgets it. */
    PointBox box;

    /** Makes room for {@code rows} rows without codes. */
    public HitRows(int rows, boolean textured) {
        this(rows, textured, false);
    }

    /** Makes room for {@code rows} rows. */
    public HitRows(int rows, boolean textured, boolean coded) {
        int length = padded(rows);
        px = new float[length];
        py = new float[length];
        pz = new float[length];
        nx = new float[length];
        ny = new float[length];
        nz = new float[length];
        vx = new float[length];
        vy = new float[length];
        vz = new float[length];
        texelRed = textured ? new float[length] : null;
        texelGreen = textured ? new float[length] : null;
        texelBlue = textured ? new float[length] : null;
        parent = new short[length];
        code = coded ? new int[length] : null;
    }

    /** The same rows with other texels, all three null for none, other codes, other parents and other materials that mirror. */
    private HitRows(HitRows o, float[] red, float[] green, float[] blue, int[] codes, short[] parents, int mirrors) {
        count = o.count;
        px = o.px;
        py = o.py;
        pz = o.pz;
        nx = o.nx;
        ny = o.ny;
        nz = o.nz;
        vx = o.vx;
        vy = o.vy;
        vz = o.vz;
        texelRed = red;
        texelGreen = green;
        texelBlue = blue;
        parent = parents;
        code = codes;
        runs = o.runs;
        runMaterial = o.runMaterial;
        runEnd = o.runEnd;
        reflective = mirrors;
        box = o.box;
    }

    /** These rows without texels. */
    HitRows withoutTexels() {
        return new HitRows(this, null, null, null, code, parent, reflective);
    }

    /** These rows with texels of their own, copies of these. */
    HitRows withOwnTexels() {
        int length = parent.length;
        return texelRed == null
                ? new HitRows(this, new float[length], new float[length], new float[length], code, parent, reflective)
                : new HitRows(this, texelRed.clone(), texelGreen.clone(), texelBlue.clone(), code, parent, reflective);
    }

    /** These rows with other codes, or null for none. */
    public HitRows withCode(int[] to) {
        return new HitRows(this, texelRed, texelGreen, texelBlue, to, parent, reflective);
    }

    /** These rows, in this order, seen from other parents, with other materials that mirror. */
    HitRows seenFrom(short[] parents, int mirrors) {
        return new HitRows(this, texelRed, texelGreen, texelBlue, code, parents, mirrors);
    }

    /** The length of a column of {@code rows} rows: a multiple of 16. */
    public static int padded(int rows) {
        return (rows + 15) & ~15;
    }

    /** The first row of run {@code r}. */
    public int runStart(int r) {
        return r == 0 ? 0 : runEnd[r - 1];
    }

    /** Where the points lie; there must be a row. */
    public PointBox box() {
        if (box == null) {
            box = new PointBox(px, py, pz, count);
        }
        return box;
    }

    /** The bytes of the columns, array headers left out: 38 for each row, 12 more where the tile is textured, 4 with codes. */
    public long bytes() {
        return (38L + (texelRed == null ? 0 : 12) + (code == null ? 0 : 4)) * parent.length;
    }

    void addRun(int material, int end) {
        if (runs == runEnd.length) {
            runMaterial = java.util.Arrays.copyOf(runMaterial, 2 * runs);
            runEnd = java.util.Arrays.copyOf(runEnd, 2 * runs);
        }
        runMaterial[runs] = material;
        runEnd[runs++] = end;
    }
}
