package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.render.trace.Tracer;
import lightning.scene.Limits;

/**
 * The second stage for one tile and a light that is larger than a point: its terms are means over samples. Holds scratch memory:
 * one for each thread.
 *
 * <p>Which samples a row's ways are free to is asked for all that it faces as soon as one of them has it in its cone, and kept:
 * no later edit of the cone or of the falloff asks again.
 */
final class AreaKernel {
    private static final int MOST = Limits.MAX_LIGHT_SAMPLES;

    private final LightLinks links;
    /** Who asks for ways to the light at hand. */
    private ShadowCaster shadows;
    private final Tracer tracer;
    private final Terms terms;
    private final TermColumns written;
    private final Demands demands;
    private final RowWays ways = new RowWays();
    /** For each sample the rows that face it, those that it has in its cone, and those with a free way to it. */
    private final int[][] facing = sets();
    private final int[][] inside = sets();
    private final int[][] clear = sets();
    private final int[] chosen = RowBits.room();
    private final int[] metals = RowBits.room();
    private final int[] blocked = RowBits.room();
    private final int[] asked = RowBits.room();
    /** Rows that may face any sample, and those that may have a specular term of any. */
    private final int[] mayFace = RowBits.room();
    private final int[] mayShine = RowBits.room();
    private final int[] shining = RowBits.room();
    private final int[] anyFacing = RowBits.room();
    private final int[] anyInside = RowBits.room();
    private final int[] anyClear = RowBits.room();
    private final int[] anyLit = RowBits.room();
    private final float[] cosine = new float[Terms.ROWS];
    private final float[] falloff = new float[Terms.ROWS];
    private final float[] specular = new float[Terms.ROWS];
    private final float[] grazing = new float[Terms.ROWS];
    private final double[] factors = new double[Terms.ROWS];
    /** As many samples of as many rows as a word and a column of seen samples hold. */
    private final int[] square = new int[RowBits.WIDTH];
    private final double[] diffuseSum = new double[Terms.ROWS];
    private final double[] specularSum = new double[Terms.ROWS];
    private final double[] grazingSum = new double[Terms.ROWS];
    /** Sums of what passes on free ways; made when it is needed first. */
    private double[][] tintSum;
    private boolean tinted;
    /** Whether any of the rows' materials has specular terms, or is metallic; asked once for each tile and light. */
    private boolean shines;
    private boolean metallic;

    AreaKernel(LightLinks links, Tracer tracer, Terms terms, TermColumns written, Demands demands) {
        this.links = links;
        this.tracer = tracer;
        this.terms = terms;
        this.written = written;
        this.demands = demands;
    }

    private static int[][] sets() {
        int[][] sets = new int[MOST][];
        Arrays.setAll(sets, _ -> RowBits.room());
        return sets;
    }

    /** All of it, from nothing. */
    LightRows full(HitRows rows, Lamp lamp, Columns columns) {
        if (!demands.reaches(lamp, rows, tracer) || !links.reaches(lamp, rows)) {
            return LightRows.UNREACHED;
        }
        shadows = links.shadows(lamp);
        byte[] state = columns.states(rows.count);
        Arrays.fill(state, 0, rows.count, LightRows.AWAY);
        turns(rows);
        if (rows.count > 0 && !lamp.type().hasCone()) {
            return atOnce(rows, lamp, state, columns);
        }
        look(rows, lamp);
        for (int s = 0; s < lamp.area().samples(); s++) {
            Arrays.fill(clear[s], 0);
        }
        cast(rows, lamp, anyInside);
        return layer(rows, lamp, state, anyInside, columns).withTint(tints(rows, lamp, anyInside, null, columns));
    }

    /** All of it for a light whose cone no edit changes in place: a sample is aimed at once. */
    private LightRows atOnce(HitRows rows, Lamp lamp, byte[] state, Columns columns) {
        int words = RowBits.words(rows.count);
        begin(rows, lamp);
        shadows.aim(rows, lamp, ways);
        beginTints();
        for (int s = 0; s < lamp.area().samples(); s++) {
            aim(rows, lamp, s, mayFace);
            look(rows, lamp, s);
            cast(rows, lamp, s, inside[s]);
            for (int b = 0; b < words; b++) {
                clear[s][b] = inside[s][b] & ~blocked[b];
                // Of a row whose ways are all blocked it is enough to know that it has one of the samples before it.
                mayFace[b] &= ~(shadows.dark()[b] & anyInside[b]);
            }
            if (tinted) {
                shadows.addTints(rows, ways, lamp.area(), s, clear[s], tintSum);
            }
            add(rows, lamp, s, clear[s]);
        }
        short[][] seen = states(rows, lamp, state, anyInside, columns);
        return means(rows, lamp, state, seen, columns).withTint(tints(rows, lamp, anyInside, null, columns));
    }

