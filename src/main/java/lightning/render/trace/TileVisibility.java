package lightning.render.trace;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Visibility pass: traces the rays of one tile and writes the hit rows. Holds scratch memory: use one per thread. */
public final class TileVisibility {
    /** Provides the columns for the rows: new ones to keep, or reused ones. */
    @FunctionalInterface
    public interface Allocator {
        HitRows allocate(int count, TexelColumns texels, boolean transparent);
    }

    private final MaterialTable materials;
    private final CameraRays camera;
    private final int width;
    private final int height;
    private final Geometry geometry;
    private final Tracer tracer;
    private final RayBeam beam = new RayBeam();
    private final BoxRay boxRay = new BoxRay();
    private final CandidateList candidates = new CandidateList();
    private final RayColumns rays;
    /** Sample patterns by the slots of the rays; undefined for rays of pixel centers. */
    private byte @Nullable [] patterns = {};
    private final double[] direction = new double[3];
    private final HitRowBuilder rowBuilder;

    public TileVisibility(Geometry geometry, Scene scene, Tracer tracer) {
        this.geometry = geometry;
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        rays = new RayColumns(camera);
        width = scene.picture().width();
        height = scene.picture().height();
        this.tracer = tracer;
        rowBuilder = new HitRowBuilder(geometry, tracer);
    }

    /**
     * Traces the camera rays of the tile whose upper left pixel is {@code x0, y0}.
     *
     * @param size pixels along a side of the tile, at most 32
     * @return rows of the pixels that hit a shape; {@code parent} is the pixel's index in the tile
     */
    public HitRows traceEyeRays(int x0, int y0, int size, Allocator allocator) {
        int columns = Math.min(size, width - x0);
        int lines = Math.min(size, height - y0);
        setCenterRays(x0, y0, size, columns, lines);
        camera.boundBeam(beam, x0, y0, columns, lines);
        candidates.collect(geometry.bvh(), beam);
        tracer.findNearest(rays, candidates);
        return rowBuilder.build(rays, patterns, allocator);
    }

    private void setCenterRays(int x0, int y0, int size, int columns, int lines) {
        rays.startAtEye();
        rays.count = columns * lines;
        rays.columns = columns;
        for (int y = 0, ray = 0; y < lines; y++) {
            for (int x = 0; x < columns; x++) {
                rays.slot[ray++] = (short) (y * size + x);
            }
        }
        tracer.directEyeRays(camera, x0, y0, columns, lines, rays);
    }

    private void setSampleRays(SamplePositions positions) {
        rays.count = positions.count();
        rays.columns = 0;
        byte[] written = new byte[rays.count];
        for (int ray = 0; ray < rays.count; ray++) {
            rays.slot[ray] = (short) ray;
        }
        positions.writePatterns(written);
        patterns = written;
        rays.startAtSamples(positions, tracer);
    }

    /** Sets the camera rays of some positions; of the pixel centers only those inside the image. */
    private void setEyeRays(SamplePositions positions) {
        if (positions.pixels() == null) {
            int columns = Math.min(SamplePositions.SIDE, width - positions.x0());
            int lines = Math.min(SamplePositions.SIDE, height - positions.y0());
            setCenterRays(positions.x0(), positions.y0(), SamplePositions.SIDE, columns, lines);
        } else {
            setSampleRays(positions);
        }
    }

    private boolean canEyeRaysHit(SamplePositions positions, BoxSet boxes) {
        if (positions.pixels() == null) {
            camera.boundBeam(beam, positions.x0(), positions.y0(), Math.min(SamplePositions.SIDE, width - positions.x0()),
                    Math.min(SamplePositions.SIDE, height - positions.y0()));
        } else {
            rays.boundCameraRays(beam, positions, tracer);
        }
        return boxes.intersects(beam);
    }

    /** Returns the indices of the positions whose camera rays can hit any of the boxes. */
    public BitSet eyeRaysThroughBoxes(SamplePositions positions, BoxSet boxes) {
        boolean startOnLens = positions.startOnLens(camera);
        if (boxes.isEmpty() || !startOnLens && !canEyeRaysHit(positions, boxes)) {
            return new BitSet();
        }
        setEyeRays(positions);
        return startOnLens && !canEyeRaysHit(positions, boxes) ? new BitSet() : raysThroughBoxes(boxes);
    }

    /** Returns the rows of a level whose secondary rays of a kind can hit any of the boxes. */
    public BitSet raysThroughBoxes(HitRows parentRows, BounceKind bounce, BoxSet boxes) {
        if (bounce.rowCount(parentRows) == 0 || boxes.isEmpty()) {
            return new BitSet();
        }
        setBounceRays(parentRows, bounce);
        if (rays.count == 0) {
            return new BitSet();
        }
        boundBeam(bounce);
        return boxes.intersects(beam) ? raysThroughBoxes(boxes) : new BitSet();
    }

    private BitSet raysThroughBoxes(BoxSet boxes) {
        BitSet result = new BitSet();
        for (int i = 0; i < rays.count; i++) {
            boxRay.setRay(rays.originX(i), rays.originY(i), rays.originZ(i), rays.dx[i], rays.dy[i], rays.dz[i]);
            if (boxes.intersects(boxRay, Double.POSITIVE_INFINITY)) {
                result.set(rays.slot[i]);
            }
        }
        return result;
    }

