package lightning.render.relight.paper;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import lightning.render.column.ColumnSet;
import lightning.render.shading.Columns;
import lightning.render.shading.ConeChange;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightRows;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.Luminaire;
import lightning.render.shading.ScratchColumns;
import lightning.render.shading.Terms;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;

/**
 * The second stage for one tile as the paper has it (§4): contributions are stored with everything
 * multiplied in, and scaled by ratios. Holds scratch memory: one for each thread.
 */
public final class RatioKernel {
    private static final float[] ZEROS = new float[Terms.ROWS];

    private final LightKernel exact;
    private final AttenuationRatio falloffs;
    private final ScratchColumns scratch = new ScratchColumns();
    private double leastFalloff = 1;
    private long rowsScaled;

    public RatioKernel(LightKernel exact) {
        this.exact = exact;
        falloffs = new AttenuationRatio(exact.terms());
    }

    /**
     * The least falloff, before or after, of any row whose contributions {@link #partial} scaled by a ratio of falloffs
     * since the start; where it is below the least normal float, that.
     */
    double leastFalloff() {
        return leastFalloff;
    }

    /** Rows of layers that were looked at, written or scaled since the start. */
    long rowsTouched() {
        return exact.rowsTouched() + rowsScaled;
    }

    /** All contributions, shadow rays included: the worst case, and the paper's answer to an old value of 0. */
    public RatioRows full(HitRows rows, Luminaire light) {
        scratch.reset();
        return contributions(rows, light, exact.full(rows, light.lamp(), scratch), Columns.FRESH.states(rows.count));
    }

    /** All contributions anew for rows whose states are known: no shadow ray is cast. */
    RatioRows again(HitRows rows, Luminaire light, RatioRows before) {
        scratch.reset();
        return contributions(rows, light, exact.again(rows, light.lamp(), before, scratch), Columns.FRESH.states(rows.count));
    }

    /** The terms of rows whose states are known, in columns that are valid until the next call; no shadow ray is cast. */
    LightRows terms(HitRows rows, Luminaire light, RatioRows layer) {
        scratch.reset();
        return exact.again(rows, light.lamp(), layer, scratch);
    }

    /** All contributions from terms that are known: the same as {@link #full} would give, and no ray is cast. */
    RatioRows of(HitRows rows, Luminaire light, LightRows layer) {
        rowsScaled += layer.lit;
        return contributions(rows, light, layer, Columns.FRESH.states(rows.count));
    }

    private RatioRows contributions(HitRows rows, Luminaire light, LightRows layer, byte[] states) {
        if (layer.state == LightRows.UNREACHED.state) {
            return RatioRows.UNREACHED;
        }
        System.arraycopy(layer.state, 0, states, 0, rows.count);
        if (layer.lit == 0) {
            return new RatioRows(states, null, null, null, kept(rows, layer.seen()), 0).withTint(kept(rows, layer.tint()));
        }
        float[][] diffuse = weighted(rows, light, layer.cosine, layer);
        float[][] specular = layer.specular == null ? null : weighted(rows, light, layer.specular, layer);
        float[][] grazing = layer.grazing == null ? null : weighted(rows, light, layer.grazing, layer);
        return new RatioRows(states, diffuse, specular, grazing, kept(rows, layer.seen()), layer.lit).withTint(kept(rows, layer.tint()));
    }

    /** A copy that stays, just long enough. */
    private static float[][] kept(HitRows rows, float[][] tint) {
        return tint == null ? null
                : Arrays.stream(tint).map(column -> Arrays.copyOf(column, HitRows.padded(rows.count))).toArray(float[][]::new);
    }

    /** A copy that stays, just long enough. */
    private static short[][] kept(HitRows rows, short[][] seen) {
        return seen == null ? null
                : Arrays.stream(seen).map(column -> Arrays.copyOf(column, HitRows.padded(rows.count))).toArray(short[][]::new);
    }

    private static float[][] weighted(HitRows rows, Luminaire light, float[] term, LightRows layer) {
        float[][] out = columns(rows);
        float[][] tint = layer.tint();
        for (int i = 0; i < rows.count && tint != null; i++) {
            float falloff = layer.falloff == null ? 1 : layer.falloff[i];
            out[0][i] = LightingEquation.contribution(light.red(), term[i], falloff, tint[0][i]);
            out[1][i] = LightingEquation.contribution(light.green(), term[i], falloff, tint[1][i]);
            out[2][i] = LightingEquation.contribution(light.blue(), term[i], falloff, tint[2][i]);
        }
        float[] falloff = layer.falloff;
        for (int i = 0; i < rows.count && tint == null; i++) {
            float faded = falloff == null ? term[i] : term[i] * falloff[i];
            out[0][i] = light.red() * faded;
            out[1][i] = light.green() * faded;
            out[2][i] = light.blue() * faded;
        }
        return out;
    }

    private static float[][] columns(HitRows rows) {
        return new float[][] {Columns.FRESH.floats(rows.count), Columns.FRESH.floats(rows.count), Columns.FRESH.floats(rows.count)};
    }