    private void begin(HitRows rows, Lamp lamp) {
        Arrays.fill(anyFacing, 0);
        Arrays.fill(anyInside, 0);
        terms.mayFace(rows, lamp, mayFace);
        beginSums(rows, lamp);
    }

    private void beginSums(HitRows rows, Lamp lamp) {
        shines = written.hasSpecular(rows);
        metallic = written.hasMetallic(rows);
        Arrays.fill(diffuseSum, 0);
        Arrays.fill(specularSum, 0);
        if (metallic) {
            Arrays.fill(grazingSum, 0);
        }
        Arrays.fill(mayShine, 0);
        if (shines) {
            written.mayShine(rows, lamp, mayShine);
        }
    }

    /**
     * After an edit that leaves the light where it is.
     *
     * @param cone whether rows may enter or leave the cone; else the falloff alone is another
     */
    LightRows partial(HitRows rows, Lamp lamp, LightRows before, boolean cone, Columns columns) {
        if (!cone) {
            return again(rows, lamp, before, columns);
        }
        shadows = links.shadows(lamp);
        turns(rows);
        look(rows, lamp);
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        known(rows, lamp, before.seen);
        Arrays.fill(asked, 0);
        // Rows that were asked before have their answers.
        for (int i = 0; i < rows.count; i++) {
            if ((state[i] & LightRows.WAY) == 0 && RowBits.contains(anyInside, i)) {
                RowBits.add(asked, i);
            }
        }
        cast(rows, lamp, asked);
        return layer(rows, lamp, state, asked, columns).withTint(tints(rows, lamp, asked, before.tint, columns));
    }

    /** All terms anew for rows whose ways are known: no shadow ray is cast. */
    LightRows again(HitRows rows, Lamp lamp, LightLayer before, Columns columns) {
        if (before.lit() == 0) {
            return LightRows.unlit(before.states(), before.seen()).withTint(before.tint());
        }
        turns(rows);
        known(rows, lamp, before.seen());
        RowBits.inState(before.states(), rows.count, LightRows.LIT, anyLit);
        return terms(rows, lamp, before.states(), before.seen(), columns).withTint(before.tint());
    }

    private void turns(HitRows rows) {
        for (int i = 0; i < rows.count; i++) {
            ways.turn[i] = LampArea.turn(rows.px[i], rows.py[i], rows.pz[i]);
        }
    }

    /** Aims the terms of a set at sample {@code s}; leaves the cosines. */
    private void aim(HitRows rows, Lamp lamp, int s, int[] which) {
        terms.aim(rows, lamp, s, ways.turn, which, cosine, facing[s]);
        if (lamp.hasCone()) {
            terms.aimCone(rows, lamp);
        }
    }

    /** Finds out which rows face which samples and are in their cones. */
    private void look(HitRows rows, Lamp lamp) {
        begin(rows, lamp);
        for (int s = 0; s < lamp.area().samples(); s++) {
            aim(rows, lamp, s, mayFace);
            look(rows, lamp, s);
        }
    }

    /** The same for sample {@code s}, which was aimed at. */
    private void look(HitRows rows, Lamp lamp, int s) {
        int words = RowBits.words(rows.count);
        if (lamp.hasCone()) {
            terms.inside(facing[s], rows.count, lamp.cosAngle(), inside[s]);
        } else {
            System.arraycopy(facing[s], 0, inside[s], 0, words);
        }
        links.keep(lamp, rows, inside[s]);
        for (int b = 0; b < words; b++) {
            anyFacing[b] |= facing[s][b];
            anyInside[b] |= inside[s][b];
        }
    }

