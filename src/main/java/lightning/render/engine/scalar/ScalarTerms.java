package lightning.render.engine.scalar;

import java.util.Arrays;
import lightning.base.math.Power;
import lightning.render.shading.Lamp;
import lightning.render.shading.LampArea;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.RowBits;
import lightning.render.shading.Terms;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.scene.Attenuation;

/** {@link Terms} in plain loops, row by row. */
final class ScalarTerms implements Terms {
    /** The unit vector from each row to the light. */
    private final double[] lx = new double[ROWS];
    private final double[] ly = new double[ROWS];
    private final double[] lz = new double[ROWS];
    private final double[] distance = new double[ROWS];
    /** The cosine from the cone's axis, −1…1. */
    private final double[] axisCosine = new double[ROWS];

    @Override
    public void aim(HitRows rows, Lamp lamp) {
        double x = lamp.source().x();
        double y = lamp.source().y();
        double z = lamp.source().z();
        if (!lamp.type().hasPosition()) {
            Arrays.fill(lx, 0, rows.count, x);
            Arrays.fill(ly, 0, rows.count, y);
            Arrays.fill(lz, 0, rows.count, z);
            return;
        }
        for (int i = 0; i < rows.count; i++) {
            aimAtPoint(rows, i, x, y, z);
        }
    }

