package lightning.render.shading.layer;

import java.util.Arrays;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.SampleNormals;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.Tracer;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/**
 * Second stage for one tile and an area light, whose terms are means over samples. Holds scratch memory: use one instance per
 * thread.
 *
 * <p>As soon as one sample has a row in its cone, shadow rays are cast to all samples that the row faces. The results are stored,
 * so that a later edit of the cone or the falloff casts none of them again. If some are blocked and others not, the row is <em>refined</em>: rays
 * are cast to the further samples of penumbras too ({@link AreaSamples#refinedSamples}).
 */
final class AreaLightKernel {
    private static final int MAX_SAMPLES = SceneLimits.MAX_LIGHT_SAMPLES;
    private static final int[] ALL_ROWS = allRows();
    private static final int[] NO_ROWS = RowBits.allocate();

    private final LightLinks links;
    /** Casts the shadow rays to the current light. */
    private ShadowCaster shadowCaster;
    private final Tracer tracer;
    private final TermKernel terms;
    private final AreaTermSums sums;
    private final RequiredWork requiredWork;
    private final RowShadowRays shadowRays = new RowShadowRays();
    /** For each sample: the rows that face it, those in its cone, and those with an unblocked shadow ray to it. */
    private final int[][] facing = allocateSets();
    private final int[][] inside = allocateSets();
    private final int[][] unblocked = allocateSets();
    private final int[] chosen = RowBits.allocate();
    private final int[] blocked = RowBits.allocate();
    private final int[] queried = RowBits.allocate();
    /** Rows that may face any sample. */
    private final int[] mayFace = RowBits.allocate();
    private final int[] anyFacing = RowBits.allocate();
    private final int[] anyInside = RowBits.allocate();
    private final int[] anyUnblocked = RowBits.allocate();
    private final int[] anyLit = RowBits.allocate();
    /** Rows with a blocked shadow ray among those just cast to the first samples. */
    private final int[] anyBlocked = RowBits.allocate();
    /** Rows that use all samples. */
    private final int[] refined = RowBits.allocate();
    private final int[] newlyRefined = RowBits.allocate();
    private final boolean refines;
    /** Samples that any row of the current tile uses. */
    private int usedSamples;
    private final float[] cosine = new float[TermKernel.MAX_ROWS];
    private final VisibleSampleColumns sampleColumns = new VisibleSampleColumns();
    /** Sums of the tints of unblocked shadow rays; allocated on first use. */
    private double @Nullable [][] tintSum;
    private boolean hasTint;

    /** @param refines whether rows in penumbras use more samples */
    AreaLightKernel(LightLinks links, Tracer tracer, TermKernel terms, TermColumnWriter writer, RequiredWork required, boolean refines) {
        this.refines = refines;
        this.links = links;
        shadowCaster = links.unrestrictedCaster();
        this.tracer = tracer;
        this.terms = terms;
        sums = new AreaTermSums(terms, writer);
        this.requiredWork = required;
    }

    private static int[] allRows() {
        int[] all = RowBits.allocate();
        RowBits.add(all, 0, TermKernel.MAX_ROWS);
        return all;
    }

    private static int[][] allocateSets() {
        int[][] sets = new int[MAX_SAMPLES][];
        Arrays.setAll(sets, _ -> RowBits.allocate());
        return sets;
    }

    /** Recomputes the whole layer. */
    LightRows recompute(HitRows rows, LightSource source, ColumnAllocator columns) {
        if (!requiredWork.needsConeTest(source, rows, tracer) || !links.canReach(source, rows)) {
            return LightRows.UNREACHED;
        }
        shadowCaster = links.shadowCaster(source);
        byte[] state = columns.states(rows.count);
        Arrays.fill(state, 0, rows.count, LightRows.FACING_AWAY);
        AreaSamples.writePatterns(rows, shadowRays);
        if (rows.count > 0 && !source.type().hasCone()) {
            return recomputeWithoutCone(rows, source, state, columns);
        }
        begin(rows, source);
        findVisibleSamples(rows, source);
        for (int s = 0; s < source.samples(rows).refinedSamples(); s++) {
            Arrays.fill(unblocked[s], 0);
        }
        castAll(rows, source, anyInside, anyInside);
        return layerFromStates(rows, source, state, anyInside, columns).withTint(tintColumns(rows, source, anyInside, null, columns));
    }

