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
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.ShadowRayTarget;
import org.jspecify.annotations.Nullable;

/** Packet tracer for the rays of a tile, one lane per ray. */
class LaneTracer implements Tracer {
    private static final VectorSpecies<Double> DOUBLES = DoubleLanes.SPECIES;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> HALF = VectorSpecies.of(float.class, VectorShape.forBitSize(DOUBLES.vectorBitSize() / 2));
    private static final int W = RayPacket.WIDTH;

    private final PrimitiveTable primitives;
    private final PacketTracer packetTracer;
    private final RayPacket packet = new RayPacket();
    private final SurfacePacket surface = new SurfacePacket();
    private final double[] sampleX = new double[W];
    private final double[] sampleY = new double[W];
    /** Created on first use. */
    private @Nullable ShadowRayHitLanes hitFinder;
    private @Nullable HitSurfaceLanes hitSurfaces;

    LaneTracer(Geometry geometry) {
        primitives = geometry.primitives();
        packetTracer = new PacketTracer(geometry);
    }

    @Override
    public Tracer withGeometry(Geometry geometry) {
        return new LaneTracer(geometry);
    }

    @Override
    public void directEyeRays(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays) {
        for (int y = 0; y < lines; y++) {
            for (int x = 0; x < columns; x += W) {
                CameraRayLanes.pixelRays(camera, column + x, row + y, rays.dx, rays.dy, rays.dz, y * columns + x);
            }
        }
    }

    @Override
    public void directSampleRays(CameraRays camera, SamplePositions positions, RayColumns rays) {
        for (int ray = 0; ray < positions.count(); ray += W) {
            int laneCount = Math.min(W, positions.count() - ray);
            positions.writePositions(ray, laneCount, sampleX, sampleY);
            CameraRayLanes.imageRays(camera, sampleX, sampleY, rays.dx, rays.dy, rays.dz, ray);
        }
    }

    @Override
    public void findNearest(RayColumns rays, CandidateList candidates) {
        loadEyeOrigin(rays, packet);
        for (int ray = 0; ray < rays.count; ray += W) {
            int laneCount = Math.min(W, rays.count - ray);
            load(rays, ray, laneCount, packet);
            packetTracer.findNearest(packet, laneCount, candidates);
            System.arraycopy(packet.t, 0, rays.t, ray, laneCount);
            System.arraycopy(packet.primitive, 0, rays.primitive, ray, laneCount);
            System.arraycopy(packet.part, 0, rays.part, ray, laneCount);
        }
    }

    @Override
    public void writeDistances(RayColumns rays) {
        loadEyeOrigin(rays, packet);
        for (int ray = 0; ray < rays.count; ray += W) {
            int laneCount = Math.min(W, rays.count - ray);
            load(rays, ray, laneCount, packet);
            System.arraycopy(rays.primitive, ray, packet.primitive, 0, laneCount);
            packetTracer.writeDistances(packet, laneCount);
            System.arraycopy(packet.t, 0, rays.t, ray, laneCount);
            System.arraycopy(packet.part, 0, rays.part, ray, laneCount);
        }
    }

    /** Writes the common origin of camera rays to a packet. */
    static void loadEyeOrigin(RayColumns rays, RayPacket packet) {
        if (rays.startX == null) {
            Arrays.fill(packet.ox, rays.originX(0));
            Arrays.fill(packet.oy, rays.originY(0));
            Arrays.fill(packet.oz, rays.originZ(0));
        }
    }

    /** Loads rays starting with {@code ray} into the first {@code laneCount} lanes of a packet. */
    static void load(RayColumns rays, int ray, int laneCount, RayPacket packet) {
        for (int i = 0; rays.startX != null && i < laneCount; i++) {
            assert rays.startY != null && rays.startZ != null;
            int row = rays.slot[ray + i];
            packet.ox[i] = rays.startX[row];
            packet.oy[i] = rays.startY[row];
            packet.oz[i] = rays.startZ[row];
        }
        System.arraycopy(rays.dx, ray, packet.dx, 0, laneCount);
        System.arraycopy(rays.dy, ray, packet.dy, 0, laneCount);
        System.arraycopy(rays.dz, ray, packet.dz, 0, laneCount);
    }