    @Override
    public void aim(HitRows rows, Lamp lamp, int s, double[] turn, int[] which, float[] cosine, int[] facing) {
        LampArea area = lamp.area();
        for (int i = 0; i < rows.count; i++) {
            int k = LampArea.place(s, turn[i]);
            if (lamp.type().hasPosition()) {
                aimAtPoint(rows, i, area.x[k], area.y[k], area.z[k]);
            } else {
                lx[i] = area.x[k];
                ly[i] = area.y[k];
                lz[i] = area.z[k];
            }
        }
        cosines(rows, cosine);
        facing(cosine, rows.count, facing);
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            facing[b] &= which[b];
        }
    }

    @Override
    public void lead(HitRows rows, Lamp lamp, int s, int[] which, RowWays ways) {
        LampArea area = lamp.area();
        for (int i = 0; i < rows.count; i++) {
            int k = LampArea.place(s, ways.turn[i]);
            ways.x[i] = area.x[k];
            ways.y[i] = area.y[k];
            ways.z[i] = area.z[k];
        }
    }

    @Override
    public void mayFace(HitRows rows, Lamp lamp, int[] may) {
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            may[b] = RowBits.valid(b, rows.count);
        }
    }

    @Override
    public void mayShine(HitRows rows, int from, int to, Lamp lamp, double shininess, int[] may) {
        RowBits.add(may, from, to);
    }

    private void aimAtPoint(HitRows rows, int i, double x, double y, double z) {
        double vx = x - rows.px[i];
        double vy = y - rows.py[i];
        double vz = z - rows.pz[i];
        double d = Math.sqrt(vx * vx + vy * vy + vz * vz);
        boolean here = d < LightingEquation.NO_DISTANCE;
        double inverse = 1 / d;
        distance[i] = d;
        lx[i] = here ? rows.nx[i] : vx * inverse;
        ly[i] = here ? rows.ny[i] : vy * inverse;
        lz[i] = here ? rows.nz[i] : vz * inverse;
    }

    @Override
    public void measure(HitRows rows, Lamp lamp) {
        for (int i = 0; i < rows.count; i++) {
            double vx = lamp.source().x() - rows.px[i];
            double vy = lamp.source().y() - rows.py[i];
            double vz = lamp.source().z() - rows.pz[i];
            distance[i] = Math.sqrt(vx * vx + vy * vy + vz * vz);
        }
    }

    @Override
    public void aimCone(HitRows rows, Lamp lamp) {
        for (int i = 0; i < rows.count; i++) {
            double c = -(lx[i] * lamp.axis().x() + ly[i] * lamp.axis().y() + lz[i] * lamp.axis().z());
            axisCosine[i] = c < -1 ? -1 : c > 1 ? 1 : c;
        }
    }

    @Override
    public void cosines(HitRows rows, float[] to) {
        for (int i = 0; i < rows.count; i++) {
            to[i] = (float) (rows.nx[i] * lx[i] + rows.ny[i] * ly[i] + rows.nz[i] * lz[i]);
        }
    }

    @Override
    public void facing(float[] cosine, int rows, int[] facing) {
        Arrays.fill(facing, 0, RowBits.words(rows), 0);
        for (int i = 0; i < rows; i++) {
            if (cosine[i] > 0) {
                RowBits.add(facing, i);
            }
        }
    }

    @Override
    public void inside(int[] among, int rows, double cosAngle, int[] inside) {
        Arrays.fill(inside, 0, RowBits.words(rows), 0);
        for (int i = 0; i < rows; i++) {
            if (RowBits.contains(among, i) && axisCosine[i] >= cosAngle) {
                RowBits.add(inside, i);
            }
        }
    }

    @Override
    public void select(float[] values, int[] which, int rows, float[] to) {
        for (int i = 0; i < rows; i++) {
            to[i] = RowBits.contains(which, i) ? values[i] : 0;
        }
    }

    @Override
    public void speculars(HitRows rows, int from, int to, int[] which, double shininess, float[] column) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(which, i)) {
                column[i] = (float) Power.of(mirrorCosine(rows, i), shininess);
            }
        }
    }

    /** max(V·R, 0) with R = 2N(N·−L) + L, both taken at length 1. */
    private double mirrorCosine(HitRows rows, int i) {
        double nx = rows.nx[i];
        double ny = rows.ny[i];
        double nz = rows.nz[i];
        double vx = rows.vx[i];
        double vy = rows.vy[i];
        double vz = rows.vz[i];
        double twice = 2 * (nx * lx[i] + ny * ly[i] + nz * lz[i]);
        double rx = lx[i] - twice * nx;
        double ry = ly[i] - twice * ny;
        double rz = lz[i] - twice * nz;
        double dot = vx * rx + vy * ry + vz * rz;
        if (!(dot > 0)) {
            return 0;
        }
        double c = dot / Math.sqrt((vx * vx + vy * vy + vz * vz) * (rx * rx + ry * ry + rz * rz));
        return c > 0 ? c > 1 ? 1 : c : 0;
    }

    @Override
    public void mattes(HitRows rows, int from, int to, int[] which, float[] column) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(which, i)) {
                double nl = lightCosine(rows, i);
                column[i] = (float) (nl * (1 - fifth(1 - nl)) * (1 - fifth(1 - viewCosine(rows, i))));
            }
        }
    }

    @Override
    public void glosses(HitRows rows, int from, int to, int[] which, double alpha, float[] gloss, float[] grazing) {
        for (int i = from; i < to; i++) {
            if (RowBits.contains(which, i)) {
                double facets = microfacets(rows, i, alpha);
                double schlick = schlick(rows, i);
                gloss[i] = (float) (facets * (1 - schlick));
                grazing[i] = (float) (facets * schlick);
            }
        }
    }

    /** N·L. */
    private double lightCosine(HitRows rows, int i) {
        return rows.nx[i] * lx[i] + rows.ny[i] * ly[i] + rows.nz[i] * lz[i];
    }

    /** max(N·V, 0). */
    private static double viewCosine(HitRows rows, int i) {
        double c = -((double) rows.nx[i] * rows.vx[i] + (double) rows.ny[i] * rows.vy[i] + (double) rows.nz[i] * rows.vz[i]);
        return c > 0 ? c : 0;
    }

    private static double fifth(double x) {
        double square = x * x;
        return square * square * x;
    }

    /** N·L·D·V. */
    private double microfacets(HitRows rows, int i, double alpha) {
        double nx = rows.nx[i];
        double ny = rows.ny[i];
        double nz = rows.nz[i];
        double hx = lx[i] - rows.vx[i];
        double hy = ly[i] - rows.vy[i];
        double hz = lz[i] - rows.vz[i];
        double nh = nx * hx + ny * hy + nz * hz;
        double c = nh * nh / ((nx * nx + ny * ny + nz * nz) * (hx * hx + hy * hy + hz * hz));
        c = c > 0 ? c > 1 ? 1 : c : 0;
        double nl = lightCosine(rows, i);
        double nv = viewCosine(rows, i);
        double a = alpha * alpha;
        double t = c * (a - 1) + 1;
        double gl = nl + Math.sqrt(a + (1 - a) * (nl * nl));
        double gv = nv + Math.sqrt(a + (1 - a) * (nv * nv));
        return nl * a / (t * t * (gl * gv));
    }

    /** (1 − V·H)⁵. */
    private double schlick(HitRows rows, int i) {
        double vx = rows.vx[i];
        double vy = rows.vy[i];
        double vz = rows.vz[i];
        double hx = lx[i] - vx;
        double hy = ly[i] - vy;
        double hz = lz[i] - vz;
        double vh = -(vx * hx + vy * hy + vz * hz);
        double c = vh / Math.sqrt((vx * vx + vy * vy + vz * vz) * (hx * hx + hy * hy + hz * hz));
        return fifth(1 - (c > 0 ? c > 1 ? 1 : c : 0));
    }

    @Override
    public void falloffs(HitRows rows, Lamp lamp, float[] to) {
        for (int i = 0; i < rows.count; i++) {
            to[i] = (float) factor(lamp, i);
        }
    }

    @Override
    public void add(float[] term, float[] falloff, int[] which, int rows, double[] sum) {
        for (int i = 0; i < rows; i++) {
            if (RowBits.contains(which, i)) {
                sum[i] += falloff == null ? term[i] : (double) term[i] * falloff[i];
            }
        }
    }

    @Override
    public void factors(HitRows rows, Lamp lamp, double[] to) {
        for (int i = 0; i < rows.count; i++) {
            to[i] = factor(lamp, i);
        }
    }

    private double factor(Lamp lamp, int i) {
        Attenuation a = lamp.light().attenuation();
        double d = distance[i];
        double factor = 1 / (a.constant() + a.linear() * d + a.quadratic() * (d * d));
        factor = factor < 1 ? factor : 1;
        return lamp.hasCone() ? factor * Power.of(axisCosine[i] > 0 ? axisCosine[i] : 0, lamp.dropoff()) : factor;
    }
}