    /** Recomputes the layer of a light whose cone cannot be edited in place: each sample is aimed only once. */
    private LightRows recomputeWithoutCone(HitRows rows, LightSource source, byte[] state, ColumnAllocator columns) {
        int words = RowBits.words(rows.count);
        begin(rows, source);
        sums.begin(rows, source, shadowRays);
        shadowCaster.aim(rows, source, shadowRays);
        beginTints();
        Arrays.fill(anyBlocked, 0);
        for (int s = 0; s < source.samples(rows).samples(); s++) {
            aim(rows, source, s, mayFace);
            findVisibleRows(rows, source, s);
            castSample(rows, source, s, inside[s]);
            for (int b = 0; b < words; b++) {
                unblocked[s][b] = inside[s][b] & ~blocked[b];
                anyBlocked[b] |= inside[s][b] & blocked[b];
                // For a row whose shadow rays are all blocked, it is enough to know that a sample in front of it has it in its
                // cone.
                mayFace[b] &= ~(shadowCaster.fullyOccluded()[b] & anyInside[b]);
            }
            sums.add(rows, source, s, unblocked[s], cosine, shadowRays);
        }
        refine(rows, source, anyInside);
        for (int s = source.samples(rows).samples(); s < usedSamples; s++) {
            aim(rows, source, s, refined);
            findFurtherRows(rows, source, s);
            castSample(rows, source, s, inside[s]);
            for (int b = 0; b < words; b++) {
                unblocked[s][b] = inside[s][b] & ~blocked[b];
            }
            sums.add(rows, source, s, unblocked[s], cosine, shadowRays);
        }
        sumTints(rows, source, anyInside);
        short[][] visibleSamples = writeStates(rows, source, state, ALL_ROWS, anyInside, columns);
        return sums.layer(rows, source, state, visibleSamples, RowBits.count(anyLit, rows.count), columns)
                .withTint(tintColumns(rows, source, anyInside, null, columns));
    }

    private void begin(HitRows rows, LightSource source) {
        Arrays.fill(anyFacing, 0);
        Arrays.fill(anyInside, 0);
        Arrays.fill(refined, 0);
        terms.addPossiblyFacing(rows, source, mayFace);
    }

    /**
     * Updates the layer after an edit that does not move the light.
     *
     * @param coneChanged true if rows may enter or leave the cone; otherwise only the falloff changed
     */
    LightRows update(HitRows rows, LightSource source, LightRows before, boolean coneChanged, ColumnAllocator columns) {
        if (!coneChanged) {
            return recomputeTerms(rows, source, before, columns);
        }
        shadowCaster = links.shadowCaster(source);
        AreaSamples.writePatterns(rows, shadowRays);
        begin(rows, source);
        findVisibleSamples(rows, source);
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        sampleColumns.read(rows, before.visibleSamples, source.samples(rows).refinedSamples(), unblocked);
        addRefined(before.state, rows.count);
        Arrays.fill(queried, 0);
        // Rows that were tested before keep their results.
        for (int i = 0; i < rows.count; i++) {
            if ((state[i] & LightRows.SHADOW_RAY_MASK) == 0 && RowBits.contains(anyInside, i)) {
                RowBits.add(queried, i);
            }
        }
        castAll(rows, source, queried, ALL_ROWS);
        return layerFromStates(rows, source, state, queried, columns).withTint(tintColumns(rows, source, queried, before.tint, columns));
    }