    /** Asks rows for all samples that they face; adds the free ways to those that are known. */
    private void cast(HitRows rows, Lamp lamp, int[] which) {
        int words = RowBits.words(rows.count);
        if (RowBits.count(which, rows.count) == 0) {
            tinted = false;
            return;
        }
        shadows.aim(rows, lamp, ways);
        beginTints();
        for (int s = 0; s < lamp.area().samples(); s++) {
            for (int b = 0; b < words; b++) {
                chosen[b] = facing[s][b] & which[b];
            }
            cast(rows, lamp, s, chosen);
            for (int b = 0; b < words; b++) {
                chosen[b] &= ~blocked[b];
                clear[s][b] |= chosen[b];
            }
            if (tinted) {
                shadows.addTints(rows, ways, lamp.area(), s, chosen, tintSum);
            }
        }
    }

    private void beginTints() {
        tinted = shadows.isTinted();
        if (tinted) {
            tintSum = tintSum == null ? new double[3][Terms.ROWS] : tintSum;
            for (double[] sum : tintSum) {
                Arrays.fill(sum, 0);
            }
        }
    }

    /** The means of what passes over the free ways of rows that were asked just now; of others what is known. */
    private float[][] tints(HitRows rows, Lamp lamp, int[] fresh, float[][] before, Columns columns) {
        if (!tinted) {
            return before;
        }
        float[][] to = TintCaster.begun(rows, before, columns);
        for (int i = 0; i < rows.count; i++) {
            int free = 0;
            for (int s = 0; s < lamp.area().samples() && RowBits.contains(fresh, i); s++) {
                free += RowBits.contains(clear[s], i) ? 1 : 0;
            }
            for (int c = 0; c < 3 && free > 0; c++) {
                to[c][i] = LightingEquation.mean(tintSum[c][i], free);
            }
        }
        return TintCaster.kept(rows, to);
    }

    /** Asks chosen rows for sample {@code s}; leaves the rows with a way that is not free. */
    private void cast(HitRows rows, Lamp lamp, int s, int[] which) {
        terms.lead(rows, lamp, s, tinted ? which : shadows.doubts(rows, which), ways);
        ends(rows, s);
        shadows.cast(rows, ways, which, blocked);
    }

    private void ends(HitRows rows, int s) {
        for (int i = 0; i < rows.count && !ways.open; i++) {
            ways.end[i] = shadows.end(LampArea.place(s, ways.turn[i]));
        }
    }

