package lightning.render.engine.lanes;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RayColumns;
import lightning.render.trace.RowWays;
import lightning.render.trace.SamplePlaces;
import lightning.render.trace.Tracer;
import lightning.render.trace.Ways;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Lanes;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.WayEnd;

/** Traces the rays of a tile in packets, one lane for each ray. */
class LaneTracer implements Tracer {
    private static final VectorSpecies<Double> DOUBLES = Lanes.SPECIES;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> HALF = VectorSpecies.of(float.class, VectorShape.forBitSize(DOUBLES.vectorBitSize() / 2));
    private static final int W = RayPacket.WIDTH;

    private final PrimitiveTable primitives;
    private final PacketTracer packets;
    private final RayPacket packet = new RayPacket();
    private final SurfacePacket surface = new SurfacePacket();
    private final double[] sampleX = new double[W];
    private final double[] sampleY = new double[W];
    /** Made when it is needed first. */
    private CrossingLanes crossings;

    LaneTracer(Geometry geometry) {
        primitives = geometry.primitives();
        packets = new PacketTracer(geometry);
    }

    @Override
    public Tracer among(Geometry others) {
        return new LaneTracer(others);
    }

    @Override
    public void eye(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays) {
        for (int y = 0; y < lines; y++) {
            for (int x = 0; x < columns; x += W) {
                EyeLanes.through(camera, column + x, row + y, rays.dx, rays.dy, rays.dz, y * columns + x);
            }
        }
    }

    @Override
    public void samples(CameraRays camera, SamplePlaces places, RayColumns rays) {
        for (int ray = 0; ray < places.count(); ray += W) {
            int live = Math.min(W, places.count() - ray);
            places.write(ray, live, sampleX, sampleY);
            EyeLanes.at(camera, sampleX, sampleY, rays.dx, rays.dy, rays.dz, ray);
        }
    }

    @Override
    public void nearest(RayColumns rays, Candidates candidates) {
        begin(rays, packet);
        for (int ray = 0; ray < rays.count; ray += W) {
            int live = Math.min(W, rays.count - ray);
            load(rays, ray, live, packet);
            packets.nearest(packet, live, candidates);
            System.arraycopy(packet.t, 0, rays.t, ray, live);
            System.arraycopy(packet.primitive, 0, rays.primitive, ray, live);
            System.arraycopy(packet.part, 0, rays.part, ray, live);
        }
    }

    @Override
    public void distances(RayColumns rays) {
        begin(rays, packet);
        for (int ray = 0; ray < rays.count; ray += W) {
            int live = Math.min(W, rays.count - ray);
            load(rays, ray, live, packet);
            System.arraycopy(rays.primitive, ray, packet.primitive, 0, live);
            packets.distances(packet, live);
            System.arraycopy(packet.t, 0, rays.t, ray, live);
            System.arraycopy(packet.part, 0, rays.part, ray, live);
        }
    }

    /** Puts the origin that all rays of the eye have into a packet. */
    static void begin(RayColumns rays, RayPacket packet) {
        if (rays.fromX == null) {
            Arrays.fill(packet.ox, rays.originX(0));
            Arrays.fill(packet.oy, rays.originY(0));
            Arrays.fill(packet.oz, rays.originZ(0));
        }
    }

    /** Puts rays from {@code ray} on into the first {@code live} lanes of a packet. */
    static void load(RayColumns rays, int ray, int live, RayPacket packet) {
        for (int i = 0; rays.fromX != null && i < live; i++) {
            int row = rays.slot[ray + i];
            packet.ox[i] = rays.fromX[row];
            packet.oy[i] = rays.fromY[row];
            packet.oz[i] = rays.fromZ[row];
        }
        System.arraycopy(rays.dx, ray, packet.dx, 0, live);
        System.arraycopy(rays.dy, ray, packet.dy, 0, live);
        System.arraycopy(rays.dz, ray, packet.dz, 0, live);
    }