    /**
     * Updates the layer after a geometry change. Casts all shadow rays again from some rows and recomputes their terms; the other
     * rows keep theirs.
     *
     * @param changed those rows, which were all tested before
     */
    LightRows updateShadows(HitRows rows, LightSource source, LightRows before, int[] changed, ColumnAllocator columns) {
        shadowCaster = links.shadowCaster(source);
        AreaSamples.writePatterns(rows, shadowRays);
        int words = RowBits.words(rows.count);
        System.arraycopy(changed, 0, queried, 0, words);
        begin(rows, source);
        for (int b = 0; b < words; b++) {
            mayFace[b] &= queried[b];
        }
        findVisibleSamples(rows, source);
        sampleColumns.read(rows, before.visibleSamples, source.samples(rows).refinedSamples(), unblocked);
        for (int s = 0; s < source.samples(rows).refinedSamples(); s++) {
            for (int b = 0; b < words; b++) {
                unblocked[s][b] &= ~queried[b];
            }
        }
        addRefined(before.state, rows.count);
        for (int b = 0; b < words; b++) {
            refined[b] &= ~queried[b];
        }
        castAll(rows, source, queried, queried);
        byte[] state = columns.states(rows.count);
        System.arraycopy(before.state, 0, state, 0, rows.count);
        short[][] visibleSamples = writeStates(rows, source, state, queried, queried, columns);
        float[][] tint = tintColumns(rows, source, queried, before.tint, columns);
        if (VisibleSampleColumns.areEqual(rows, before.visibleSamples, visibleSamples) && TintTracer.areEqual(rows, tint, before.tint)) {
            return before;
        }
        return mergeTerms(rows, before, meanTerms(rows, source, state, visibleSamples, columns), columns).withTint(tint);
    }

    /** Returns a layer with the terms of {@code changed} for the rows in {@link #queried} and those of {@code before} for others. */
    private LightRows mergeTerms(HitRows rows, LightRows before, LightRows changed, ColumnAllocator columns) {
        RowBits.selectState(changed.state, rows.count, LightRows.LIT, anyLit);
        int lit = RowBits.count(anyLit, rows.count);
        return lit == 0 ? LightRows.unlit(changed.state, changed.visibleSamples)
                : LightRows.lit(changed.state, new LightRows.Terms(merge(rows, before.cosine, changed.cosine, 0, columns),
                        merge(rows, before.specular, changed.specular, 0, columns),
                        merge(rows, before.grazing, changed.grazing, 0, columns), null), lit)
                        .withVisibleSamples(changed.visibleSamples)
                        .withFaceColors(mergeColors(rows, before.face, changed.face, columns),
                                mergeColors(rows, before.highlight, changed.highlight, columns));
    }

    private float @Nullable [][] mergeColors(HitRows rows, float @Nullable [][] before, float @Nullable [][] changed,
            ColumnAllocator columns) {
        if (before == null && changed == null) {
            return null;
        }
        float[][] merged = new float[3][];
        for (int c = 0; c < 3; c++) {
            merged[c] = merge(rows, before == null ? null : before[c], changed == null ? null : changed[c], 1, columns);
        }
        return merged;
    }

    /** Merges two columns; null stands for {@code missing} in all rows. */
    private float @Nullable [] merge(HitRows rows, float @Nullable [] before, float @Nullable [] changed, float missing,
            ColumnAllocator columns) {
        if (before == null && changed == null) {
            return null;
        }
        float[] merged = columns.floats(rows.count);
        for (int i = 0; i < rows.count; i++) {
            float[] from = RowBits.contains(queried, i) ? changed : before;
            merged[i] = from == null ? missing : from[i];
        }
        return merged;
    }

    /** Recomputes all terms of rows whose visibility is known. Casts no shadow ray. */
    LightRows recomputeTerms(HitRows rows, LightSource source, LightLayer before, ColumnAllocator columns) {
        if (before.litCount() == 0) {
            return LightRows.unlit(before.states(), before.visibleSamples()).withTint(before.tint());
        }
        AreaSamples.writePatterns(rows, shadowRays);
        sampleColumns.read(rows, before.visibleSamples(), source.samples(rows).refinedSamples(), unblocked);
        RowBits.selectState(before.states(), rows.count, LightRows.LIT, anyLit);
        return meanTerms(rows, source, before.states(), before.visibleSamples(), columns).withTint(before.tint());
    }

