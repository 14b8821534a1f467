package lightning.render.trace;

import lightning.render.trace.mesh.MeshProbe;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.WayEnd;

/** {@link Tracer#cross} way by way. Holds scratch memory: one for each thread. */
public final class CrossingWalk {
    private final PrimitiveTable primitives;
    private final BoxRay box = new BoxRay();
    private final MeshProbe probe = new MeshProbe();

    public CrossingWalk(PrimitiveTable primitives) {
        this.primitives = primitives;
    }

    /** Finds the places of the ways from chosen rows. */
    public void cross(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, Crossings to) {
        for (int b = 0, first = 0; first < rows.count; b++, first += Tracer.WORD) {
            for (int left = chosen[b]; left != 0; left &= left - 1) {
                int i = first + Integer.numberOfTrailingZeros(left);
                double x = rows.px[i];
                double y = rows.py[i];
                double z = rows.pz[i];
                to.turnTo(i);
                cross(x, y, z, ways.ends ? ways.x[i] - x : ways.x[i], ways.ends ? ways.y[i] - y : ways.y[i],
                        ways.ends ? ways.z[i] - z : ways.z[i], ways.open ? WayEnd.OPEN : ways.end[i], ways.limit(), candidates, to);
            }
        }
    }

    private void cross(double ox, double oy, double oz, double dx, double dy, double dz, WayEnd end, double limit, Candidates candidates,
            Crossings to) {
        box.enter(ox, oy, oz, dx, dy, dz);
        for (int c = 0; c < candidates.count; c++) {
            if (box.hits(candidates.boxes, 6 * c, limit)) {
                int s = candidates.primitive[c];
                int index = end.indexOf(s);
                boolean ends = index >= 0 && end.touches(index, ox, oy, oz);
                primitives.crossings(s, ox, oy, oz, dx, dy, dz, ends, limit, probe, false, to);
            }
        }
    }

    /** Adds the places where one way, which does not end on primitive {@code s}, meets it. */
    public void cross(int s, double ox, double oy, double oz, double dx, double dy, double dz, double limit, Crossings to) {
        primitives.crossings(s, ox, oy, oz, dx, dy, dz, false, limit, probe, false, to);
    }
}