    @Override
    public void writeSurfaces(RayColumns rays, HitRows rows, boolean withLocalPoints) {
        loadEyeOrigin(rays, packet);
        for (int row = 0; row < rays.hitCount; row += W) {
            int laneCount = Math.min(W, rays.hitCount - row);
            computeSurfaces(rays, row, laneCount);
            System.arraycopy(surface.px, 0, rows.px, row, laneCount);
            System.arraycopy(surface.py, 0, rows.py, row, laneCount);
            System.arraycopy(surface.pz, 0, rows.pz, row, laneCount);
            System.arraycopy(surface.nx, 0, rows.nx, row, laneCount);
            System.arraycopy(surface.ny, 0, rows.ny, row, laneCount);
            System.arraycopy(surface.nz, 0, rows.nz, row, laneCount);
            if (withLocalPoints) {
                copyLocalPoints(rays, row, laneCount);
            }
        }
    }

    @Override
    public void writeLocalPoints(RayColumns rays) {
        loadEyeOrigin(rays, packet);
        for (int row = 0; row < rays.hitCount; row += W) {
            int laneCount = Math.min(W, rays.hitCount - row);
            loadHits(rays, row, laneCount);
            packetTracer.writeLocalPoints(packet, laneCount, surface);
            copyLocalPoints(rays, row, laneCount);
        }
    }

    private void computeSurfaces(RayColumns rays, int row, int laneCount) {
        loadHits(rays, row, laneCount);
        packet.startsAtFacets = rays.startsAtFacets;
        packetTracer.writeSurfaces(packet, laneCount, surface);
    }

    /** Loads hits starting with {@code row} into a packet, which already has the camera origin. */
    private void loadHits(RayColumns rays, int row, int laneCount) {
        for (int i = 0; rays.startX != null && i < laneCount; i++) {
            assert rays.startY != null && rays.startZ != null;
            int from = rays.slot[rays.order[row + i]];
            packet.ox[i] = rays.startX[from];
            packet.oy[i] = rays.startY[from];
            packet.oz[i] = rays.startZ[from];
        }
        for (int i = 0; i < laneCount; i++) {
            int ray = rays.order[row + i];
            packet.dx[i] = rays.dx[ray];
            packet.dy[i] = rays.dy[ray];
            packet.dz[i] = rays.dz[ray];
            packet.t[i] = rays.t[ray];
            packet.primitive[i] = rays.primitive[ray];
            packet.part[i] = rays.part[ray];
        }
    }

    private void copyLocalPoints(RayColumns rays, int row, int laneCount) {
        System.arraycopy(surface.localX, 0, rays.localX, row, laneCount);
        System.arraycopy(surface.localY, 0, rays.localY, row, laneCount);
        System.arraycopy(surface.localZ, 0, rays.localZ, row, laneCount);
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, ShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        packet.target = shadowRays.target();
        for (int b = 0, row = 0; row < rows.count; b++, row += ROWS_PER_WORD) {
            int bits = 0;
            for (int part = 0; selected[b] != 0 && part < ROWS_PER_WORD; part += W) {
                int laneMask = selected[b] >>> part & -1 >>> -W;
                if (laneMask != 0) {
                    load(rows, shadowRays, row + part, laneMask, packet);
                    bits |= (packetTracer.findBlocked(packet, W, candidates) & laneMask) << part;
                }
            }
            blocked[b] = bits;
        }
    }

    @Override
    public void findBlocked(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, int[] blocked) {
        packet.target = ShadowRayTarget.OFF_SURFACE;
        for (int b = 0, row = 0; row < rows.count; b++, row += ROWS_PER_WORD) {
            int bits = 0;
            for (int part = 0; selected[b] != 0 && part < ROWS_PER_WORD; part += W) {
                int laneMask = selected[b] >>> part & -1 >>> -W;
                if (laneMask != 0) {
                    load(rows, shadowRays, row + part, packet);
                    bits |= (shadowRays.isOffSurface ? blockedLanes(laneMask, shadowRays.limit(), candidates)
                            : blockedByTargets(shadowRays, row + part, laneMask, candidates)) << part;
                }
            }
            blocked[b] = bits;
        }
    }

    /** Traces lanes with equal targets together. */
    private int blockedByTargets(RowShadowRays shadowRays, int row, int laneMask, CandidateList candidates) {
        int bits = 0;
        for (int left = laneMask; left != 0;) {
            packet.target = shadowRays.target[row + Integer.numberOfTrailingZeros(left)];
            int sameTarget = 0;
            for (int lanes = left; lanes != 0; lanes &= lanes - 1) {
                int i = Integer.numberOfTrailingZeros(lanes);
                ShadowRayTarget target = shadowRays.target[row + i];
                sameTarget |= (target == packet.target || target.isOffSurface() && packet.target.isOffSurface() ? 1 : 0) << i;
            }
            bits |= blockedLanes(sameTarget, shadowRays.limit(), candidates);
            left &= ~sameTarget;
        }
        return bits;
    }