    /** Aims the terms of a set of rows at sample {@code s}; stores the cosines. */
    private void aim(HitRows rows, LightSource source, int s, int[] rowSet) {
        terms.aim(rows, source, s, shadowRays, rowSet, cosine, facing[s]);
        excludeDarkSide(rows, source.samples(rows), facing[s], s);
        if (source.hasCone()) {
            terms.computeConeCosines(rows, source);
        }
    }

    /** Removes the rows behind sample {@code s} of an object from a set. */
    private void excludeDarkSide(HitRows rows, AreaSamples samples, int[] rowSet, int s) {
        SampleNormals normals = samples.normals();
        for (int b = 0; b < RowBits.words(rows.count) && normals != null; b++) {
            for (int left = rowSet[b]; left != 0; left &= left - 1) {
                int i = b * RowBits.WIDTH + Integer.numberOfTrailingZeros(left);
                if (normals.isBehind(samples, samples.index(s, shadowRays.pattern[i]), rows.px[i], rows.py[i], rows.pz[i])) {
                    rowSet[b] &= ~(left & -left);
                }
            }
        }
    }

    /** Finds for each sample the rows of {@link #mayFace} that face it and are in its cone. */
    private void findVisibleSamples(HitRows rows, LightSource source) {
        for (int s = 0; s < source.samples(rows).samples(); s++) {
            aim(rows, source, s, mayFace);
            findVisibleRows(rows, source, s);
        }
    }

    /** Finds the rows that face sample {@code s}, which was aimed at, and are in its cone. */
    private void findVisibleRows(HitRows rows, LightSource source, int s) {
        int words = RowBits.words(rows.count);
        selectInside(rows, source, s);
        for (int b = 0; b < words; b++) {
            anyFacing[b] |= facing[s][b];
        }
        excludeBehind(rows, source, s);
        links.retainLit(source, rows, inside[s]);
        for (int b = 0; b < words; b++) {
            anyInside[b] |= inside[s][b];
        }
    }

