package lightning.render.gather.glow;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.RaySources;
import lightning.render.trace.Geometry;
import lightning.render.trace.RayBatch;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;

/** Casts the rays that points aim at small glowing objects. Holds scratch memory: use one instance per thread. */
public final class GlowCaster {
    private final GlowShapes shapes;
    private final GlowAim aim;
    private final RayBatch batch;
    /** Point, object and weight of each ray of the batch. */
    private final int[] point = new int[RayBatch.MAX_RAYS];
    private final char[] shape = new char[RayBatch.MAX_RAYS];
    private final double[] weight = new double[RayBatch.MAX_RAYS];
    private final double[] direction = new double[3];
    private int count;
    private long rays;
    /** Elements found so far, and the points of the last one. */
    private int found;
    private int lastPoint;
    private char[] foundShapes = new char[RayBatch.MAX_RAYS];
    private final float[][] foundWeights = new float[3][RayBatch.MAX_RAYS];

    public GlowCaster(GlowShapes shapes, int raysPerPoint, Geometry geometry, Scene scene, Tracer tracer) {
        this.shapes = shapes;
        aim = new GlowAim(shapes, raysPerPoint);
        batch = new RayBatch(geometry, scene, tracer);
    }

    /** Returns the number of rays cast so far. */
    public long rayCount() {
        return rays;
    }

    /**
     * Casts the rays of points {@code from … to − 1} and returns the objects that they meet.
     *
     * @param known what points met before an edit after which their rays meet the same
     * @param find  returns the number of a point there, negative for a new one
     */
    public GlowLinks.Part cast(RaySources points, int from, int to, GlowLinks known, IntUnaryOperator find) {
        int[] counts = new int[to - from];
        found = 0;
        lastPoint = -1;
        SurfaceColumns at = points.surface;
        for (int p = from; p < to; p++) {
            int old = find.applyAsInt(p);
            if (old >= 0) {
                flush(from, counts);
                counts[p - from] = copy(known, old);
                continue;
            }
            long seed = points.seed(p);
            for (int s = 0; s < shapes.count(); s++) {
                int toShape = aim.rays(s, seed, at.px[p], at.py[p], at.pz[p]);
                for (int k = 0; k < toShape; k++) {
                    double angle = aim.aim(s, k, seed, at.px[p], at.py[p], at.pz[p], direction);
                    double cosine = angle > 0 ? points.cosine(p, direction[0], direction[1], direction[2]) : 0;
                    if (cosine > 0) {
                        add(points, p, s, angle * cosine);
                    }
                    if (count == RayBatch.MAX_RAYS) {
                        flush(from, counts);
                    }
                }
            }
        }
        flush(from, counts);
        return new GlowLinks.Part(from, counts, Arrays.copyOf(foundShapes, found), new float[][] {Arrays.copyOf(foundWeights[0], found),
            Arrays.copyOf(foundWeights[1], found), Arrays.copyOf(foundWeights[2], found)});
    }

    /** Adds the elements of a known point; returns their number. */
    private int copy(GlowLinks known, int point) {
        int elements = known.count(point);
        while (found + elements > foundShapes.length) {
            grow();
        }
        known.copy(known.first(point), elements, foundShapes, foundWeights, found);
        found += elements;
        return elements;
    }

    private void add(RaySources points, int p, int s, double itsWeight) {
        points.setStart(p, batch, count);
        batch.directionX[count] = direction[0];
        batch.directionY[count] = direction[1];
        batch.directionZ[count] = direction[2];
        point[count] = p;
        shape[count] = (char) s;
        weight[count++] = itsWeight;
    }

    private void flush(int from, int[] counts) {
        if (count == 0) {
            return;
        }
        batch.trace(count);
        rays += count;
        for (int ray = 0; ray < count; ray++) {
            if (batch.primitive(ray) == shapes.primitive(shape[ray])) {
                if (point[ray] != lastPoint || foundShapes[found - 1] != shape[ray]) {
                    append(shape[ray]);
                    lastPoint = point[ray];
                    counts[lastPoint - from]++;
                }
                for (int c = 0; c < 3; c++) {
                    foundWeights[c][found - 1] += (float) weight[ray] * (batch.isTinted() ? batch.tint[c][ray] : 1);
                }
            }
        }
        count = 0;
    }

    private void append(char itsShape) {
        if (found == foundShapes.length) {
            grow();
        }
        foundShapes[found] = itsShape;
        for (int c = 0; c < 3; c++) {
            foundWeights[c][found] = 0;
        }
        found++;
    }

    private void grow() {
        int length = 2 * foundShapes.length;
        foundShapes = Arrays.copyOf(foundShapes, length);
        for (int c = 0; c < 3; c++) {
            foundWeights[c] = Arrays.copyOf(foundWeights[c], length);
        }
    }
}