    /**
     * Traces the camera rays of some positions.
     *
     * @param selected indices of those positions, at least one
     * @return rows of the rays that hit a shape; {@code parent} is the position's index
     */
    public HitRows traceEyeRays(SamplePositions positions, BitSet selected, Allocator allocator) {
        setEyeRays(positions);
        int count = 0;
        for (int i = 0; i < rays.count; i++) {
            if (selected.get(rays.slot[i])) {
                rays.slot[count] = rays.slot[i];
                rays.dx[count] = rays.dx[i];
                rays.dy[count] = rays.dy[i];
                rays.dz[count++] = rays.dz[i];
            }
        }
        rays.count = count;
        rays.columns = 0;
        rays.bound(beam, tracer);
        candidates.collect(geometry.bvh(), beam);
        tracer.findNearest(rays, candidates);
        return rowBuilder.build(rays, patterns, allocator);
    }

    /**
     * Traces finer samples of some pixels of a tile.
     *
     * @param positions sample positions, at most 1024
     * @return rows of the samples that hit a shape; {@code parent} is the sample's number
     */
    public HitRows traceSamples(SamplePositions positions, Allocator allocator) {
        setSampleRays(positions);
        rays.boundCameraRays(beam, positions, tracer);
        candidates.collect(geometry.bvh(), beam);
        tracer.findNearest(rays, candidates);
        return rowBuilder.build(rays, patterns, allocator);
    }

    /**
     * Finds the primitives that camera rays hit first.
     *
     * @param positions pixel centers of a tile, or at most 1024 finer samples
     * @return primitive of each ray, −1 for none; of pixel centers those inside the image, line by line
     */
    public int[] primitives(SamplePositions positions) {
        setEyeRays(positions);
        if (positions.pixels() == null) {
            camera.boundBeam(beam, positions.x0(), positions.y0(), rays.columns, rays.count / rays.columns);
        } else {
            rays.boundCameraRays(beam, positions, tracer);
        }
        candidates.collect(geometry.bvh(), beam);
        tracer.findNearest(rays, candidates);
        return hitShapes();
    }

    /**
     * Traces the secondary rays of a kind from a level's rows.
     *
     * @param knownPrimitives shape that each ray hits, −1 for none, if known; otherwise null
     * @return hit rows; {@code parent} is the row that cast the ray
     */
    public HitRows traceBounceRays(HitRows parentRows, BounceKind bounce, int @Nullable [] knownPrimitives, Allocator allocator) {
        setBounceRays(parentRows, bounce);
        if (knownPrimitives == null) {
            findNearest(bounce);
        } else {
            System.arraycopy(knownPrimitives, 0, rays.primitive, 0, rays.count);
            tracer.writeDistances(rays);
        }
        return rowBuilder.build(rays, patterns, allocator);
    }

    /**
     * Traces the secondary rays of a kind from some of a level's rows.
     *
     * @param selected those rows
     * @return rows as from {@link #traceBounceRays(HitRows, BounceKind, int[], Allocator)}
     */
    public HitRows traceSelectedBounceRays(HitRows parentRows, BounceKind bounce, BitSet selected, Allocator allocator) {
        int count = 0;
        for (int row = selected.nextSetBit(0); row >= 0; row = selected.nextSetBit(row + 1)) {
            rays.slot[count++] = (short) row;
        }
        setBounceRays(parentRows, bounce, count);
        findNearest(bounce);
        return rowBuilder.build(rays, patterns, allocator);
    }

    /** Returns the number of rays of the latest trace. */
    public int rayCount() {
        return rays.count;
    }

    /** Sets the secondary rays of all rows. */
    private void setBounceRays(HitRows parentRows, BounceKind bounce) {
        int count = bounce.rowCount(parentRows);
        for (int i = 0; i < count; i++) {
            rays.slot[i] = (short) i;
        }
        setBounceRays(parentRows, bounce, count);
    }

    /** Sets the secondary rays of the rows in the first {@code count} slots. Drops the slots of rows that cast no ray. */
    private void setBounceRays(HitRows parentRows, BounceKind bounce, int count) {
        rays.startAtRows(parentRows, bounce);
        rays.columns = 0;
        patterns = parentRows.pattern;
        int castCount = 0;
        for (int i = 0; i < count; i++) {
            if (bounce.writeDirection(parentRows, rays.slot[i], materials, direction)) {
                rays.slot[castCount] = rays.slot[i];
                rays.dx[castCount] = direction[0];
                rays.dy[castCount] = direction[1];
                rays.dz[castCount++] = direction[2];
            }
        }
        rays.count = castCount;
    }

    /** Finds the nearest hits of rays from rows. */
    private void findNearest(BounceKind bounce) {
        if (rays.count == 0) {
            return;
        }
        boundBeam(bounce);
        candidates.collect(geometry.bvh(), beam);
        tracer.findNearest(rays, candidates);
    }

    /** Sets the beam to bound the rays from rows; there must be at least one. */
    private void boundBeam(BounceKind bounce) {
        HitRows sourceRows = rays.sourceRows;
        if (sourceRows != null && rays.count == bounce.rowCount(sourceRows)) {
            beam.clear();
            beam.addOrigins(
                    tracer.bounds(bounce.originX(sourceRows), bounce.originY(sourceRows), bounce.originZ(sourceRows), 0, rays.count));
            rays.addDirectionsTo(beam, tracer);
        } else {
            rays.bound(beam, tracer);
        }
    }

    /** Returns the shape that each ray of the latest trace hit, −1 for none. */
    public int[] hitShapes() {
        return Arrays.copyOf(rays.primitive, rays.count);
    }
}