    /** The paper's updates of colour, intensity, attenuation, dropoff and angle, alone or together. */
    public RatioRows partial(HitRows rows, Luminaire from, Luminaire to, RatioRows before, ConeChange cone, boolean falloff) {
        if (to.lamp().isArea() && (cone != ConeChange.NONE || falloff)) {
            return anew(rows, to, before, cone);
        }
        IntensityRatio intensity = IntensityRatio.between(from, to);
        if (!intensity.isUsable()) {
            return full(rows, to);
        }
        if (before.tint() != null && !to.lamp().isArea()) {
            return retinted(rows, to, before, cone);
        }
        if (before.lit() == 0 && cone != ConeChange.ANGLE_ADD) {
            return cone == ConeChange.NONE ? before : moved(rows, to, before, before, cone);
        }
        if (falloff && before.lit() > 0) {
            if (!falloffs.compute(rows, from.lamp(), to.lamp(), before.states())) {
                return full(rows, to);
            }
            leastFalloff = Math.min(leastFalloff, falloffs.least());
        }
        RatioRows scaled = scaled(rows, before, intensity, falloff && before.lit() > 0);
        return cone == ConeChange.NONE ? scaled : moved(rows, to, before, scaled, cone);
    }

    /** Samples of one row fall off by different ratios, so that no ratio of their sum is known: it is computed anew, without a ray. */
    private RatioRows anew(HitRows rows, Luminaire light, RatioRows before, ConeChange cone) {
        scratch.reset();
        LightRows known = known(before);
        LightRows now = exact.partial(rows, light.lamp(), known, cone, true, scratch);
        return now == known ? before : contributions(rows, light, now, Columns.FRESH.states(rows.count));
    }

    /** What passes of the light is one rounding more, which no bound of ratios counts: it is computed anew, without a ray. */
    private RatioRows retinted(HitRows rows, Luminaire light, RatioRows before, ConeChange cone) {
        scratch.reset();
        LightRows known = known(before);
        LightRows moved = cone == ConeChange.NONE ? known : exact.partial(rows, light.lamp(), known, cone, false, scratch);
        return contributions(rows, light, exact.again(rows, light.lamp(), moved, scratch), Columns.FRESH.states(rows.count));
    }

    /** A layer of which the states are known, what samples see and what passes of the light. */
    private static LightRows known(RatioRows before) {
        return new LightRows(before.states(), before.lit() == 0 ? null : ZEROS, before.specular == null ? null : ZEROS,
                before.grazing == null ? null : ZEROS, null, before.seen(), before.lit()).withTint(before.tint());
    }

    private RatioRows scaled(HitRows rows, RatioRows before, IntensityRatio intensity, boolean falloff) {
        if (before.lit() == 0 || !falloff && intensity.equals(IntensityRatio.NONE)) {
            return before;
        }
        rowsScaled += before.lit();
        return new RatioRows(before.states(), scaled(rows, before.diffuse, intensity, falloff),
                before.specular == null ? null : scaled(rows, before.specular, intensity, falloff),
                before.grazing == null ? null : scaled(rows, before.grazing, intensity, falloff), before.seen(), before.lit())
                .withTint(before.tint());
    }

    private float[][] scaled(HitRows rows, float[][] from, IntensityRatio intensity, boolean falloff) {
        float[][] to = columns(rows);
        for (int c = 0; c < 3; c++) {
            float factor = intensity.channel(c);
            float[] in = from[c];
            float[] out = to[c];
            for (int i = 0; i < rows.count; i++) {
                out[i] = in[i] * factor;
            }
            if (falloff) {
                float[] ratio = falloffs.ratio;
                for (int i = 0; i < rows.count; i++) {
                    out[i] = out[i] * ratio[i];
                }
            }
        }
        return to;
    }

    /** Removes rows that left the cone and adds those that entered it; {@code scaled} holds the others. */
    private RatioRows moved(HitRows rows, Luminaire light, RatioRows before, RatioRows scaled, ConeChange cone) {
        scratch.reset();
        LightRows known = known(before);
        LightRows now = exact.partial(rows, light.lamp(), known, cone, false, scratch);
        return now.state == known.state ? scaled : joined(rows, light, before, scaled, now);
    }

    /**
     * The layer after other shapes: rows whose way to the light may be blocked or free since are asked again, and those that are
     * lit now are computed anew.
     *
     * @param light the light that the layer was computed for
     */
    RatioRows shadowed(HitRows rows, Luminaire light, RatioRows before, ShapeChange change) {
        scratch.reset();
        LightRows known = known(before);
        LightRows now = exact.shadowed(rows, light.lamp(), known, change, scratch);
        if (now != known && (now.tint() != null || known.tint() != null)) {
            return contributions(rows, light, exact.again(rows, light.lamp(), now, scratch), Columns.FRESH.states(rows.count));
        }
        return now == known ? before
                : joined(rows, light, before, before, exact.partial(rows, light.lamp(), now, ConeChange.NONE, true, scratch));
    }