    /** Reads which ways are known to be free. */
    private void known(HitRows rows, Lamp lamp, short[][] seen) {
        int samples = lamp.area().samples();
        for (int first = 0; first < samples; first += LightRows.SAMPLES) {
            short[] column = seen == null ? null : seen[first / LightRows.SAMPLES];
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                int row = b * RowBits.WIDTH;
                for (int i = row; i < row + RowBits.WIDTH; i++) {
                    square[i - row] = column != null && i < rows.count ? column[i] & 0xFFFF : 0;
                }
                RowBits.transpose(square);
                for (int s = first; s < Math.min(samples, first + LightRows.SAMPLES); s++) {
                    clear[s][b] = square[s - first];
                }
            }
        }
    }

    /**
     * The layer of rows that were looked at.
     *
     * @param state of before; gets the states
     * @param fresh the rows that were asked just now
     */
    private LightRows layer(HitRows rows, Lamp lamp, byte[] state, int[] fresh, Columns columns) {
        return terms(rows, lamp, state, states(rows, lamp, state, fresh, columns), columns);
    }

    /** Writes the states; what is seen, and the rows that are lit to {@link #anyLit}. */
    private short[][] states(HitRows rows, Lamp lamp, byte[] state, int[] fresh, Columns columns) {
        Arrays.fill(anyLit, 0);
        Arrays.fill(anyClear, 0);
        int words = RowBits.words(rows.count);
        for (int s = 0; s < lamp.area().samples(); s++) {
            for (int b = 0; b < words; b++) {
                anyClear[b] |= clear[s][b];
                anyLit[b] |= clear[s][b] & inside[s][b];
            }
        }
        for (int i = 0; i < rows.count; i++) {
            int way = RowBits.contains(fresh, i) ? RowBits.contains(anyClear, i) ? LightRows.CLEAR : LightRows.BLOCKED
                    : state[i] & LightRows.WAY;
            state[i] = (byte) (way | (!RowBits.contains(anyFacing, i) ? LightRows.AWAY
                    : !RowBits.contains(anyInside, i) ? LightRows.OUTSIDE
                    : RowBits.contains(anyLit, i) ? LightRows.LIT : LightRows.SHADOWED));
        }
        return RowBits.count(anyClear, rows.count) == 0 ? null : seen(rows, lamp, columns);
    }

    private short[][] seen(HitRows rows, Lamp lamp, Columns columns) {
        int samples = lamp.area().samples();
        short[][] seen = new short[(samples - 1) / LightRows.SAMPLES + 1][];
        for (int k = 0; k < seen.length; k++) {
            seen[k] = columns.shorts(rows.count);
            int first = k * LightRows.SAMPLES;
            int count = Math.min(LightRows.SAMPLES, samples - first);
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                for (int s = 0; s < LightRows.SAMPLES; s++) {
                    square[s] = s < count ? clear[first + s][b] : 0;
                }
                RowBits.transpose(square);
                int row = b * RowBits.WIDTH;
                for (int i = row; i < Math.min(row + RowBits.WIDTH, rows.count); i++) {
                    seen[k][i] = (short) square[i - row];
                }
            }
        }
        return seen;
    }

    /** The means over all samples, of which the free ways are known; rows that are lit are in {@link #anyLit}. */
    private LightRows terms(HitRows rows, Lamp lamp, byte[] state, short[][] seen, Columns columns) {
        if (RowBits.count(anyLit, rows.count) == 0) {
            return LightRows.unlit(state, seen);
        }
        int samples = lamp.area().samples();
        beginSums(rows, lamp);
        for (int s = 0; s < samples; s++) {
            aim(rows, lamp, s, anyLit);
            if (lamp.hasCone()) {
                terms.inside(clear[s], rows.count, lamp.cosAngle(), chosen);
            } else {
                System.arraycopy(clear[s], 0, chosen, 0, chosen.length);
            }
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                // Not of rows that the light is not linked to, whose ways may be known.
                chosen[b] &= anyLit[b];
            }
            add(rows, lamp, s, chosen);
        }
        return means(rows, lamp, state, seen, columns);
    }

    /** Adds what a sample gives that was aimed at and whose cosines are there to the sums of the rows of a set. */
    private void add(HitRows rows, Lamp lamp, int s, int[] which) {
        float[] fading = lamp.fades() ? falloff : null;
        if (lamp.fades()) {
            falloffs(rows, lamp, s);
        }
        written.mattes(rows, which, cosine);
        terms.add(cosine, fading, which, rows.count, diffuseSum);
        if (shines) {
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                shining[b] = which[b] & mayShine[b];
            }
            written.speculars(rows, shining, specular, grazing);
            terms.add(specular, fading, shining, rows.count, specularSum);
        }
        if (metallic) {
            addGrazing(rows, fading, which);
        }
    }

    private void addGrazing(HitRows rows, float[] fading, int[] which) {
        System.arraycopy(which, 0, metals, 0, RowBits.words(rows.count));
        for (int r = 0; r < rows.runs; r++) {
            if (!written.isMetallic(rows.runMaterial[r])) {
                RowBits.remove(metals, rows.runStart(r), rows.runEnd[r]);
            }
        }
        terms.add(grazing, fading, metals, rows.count, grazingSum);
    }

    private void falloffs(HitRows rows, Lamp lamp, int s) {
        if (!Shaping.acts(lamp)) {
            terms.falloffs(rows, lamp, falloff);
            return;
        }
        Shaping[] doors = new Shaping[LampArea.TURNS];
        Arrays.setAll(doors, t -> Shaping.of(lamp.sample(t, s)));
        terms.factors(rows, lamp, factors);
        for (int i = 0; i < rows.count; i++) {
            falloff[i] = (float) (factors[i] * doors[(int) ways.turn[i]].at(rows.px[i], rows.py[i], rows.pz[i]));
        }
    }

    private LightRows means(HitRows rows, Lamp lamp, byte[] state, short[][] seen, Columns columns) {
        int lit = RowBits.count(anyLit, rows.count);
        if (lit == 0) {
            return LightRows.unlit(state, seen);
        }
        int samples = lamp.area().samples();
        return new LightRows(state, mean(diffuseSum, samples, rows, columns), shines ? mean(specularSum, samples, rows, columns) : null,
                metallic ? mean(grazingSum, samples, rows, columns) : null, null, seen, lit);
    }

    private static float[] mean(double[] sum, int samples, HitRows rows, Columns columns) {
        float[] mean = columns.floats(rows.count);
        for (int i = 0; i < rows.count; i++) {
            mean[i] = LightingEquation.mean(sum[i], samples);
        }
        return mean;
    }
}