    /** Returns the lanes in {@code laneMask} that are blocked. */
    private int blockedLanes(int laneMask, double limit, CandidateList candidates) {
        setLimits(laneMask, limit, packet);
        return packetTracer.findBlocked(packet, W, candidates) & laneMask;
    }

    /** Sets limits so that inactive rays end before they start. */
    static void setLimits(int laneMask, double limit, RayPacket packet) {
        for (int i = 0; i < W; i++) {
            packet.limit[i] = (laneMask >>> i & 1) != 0 ? limit : -1;
        }
    }

    static void load(HitRows rows, RowShadowRays shadowRays, int row, RayPacket packet) {
        loadAxis(rows.px, row, shadowRays.x, shadowRays.toPoints, packet.ox, packet.dx);
        loadAxis(rows.py, row, shadowRays.y, shadowRays.toPoints, packet.oy, packet.dy);
        loadAxis(rows.pz, row, shadowRays.z, shadowRays.toPoints, packet.oz, packet.dz);
    }

    private static void loadAxis(float[] points, int row, double[] source, boolean toPoints, double[] origin, double[] direction) {
        for (int i = 0; i < W; i += DoubleLanes.COUNT) {
            DoubleVector o = (DoubleVector) FloatVector.fromArray(HALF, points, row + i).castShape(DOUBLES, 0);
            DoubleVector s = DoubleVector.fromArray(DOUBLES, source, row + i);
            o.intoArray(origin, i);
            (toPoints ? s.sub(o) : s).intoArray(direction, i);
        }
    }

    static void load(HitRows rows, ShadowRays shadowRays, int row, int laneMask, RayPacket packet) {
        loadAxis(rows.px, row, shadowRays.source().x(), shadowRays.isPoint(), packet.ox, packet.dx);
        loadAxis(rows.py, row, shadowRays.source().y(), shadowRays.isPoint(), packet.oy, packet.dy);
        loadAxis(rows.pz, row, shadowRays.source().z(), shadowRays.isPoint(), packet.oz, packet.dz);
        setLimits(laneMask, shadowRays.limit(), packet);
    }

    private static void loadAxis(float[] points, int row, double source, boolean toPoints, double[] origin, double[] direction) {
        for (int i = 0; i < W; i += DoubleLanes.COUNT) {
            DoubleVector o = (DoubleVector) FloatVector.fromArray(HALF, points, row + i).castShape(DOUBLES, 0);
            DoubleVector s = DoubleVector.broadcast(DOUBLES, source);
            o.intoArray(origin, i);
            (toPoints ? s.sub(o) : s).intoArray(direction, i);
        }
    }

    @Override
    public void findHits(ShadowRayBatch rays, CandidateList candidates, ShadowRayHits hits) {
        if (hitFinder == null) {
            hitFinder = new ShadowRayHitLanes(primitives);
        }
        hitFinder.findHits(rays, candidates, hits);
    }

    @Override
    public void writeHitSurfaces(ShadowRayBatch rays, ShadowRayHits hits) {
        if (hitSurfaces == null) {
            hitSurfaces = new HitSurfaceLanes(primitives);
        }
        hitSurfaces.write(rays, hits);
    }

    @Override
    public void exponentials(double[] values, int count) {
        PowerLanes.exponentials(values, count);
    }

    @Override
    public void setRange(float[] v, int from, int to, PointBox box, int axis) {
        FloatVector min = FloatVector.broadcast(FLOATS, v[from]);
        FloatVector max = min;
        int i = from;
        for (; i + FLOATS.length() <= to; i += FLOATS.length()) {
            FloatVector x = FloatVector.fromArray(FLOATS, v, i);
            min = min.min(x);
            max = max.max(x);
        }
        float low = min.reduceLanes(VectorOperators.MIN);
        float high = max.reduceLanes(VectorOperators.MAX);
        for (; i < to; i++) {
            low = Math.min(low, v[i]);
            high = Math.max(high, v[i]);
        }
        box.set(axis, low, high);
    }

    @Override
    public void range(double[] values, int count, double[] range) {
        DoubleVector min = DoubleVector.broadcast(DOUBLES, values[0]);
        DoubleVector max = min;
        int i = 0;
        for (; i + DOUBLES.length() <= count; i += DOUBLES.length()) {
            DoubleVector x = DoubleVector.fromArray(DOUBLES, values, i);
            min = min.min(x);
            max = max.max(x);
        }
        range[0] = min.reduceLanes(VectorOperators.MIN);
        range[1] = max.reduceLanes(VectorOperators.MAX);
        for (; i < count; i++) {
            range[0] = Math.min(range[0], values[i]);
            range[1] = Math.max(range[1], values[i]);
        }
    }
}