    @Override
    public void surfaces(RayColumns rays, HitRows rows, boolean own) {
        begin(rays, packet);
        for (int row = 0; row < rays.hits; row += W) {
            int live = Math.min(W, rays.hits - row);
            surfaces(rays, row, live);
            System.arraycopy(surface.px, 0, rows.px, row, live);
            System.arraycopy(surface.py, 0, rows.py, row, live);
            System.arraycopy(surface.pz, 0, rows.pz, row, live);
            System.arraycopy(surface.nx, 0, rows.nx, row, live);
            System.arraycopy(surface.ny, 0, rows.ny, row, live);
            System.arraycopy(surface.nz, 0, rows.nz, row, live);
            if (own) {
                own(rays, row, live);
            }
        }
    }

    @Override
    public void ownPoints(RayColumns rays) {
        begin(rays, packet);
        for (int row = 0; row < rays.hits; row += W) {
            int live = Math.min(W, rays.hits - row);
            meet(rays, row, live);
            packets.ownPoints(packet, live, surface);
            own(rays, row, live);
        }
    }

    private void surfaces(RayColumns rays, int row, int live) {
        meet(rays, row, live);
        packets.surfaces(packet, live, surface);
    }

    /** Puts hits from {@code row} on into a packet, in which the eye's origin stands already. */
    private void meet(RayColumns rays, int row, int live) {
        for (int i = 0; rays.fromX != null && i < live; i++) {
            int from = rays.slot[rays.order[row + i]];
            packet.ox[i] = rays.fromX[from];
            packet.oy[i] = rays.fromY[from];
            packet.oz[i] = rays.fromZ[from];
        }
        for (int i = 0; i < live; i++) {
            int ray = rays.order[row + i];
            packet.dx[i] = rays.dx[ray];
            packet.dy[i] = rays.dy[ray];
            packet.dz[i] = rays.dz[ray];
            packet.t[i] = rays.t[ray];
            packet.primitive[i] = rays.primitive[ray];
            packet.part[i] = rays.part[ray];
        }
    }

    private void own(RayColumns rays, int row, int live) {
        System.arraycopy(surface.ownX, 0, rays.ownX, row, live);
        System.arraycopy(surface.ownY, 0, rays.ownY, row, live);
        System.arraycopy(surface.ownZ, 0, rays.ownZ, row, live);
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, Ways ways, Candidates candidates, int[] blocked) {
        packet.end = ways.end();
        for (int b = 0, row = 0; row < rows.count; b++, row += WORD) {
            int bits = 0;
            for (int part = 0; chosen[b] != 0 && part < WORD; part += W) {
                int asked = chosen[b] >>> part & -1 >>> -W;
                if (asked != 0) {
                    load(rows, ways, row + part, asked, packet);
                    bits |= (packets.blocked(packet, W, candidates) & asked) << part;
                }
            }
            blocked[b] = bits;
        }
    }

    @Override
    public void blocked(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, int[] blocked) {
        packet.end = WayEnd.OPEN;
        for (int b = 0, row = 0; row < rows.count; b++, row += WORD) {
            int bits = 0;
            for (int part = 0; chosen[b] != 0 && part < WORD; part += W) {
                int asked = chosen[b] >>> part & -1 >>> -W;
                if (asked != 0) {
                    load(rows, ways, row + part, packet);
                    bits |= (ways.open ? blocked(asked, ways.limit(), candidates)
                            : blockedByEnds(ways, row + part, asked, candidates)) << part;
                }
            }
            blocked[b] = bits;
        }
    }

    /** Lanes whose ways end alike go together. */
    private int blockedByEnds(RowWays ways, int row, int asked, Candidates candidates) {
        int bits = 0;
        for (int left = asked; left != 0;) {
            packet.end = ways.end[row + Integer.numberOfTrailingZeros(left)];
            int alike = 0;
            for (int lanes = left; lanes != 0; lanes &= lanes - 1) {
                int i = Integer.numberOfTrailingZeros(lanes);
                WayEnd end = ways.end[row + i];
                alike |= (end == packet.end || end.isOpen() && packet.end.isOpen() ? 1 : 0) << i;
            }
            bits |= blocked(alike, ways.limit(), candidates);
            left &= ~alike;
        }
        return bits;
    }