    /** Finds the refined rows that face a further sample, which was aimed at, and are in its cone: of those in the cone of a first sample. */
    private void findFurtherRows(HitRows rows, LightSource source, int s) {
        selectInside(rows, source, s);
        excludeBehind(rows, source, s);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            inside[s][b] &= anyInside[b];
        }
    }

    private void selectInside(HitRows rows, LightSource source, int s) {
        if (source.hasCone()) {
            terms.selectInside(facing[s], rows.count, source.cosAngle(), inside[s]);
        } else {
            System.arraycopy(facing[s], 0, inside[s], 0, RowBits.words(rows.count));
        }
    }

    /** Rows behind a sample of a surface cast no ray to it: its half-space moves only with the light. */
    private void excludeBehind(HitRows rows, LightSource source, int s) {
        if (source.type().isSurface()) {
            System.arraycopy(inside[s], 0, facing[s], 0, RowBits.words(rows.count));
        }
    }

    /**
     * Casts shadow rays from a set of rows to all samples that they face; adds the unblocked ones to the known ones.
     *
     * @param known rows whose place relative to the light is known, which include these
     */
    private void castAll(HitRows rows, LightSource source, int[] rowSet, int[] known) {
        int words = RowBits.words(rows.count);
        boolean casts = RowBits.count(rowSet, rows.count) > 0;
        hasTint = false;
        Arrays.fill(newlyRefined, 0);
        if (casts) {
            shadowCaster.aim(rows, source, shadowRays);
            beginTints();
            Arrays.fill(anyBlocked, 0);
            for (int s = 0; s < source.samples(rows).samples(); s++) {
                castKnown(rows, source, s, rowSet);
                for (int b = 0; b < words; b++) {
                    anyBlocked[b] |= chosen[b] & blocked[b];
                }
            }
        }
        refine(rows, source, casts ? rowSet : NO_ROWS);
        for (int s = source.samples(rows).samples(); s < usedSamples; s++) {
            for (int b = 0; b < words; b++) {
                chosen[b] = refined[b] & known[b];
            }
            aim(rows, source, s, chosen);
            findFurtherRows(rows, source, s);
            if (casts) {
                castKnown(rows, source, s, newlyRefined);
            }
        }
        sumTints(rows, source, rowSet);
    }

    /** Casts shadow rays to sample {@code s} from the rows of a set that face it. */
    private void castKnown(HitRows rows, LightSource source, int s, int[] rowSet) {
        int words = RowBits.words(rows.count);
        for (int b = 0; b < words; b++) {
            chosen[b] = facing[s][b] & rowSet[b];
        }
        castSample(rows, source, s, chosen);
        for (int b = 0; b < words; b++) {
            unblocked[s][b] |= chosen[b] & ~blocked[b];
        }
    }

    /** Adds the rows that need further samples to {@link #refined}, of rows whose rays to the first samples were just cast. */
    private void refine(HitRows rows, LightSource source, int[] rowSet) {
        AreaSamples samples = source.samples(rows);
        int words = RowBits.words(rows.count);
        boolean canRefine = refines && samples.refinedSamples() > samples.samples();
        for (int b = 0; b < words && canRefine; b++) {
            int seen = 0;
            for (int s = 0; s < samples.samples(); s++) {
                seen |= unblocked[s][b];
            }
            newlyRefined[b] = seen & anyBlocked[b] & rowSet[b];
            refined[b] |= newlyRefined[b];
        }
        usedSamples = RowBits.count(refined, rows.count) > 0 ? samples.refinedSamples() : samples.samples();
    }

    /** Adds the rows that use all samples by their states. */
    private void addRefined(byte[] state, int count) {
        for (int i = 0; i < count; i++) {
            if ((state[i] & LightRows.REFINED) != 0) {
                RowBits.add(refined, i);
            }
        }
    }

    private void beginTints() {
        hasTint = shadowCaster.canBeTinted();
    }

    /**
     * Sums the tints of the unblocked shadow rays to the first samples of recomputed rows. A refined row sees at least one of them, and tints
     * vary less than visibility.
     */
    private void sumTints(HitRows rows, LightSource source, int[] recomputed) {
        if (hasTint) {
            tintSum = tintSum == null ? new double[3][TermKernel.MAX_ROWS] : tintSum;
            shadowCaster.sumTints(rows, shadowRays.pattern, source.samples(rows), recomputed, unblocked, tintSum);
        }
    }

    /** Returns the mean tints over the unblocked shadow rays of recomputed rows; other rows keep their values. */
    private float @Nullable [][] tintColumns(HitRows rows, LightSource source, int[] recomputed, float @Nullable [][] before,
            ColumnAllocator columns) {
        if (!hasTint && before == null) {
            return null;
        }
        float[][] to = TintTracer.startColumns(rows, before, columns);
        for (int i = 0; i < rows.count; i++) {
            int freeCount = 0;
            for (int s = 0; hasTint && s < source.samples(rows).samples() && RowBits.contains(recomputed, i); s++) {
                freeCount += RowBits.contains(unblocked[s], i) ? 1 : 0;
            }
            for (int c = 0; c < 3 && RowBits.contains(recomputed, i); c++) {
                if (freeCount == 0) {
                    to[c][i] = 1;
                } else {
                    assert tintSum != null;
                    to[c][i] = LightingEquation.mean(tintSum[c][i], freeCount);
                }
            }
        }
        return TintTracer.nullIfUntinted(rows, to);
    }

    /** Casts shadow rays from chosen rows to sample {@code s}; stores the rows whose ray is blocked. */
    private void castSample(HitRows rows, LightSource source, int s, int[] rowSet) {
        terms.aimShadowRays(rows, source, s, shadowCaster.uncertainRows(rows, rowSet), shadowRays);
        computeTargets(rows, source.samples(rows), s);
        shadowCaster.cast(rows, shadowRays, rowSet, blocked);
    }

    private void computeTargets(HitRows rows, AreaSamples samples, int s) {
        for (int i = 0; i < rows.count && !shadowRays.isOffSurface; i++) {
            shadowRays.target[i] = shadowCaster.target(samples.index(s, shadowRays.pattern[i]));
        }
    }

    /**
     * Builds the layer from the current sample visibility.
     *
     * @param state      states before the update; receives the new states
     * @param recomputed rows whose shadow rays were just cast
     */
    private LightRows layerFromStates(HitRows rows, LightSource source, byte[] state, int[] recomputed, ColumnAllocator columns) {
        return meanTerms(rows, source, state, writeStates(rows, source, state, ALL_ROWS, recomputed, columns), columns);
    }

    /**
     * Writes the states and the visible samples; puts lit rows into {@link #anyLit}.
     *
     * @param written    rows whose states are written
     * @param recomputed rows whose shadow rays were just cast
     */
    private short @Nullable [][] writeStates(HitRows rows, LightSource source, byte[] state, int[] written, int[] recomputed,
            ColumnAllocator columns) {
        Arrays.fill(anyLit, 0);
        Arrays.fill(anyUnblocked, 0);
        int words = RowBits.words(rows.count);
        for (int s = 0; s < usedSamples; s++) {
            for (int b = 0; b < words; b++) {
                anyUnblocked[b] |= unblocked[s][b];
                anyLit[b] |= unblocked[s][b] & inside[s][b];
            }
        }
        for (int i = 0; i < rows.count; i++) {
            if (!RowBits.contains(written, i)) {
                continue;
            }
            int rayState = RowBits.contains(recomputed, i) ? RowBits.contains(refined, i) ? LightRows.UNBLOCKED | LightRows.REFINED
                    : RowBits.contains(anyUnblocked, i) ? LightRows.UNBLOCKED : LightRows.BLOCKED
                    : state[i] & LightRows.SHADOW_RAY_MASK;
            state[i] = (byte) (rayState | (!RowBits.contains(anyFacing, i) ? LightRows.FACING_AWAY
                    : !RowBits.contains(anyInside, i) ? LightRows.OUTSIDE_CONE
                    : RowBits.contains(anyLit, i) ? LightRows.LIT : LightRows.SHADOWED));
        }
        return RowBits.count(anyUnblocked, rows.count) == 0 ? null
                : sampleColumns.write(rows, unblocked, usedSamples, columns);
    }

    /** Computes the mean terms over all samples, whose visibility is known, for the rows in {@link #anyLit}. */
    private LightRows meanTerms(HitRows rows, LightSource source, byte[] state, short @Nullable [][] visibleSamples,
            ColumnAllocator columns) {
        if (RowBits.count(anyLit, rows.count) == 0) {
            return LightRows.unlit(state, visibleSamples);
        }
        Arrays.fill(refined, 0);
        addRefined(state, rows.count);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            refined[b] &= anyLit[b];
        }
        int first = source.samples(rows).samples();
        int samples = RowBits.count(refined, rows.count) > 0 ? source.samples(rows).refinedSamples() : first;
        sums.begin(rows, source, shadowRays);
        for (int s = 0; s < samples; s++) {
            int[] used = s < first ? anyLit : refined;
            aim(rows, source, s, used);
            if (source.hasCone()) {
                terms.selectInside(unblocked[s], rows.count, source.cosAngle(), chosen);
            } else {
                System.arraycopy(unblocked[s], 0, chosen, 0, chosen.length);
            }
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                // Excludes rows that the light does not illuminate, whose visibility may be known.
                chosen[b] &= used[b];
            }
            sums.add(rows, source, s, chosen, cosine, shadowRays);
        }
        return sums.layer(rows, source, state, visibleSamples, RowBits.count(anyLit, rows.count), columns);
    }
}