    /** Rows that were lit before and are so {@code now} from {@code scaled}, others from what is known now. */
    private RatioRows joined(HitRows rows, Luminaire light, RatioRows before, RatioRows scaled, LightRows now) {
        RatioRows entered = contributions(rows, light, now, Columns.FRESH.states(rows.count));
        for (int i = 0; i < rows.count && entered.lit() > 0; i++) {
            boolean stays = (before.states()[i] & LightRows.STATE) == LightRows.LIT
                    && (entered.states()[i] & LightRows.STATE) == LightRows.LIT;
            if (stays) {
                take(scaled.diffuse, entered.diffuse, i);
                // A layer that was known exactly may lack highlights that are 0: those of now are, too.
                if (entered.specular != null && scaled.specular != null) {
                    take(scaled.specular, entered.specular, i);
                }
                if (entered.grazing != null) {
                    take(scaled.grazing, entered.grazing, i);
                }
            }
        }
        return entered;
    }

    /**
     * The layer after an edit of materials: of the rows of those that changed the specular contributions anew, without a
     * ray. Where a material is metallic, or was, the diffuse ones too.
     *
     * @param light   the light that the layer was computed for
     * @param changed materials whose shininess, roughness or model changed, or that got or lost their highlights
     */
    RatioRows speculars(HitRows rows, Luminaire light, RatioRows before, MaterialSet changed) {
        if (before.lit() == 0 || !changed.isIn(rows)) {
            return before.grazing == null || exact.hasMetallic(rows) ? before
                    : new RatioRows(before.states(), before.diffuse, before.specular, null, before.seen(), before.lit())
                            .withTint(before.tint());
        }
        scratch.reset();
        LightRows known = known(before);
        LightRows now = exact.speculars(rows, light.lamp(), known, changed, scratch);
        if (now.specular == null && now.cosine == known.cosine) {
            return new RatioRows(before.states(), before.diffuse, null, null, before.seen(), before.lit()).withTint(before.tint());
        }
        LightRows faded = exact.partial(rows, light.lamp(), now, ConeChange.NONE, true, scratch);
        return new RatioRows(before.states(),
                now.cosine == known.cosine ? before.diffuse : anew(rows, light, faded, faded.cosine, before.diffuse, changed),
                anew(rows, light, faded, faded.specular, before.specular, changed),
                anew(rows, light, faded, faded.grazing, before.grazing, changed), before.seen(), before.lit()).withTint(before.tint());
    }

    /** A term's contributions: of rows whose material did not change as they were, where they were any. */
    private static float[][] anew(HitRows rows, Luminaire light, LightRows layer, float[] term, float[][] before, MaterialSet changed) {
        if (term == null) {
            return null;
        }
        float[][] now = weighted(rows, light, term, layer);
        for (int r = 0; r < rows.runs && before != null; r++) {
            for (int i = rows.runStart(r); i < rows.runEnd[r] && !changed.contains(rows.runMaterial[r]); i++) {
                take(before, now, i);
            }
        }
        return now;
    }

    /**
     * The layer over rows that were put together of old ones and others.
     *
     * @param before over the old rows
     * @param added  over the added rows; null where there are none
     */
    RatioRows spliced(RowSplice splice, RatioRows before, RatioRows added) {
        if (before.states() == LightRows.UNREACHED.state && (added == null || added.states() == LightRows.UNREACHED.state)) {
            return RatioRows.UNREACHED;
        }
        Set<RatioRows.Column> known = EnumSet.allOf(RatioRows.Column.class);
        if (!exact.hasSpecular(splice.rows())) {
            known.removeAll(RatioRows.Column.SPECULAR);
        }
        if (before.grazing == null && !exact.hasMetallic(splice.rows())) {
            known.removeAll(RatioRows.Column.GRAZING);
        }
        if (before.tint() == null && (added == null || added.tint() == null)) {
            known.removeAll(RatioRows.Column.TINT);
        }
        known.removeIf(kind -> RatioRows.Column.SEEN.contains(kind) && !before.columns().has(kind)
                && (added == null || !added.columns().has(kind)));
        ColumnSet<RatioRows.Column> columns = ColumnSet.room(RatioRows.Column.class, known, splice.rows().count);
        splice.fill(columns, LightRows.plainlyTinted(before.columns(), RatioRows.Column.TINT),
                added == null ? null : LightRows.plainlyTinted(added.columns(), RatioRows.Column.TINT));
        byte[] states = (byte[]) columns.get(RatioRows.Column.STATE);
        int lit = 0;
        for (byte state : states) {
            lit += (state & LightRows.STATE) == LightRows.LIT ? 1 : 0;
        }
        return lit == 0 ? new RatioRows(states, null, null, null, LightRows.seen(columns, RatioRows.Column.SEEN), 0)
                .withTint(LightRows.colors(columns, RatioRows.Column.TINT))
                : new RatioRows(columns, lit);
    }

    private static void take(float[][] from, float[][] to, int row) {
        to[0][row] = from[0][row];
        to[1][row] = from[1][row];
        to[2][row] = from[2][row];
    }
}