    /** Which of the packet's lanes in {@code asked} are blocked. */
    private int blocked(int asked, double limit, Candidates candidates) {
        limit(asked, limit, packet);
        return packets.blocked(packet, W, candidates) & asked;
    }

    /** Rays that are not asked end before they begin. */
    static void limit(int asked, double limit, RayPacket packet) {
        for (int i = 0; i < W; i++) {
            packet.limit[i] = (asked >>> i & 1) != 0 ? limit : -1;
        }
    }

    static void load(HitRows rows, RowWays ways, int row, RayPacket packet) {
        axis(rows.px, row, ways.x, ways.ends, packet.ox, packet.dx);
        axis(rows.py, row, ways.y, ways.ends, packet.oy, packet.dy);
        axis(rows.pz, row, ways.z, ways.ends, packet.oz, packet.dz);
    }

    private static void axis(float[] points, int row, double[] source, boolean ends, double[] origin, double[] direction) {
        for (int i = 0; i < W; i += Lanes.COUNT) {
            DoubleVector o = (DoubleVector) FloatVector.fromArray(HALF, points, row + i).castShape(DOUBLES, 0);
            DoubleVector s = DoubleVector.fromArray(DOUBLES, source, row + i);
            o.intoArray(origin, i);
            (ends ? s.sub(o) : s).intoArray(direction, i);
        }
    }

    static void load(HitRows rows, Ways ways, int row, int chosen, RayPacket packet) {
        axis(rows.px, row, ways.source().x(), ways.ends(), packet.ox, packet.dx);
        axis(rows.py, row, ways.source().y(), ways.ends(), packet.oy, packet.dy);
        axis(rows.pz, row, ways.source().z(), ways.ends(), packet.oz, packet.dz);
        limit(chosen, ways.limit(), packet);
    }

    private static void axis(float[] points, int row, double source, boolean ends, double[] origin, double[] direction) {
        for (int i = 0; i < W; i += Lanes.COUNT) {
            DoubleVector o = (DoubleVector) FloatVector.fromArray(HALF, points, row + i).castShape(DOUBLES, 0);
            DoubleVector s = DoubleVector.broadcast(DOUBLES, source);
            o.intoArray(origin, i);
            (ends ? s.sub(o) : s).intoArray(direction, i);
        }
    }

    @Override
    public void cross(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, Crossings to) {
        if (crossings == null) {
            crossings = new CrossingLanes(primitives);
        }
        crossings.cross(rows, chosen, ways, candidates, to);
    }

    @Override
    public PointBox box(float[] x, float[] y, float[] z, int from, int to) {
        PointBox box = new PointBox();
        range(x, from, to, box, 0);
        range(y, from, to, box, 1);
        range(z, from, to, box, 2);
        return box;
    }

    private static void range(float[] v, int from, int to, PointBox box, int axis) {
        FloatVector least = FloatVector.broadcast(FLOATS, v[from]);
        FloatVector most = least;
        int i = from;
        for (; i + FLOATS.length() <= to; i += FLOATS.length()) {
            FloatVector x = FloatVector.fromArray(FLOATS, v, i);
            least = least.min(x);
            most = most.max(x);
        }
        float low = least.reduceLanes(VectorOperators.MIN);
        float high = most.reduceLanes(VectorOperators.MAX);
        for (; i < to; i++) {
            low = Math.min(low, v[i]);
            high = Math.max(high, v[i]);
        }
        box.set(axis, low, high);
    }

    @Override
    public void range(double[] values, int count, double[] range) {
        DoubleVector least = DoubleVector.broadcast(DOUBLES, values[0]);
        DoubleVector most = least;
        int i = 0;
        for (; i + DOUBLES.length() <= count; i += DOUBLES.length()) {
            DoubleVector x = DoubleVector.fromArray(DOUBLES, values, i);
            least = least.min(x);
            most = most.max(x);
        }
        range[0] = least.reduceLanes(VectorOperators.MIN);
        range[1] = most.reduceLanes(VectorOperators.MAX);
        for (; i < count; i++) {
            range[0] = Math.min(range[0], values[i]);
            range[1] = Math.max(range[1], values[i]);
        }
    }
}
