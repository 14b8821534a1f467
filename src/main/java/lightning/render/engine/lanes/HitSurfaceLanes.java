package lightning.render.engine.lanes;

import static java.util.Objects.requireNonNull;
import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.F2D;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.ShadowRayHitFinder;
import lightning.render.trace.Tracer;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.solid.DoubleLanes;
import lightning.scene.material.Transmission;
import lightning.scene.node.Mesh;

/**
 * Lane version of {@link Tracer#writeHitSurfaces} for meshes with vertex normals: {@link SurfaceHit#computeNormal} and Fresnel
 * reflectance, operation by operation. Other shapes are computed one by one, as are hits with a triangle or a normal out of the
 * ordinary: without area, or bent toward the viewer.
 *
 * <p>Each method goes from arrays to arrays, because larger ones are not compiled to vectors. Holds scratch memory: use one per thread.
 */
final class HitSurfaceLanes {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    private static final int W = DoubleLanes.COUNT;
    private static final VectorSpecies<Float> HALF = ColumnLanes.F;
    /** Hits per pass over the arrays. */
    private static final int CHUNK = 64;
    /** Minimum number of adjacent hits on a mesh for lanes. */
    private static final int MIN_HITS = 3;

    private final PrimitiveTable primitives;
    private final ShadowRayHitFinder scalar;
    /** Rays of the hits, and the hit points in the mesh's space. */
    private final double[][] origin = new double[3][CHUNK];
    private final double[][] direction = new double[3][CHUNK];
    private final double[] t = new double[CHUNK];
    private final double[][] local = new double[3][CHUNK];
    /** Coordinate a of vertex v and of its normal at {@code 3 v + a}. */
    private final double[][] vertex = new double[9][CHUNK];
    private final double[][] vertexNormal = new double[9][CHUNK];
    /** Direction perpendicular to the triangle, later its unit normal in the scene on the visible side. */
    private final double[][] normal = new double[3][CHUNK];
    private final double[][] weight = new double[3][CHUNK];
    private final double[][] shadingNormal = new double[3][CHUNK];
    private final float[] reflectance = new float[CHUNK];
    /** Hits of the chunk that came from inside, and those out of the ordinary. */
    private long inside;
    private long special;

    HitSurfaceLanes(PrimitiveTable primitives) {
        this.primitives = primitives;
        scalar = new ShadowRayHitFinder(primitives);
    }

    /** Implements {@link Tracer#writeHitSurfaces}. */
    void write(ShadowRayBatch rays, ShadowRayHits hits) {
        int from = 0;
        while (from < hits.count()) {
            int s = hits.primitive[from];
            int to = from + 1;
            while (to < hits.count() && hits.primitive[to] == s) {
                to++;
            }
            MeshSolid mesh = primitives.mesh(s);
            boolean isSmooth = mesh != null && mesh.mesh().normals() != null && primitives.bumpMapping(s) == null;
            if (mesh != null && isSmooth && to - from >= MIN_HITS) {
                for (int i = from; i < to; i += CHUNK) {
                    writeChunk(rays, hits, mesh.mesh(), s, i, Math.min(to, i + CHUNK));
                }
            } else {
                scalar.writeSurfaces(rays, hits, from, to);
            }
            from = to;
        }
    }

    private void writeChunk(ShadowRayBatch rays, ShadowRayHits hits, Mesh mesh, int s, int from, int to) {
        int count = to - from;
        gatherRays(rays, hits, from, count);
        gatherTriangles(mesh, hits.part, from, count);
        inside = 0;
        special = 0;
        double[] m = primitives.data;
        int at = primitives.dataStart[s];
        Transmission transmission = requireNonNull(primitives.shadowTint(s)).transmission();
        for (int h = 0; h < count; h += W) {
            computePoint(m, at, h);
            computeFacet(h);
            computeWeights(h);
            computeGeometricNormal(m, at, h);
            interpolateNormal(m, at, h);
            testBending(h);
            computeReflectance(transmission, h);
        }
        for (int n = 0; n < count; n++) {
            hits.inside[from + n] = (inside >>> n & 1) != 0;
        }
        System.arraycopy(reflectance, 0, hits.reflectance, from, count);
        for (long left = special & -1L >>> -count; left != 0; left &= left - 1) {
            int i = from + Long.numberOfTrailingZeros(left);
            scalar.writeSurfaces(rays, hits, i, i + 1);
        }
    }

    private void gatherRays(ShadowRayBatch rays, ShadowRayHits hits, int from, int count) {
        for (int n = 0; n < count; n++) {
            int k = hits.ray[from + n];
            origin[0][n] = rays.ox[k];
            origin[1][n] = rays.oy[k];
            origin[2][n] = rays.oz[k];
            direction[0][n] = rays.dx[k];
            direction[1][n] = rays.dy[k];
            direction[2][n] = rays.dz[k];
            t[n] = hits.t[from + n];
        }
    }

    private void gatherTriangles(Mesh mesh, int[] triangles, int from, int count) {
        int[] vertices = mesh.triangles();
        float[] p = mesh.positions();
        float[] q = requireNonNull(mesh.normals());
        for (int v = 0; v < 3; v++) {
            double[] x = vertex[3 * v];
            double[] y = vertex[3 * v + 1];
            double[] z = vertex[3 * v + 2];
            double[] nx = vertexNormal[3 * v];
            double[] ny = vertexNormal[3 * v + 1];
            double[] nz = vertexNormal[3 * v + 2];
            for (int n = 0; n < count; n++) {
                int a = 3 * vertices[3 * triangles[from + n] + v];
                x[n] = p[a];
                y[n] = p[a + 1];
                z[n] = p[a + 2];
                nx[n] = q[a];
                ny[n] = q[a + 1];
                nz[n] = q[a + 2];
            }
        }
    }

    private void computePoint(double[] m, int i, int h) {
        DoubleVector distance = fromArray(SPECIES, t, h);
        DoubleVector x = fromArray(SPECIES, origin[0], h).add(distance.mul(fromArray(SPECIES, direction[0], h)));
        DoubleVector y = fromArray(SPECIES, origin[1], h).add(distance.mul(fromArray(SPECIES, direction[1], h)));
        DoubleVector z = fromArray(SPECIES, origin[2], h).add(distance.mul(fromArray(SPECIES, direction[2], h)));
        x.mul(m[i]).add(y.mul(m[i + 1])).add(z.mul(m[i + 2])).add(m[i + 3]).intoArray(local[0], h);
        x.mul(m[i + 4]).add(y.mul(m[i + 5])).add(z.mul(m[i + 6])).add(m[i + 7]).intoArray(local[1], h);
        x.mul(m[i + 8]).add(y.mul(m[i + 9])).add(z.mul(m[i + 10])).add(m[i + 11]).intoArray(local[2], h);
    }

    private void computeFacet(int h) {
        DoubleVector ax = fromArray(SPECIES, vertex[0], h);
        DoubleVector ay = fromArray(SPECIES, vertex[1], h);
        DoubleVector az = fromArray(SPECIES, vertex[2], h);
        DoubleVector ex = fromArray(SPECIES, vertex[3], h).sub(ax);
        DoubleVector ey = fromArray(SPECIES, vertex[4], h).sub(ay);
        DoubleVector ez = fromArray(SPECIES, vertex[5], h).sub(az);
        DoubleVector fx = fromArray(SPECIES, vertex[6], h).sub(ax);
        DoubleVector fy = fromArray(SPECIES, vertex[7], h).sub(ay);
        DoubleVector fz = fromArray(SPECIES, vertex[8], h).sub(az);
        ey.mul(fz).sub(ez.mul(fy)).intoArray(normal[0], h);
        ez.mul(fx).sub(ex.mul(fz)).intoArray(normal[1], h);
        ex.mul(fy).sub(ey.mul(fx)).intoArray(normal[2], h);
    }

    private void computeWeights(int h) {
        DoubleVector absX = fromArray(SPECIES, normal[0], h).abs();
        DoubleVector absY = fromArray(SPECIES, normal[1], h).abs();
        DoubleVector absZ = fromArray(SPECIES, normal[2], h).abs();
        VectorMask<Double> alongX = absX.compare(GE, absY).and(absX.compare(GE, absZ));
        VectorMask<Double> alongY = absY.compare(GE, absZ).andNot(alongX);
        // The two other axes, in order: y z, z x or x y.
        DoubleVector x = fromArray(SPECIES, local[0], h).blend(fromArray(SPECIES, local[1], h), alongX)
                .blend(fromArray(SPECIES, local[2], h), alongY);
        DoubleVector y = fromArray(SPECIES, local[1], h).blend(fromArray(SPECIES, local[2], h), alongX)
                .blend(fromArray(SPECIES, local[0], h), alongY);
        DoubleVector ax = fromArray(SPECIES, vertex[0], h).blend(fromArray(SPECIES, vertex[1], h), alongX)
                .blend(fromArray(SPECIES, vertex[2], h), alongY).sub(x);
        DoubleVector ay = fromArray(SPECIES, vertex[1], h).blend(fromArray(SPECIES, vertex[2], h), alongX)
                .blend(fromArray(SPECIES, vertex[0], h), alongY).sub(y);
        DoubleVector bx = fromArray(SPECIES, vertex[3], h).blend(fromArray(SPECIES, vertex[4], h), alongX)
                .blend(fromArray(SPECIES, vertex[5], h), alongY).sub(x);
        DoubleVector by = fromArray(SPECIES, vertex[4], h).blend(fromArray(SPECIES, vertex[5], h), alongX)
                .blend(fromArray(SPECIES, vertex[3], h), alongY).sub(y);
        DoubleVector cx = fromArray(SPECIES, vertex[6], h).blend(fromArray(SPECIES, vertex[7], h), alongX)
                .blend(fromArray(SPECIES, vertex[8], h), alongY).sub(x);
        DoubleVector cy = fromArray(SPECIES, vertex[7], h).blend(fromArray(SPECIES, vertex[8], h), alongX)
                .blend(fromArray(SPECIES, vertex[6], h), alongY).sub(y);
        DoubleVector area = bx.sub(ax).mul(cy.sub(ay)).sub(by.sub(ay).mul(cx.sub(ax)));
        DoubleVector a = bx.mul(cy).sub(by.mul(cx)).div(area);
        DoubleVector b = cx.mul(ay).sub(cy.mul(ax)).div(area);
        DoubleVector c = ax.mul(by).sub(ay.mul(bx)).div(area);
        DoubleVector one = broadcast(SPECIES, 1);
        DoubleVector zero = broadcast(SPECIES, 0);
        a = zero.blend(one.blend(a, a.compare(LT, 1)), a.compare(GT, 0));
        b = zero.blend(one.blend(b, b.compare(LT, 1)), b.compare(GT, 0));
        c = zero.blend(one.blend(c, c.compare(LT, 1)), c.compare(GT, 0));
        DoubleVector sum = a.add(b).add(c);
        special |= sum.compare(GT, 0).not().toLong() << h;
        a.div(sum).intoArray(weight[0], h);
        b.div(sum).intoArray(weight[1], h);
        c.div(sum).intoArray(weight[2], h);
    }

    private void computeGeometricNormal(double[] m, int i, int h) {
        DoubleVector ax = fromArray(SPECIES, normal[0], h);
        DoubleVector ay = fromArray(SPECIES, normal[1], h);
        DoubleVector az = fromArray(SPECIES, normal[2], h);
        DoubleVector bx = ax.mul(m[i]).add(ay.mul(m[i + 4])).add(az.mul(m[i + 8]));
        DoubleVector by = ax.mul(m[i + 1]).add(ay.mul(m[i + 5])).add(az.mul(m[i + 9]));
        DoubleVector bz = ax.mul(m[i + 2]).add(ay.mul(m[i + 6])).add(az.mul(m[i + 10]));
        DoubleVector square = bx.mul(bx).add(by.mul(by)).add(bz.mul(bz));
        special |= square.compare(GT, 0).not().toLong() << h;
        DoubleVector length = square.sqrt();
        VectorMask<Double> fromInside = bx.mul(fromArray(SPECIES, direction[0], h)).add(by.mul(fromArray(SPECIES, direction[1], h)))
                .add(bz.mul(fromArray(SPECIES, direction[2], h))).compare(GT, 0);
        inside |= fromInside.toLong() << h;
        DoubleVector unit = broadcast(SPECIES, 1).div(length.blend(length.neg(), fromInside));
        bx.mul(unit).intoArray(normal[0], h);
        by.mul(unit).intoArray(normal[1], h);
        bz.mul(unit).intoArray(normal[2], h);
    }

    private void interpolateNormal(double[] m, int i, int h) {
        DoubleVector sumX = broadcast(SPECIES, 0);
        DoubleVector sumY = sumX;
        DoubleVector sumZ = sumX;
        for (int v = 0; v < 3; v++) {
            DoubleVector ax = fromArray(SPECIES, vertexNormal[3 * v], h);
            DoubleVector ay = fromArray(SPECIES, vertexNormal[3 * v + 1], h);
            DoubleVector az = fromArray(SPECIES, vertexNormal[3 * v + 2], h);
            DoubleVector w = fromArray(SPECIES, weight[v], h);
            sumX = sumX.add(w.mul(ax.mul(m[i]).add(ay.mul(m[i + 4])).add(az.mul(m[i + 8]))));
            sumY = sumY.add(w.mul(ax.mul(m[i + 1]).add(ay.mul(m[i + 5])).add(az.mul(m[i + 9]))));
            sumZ = sumZ.add(w.mul(ax.mul(m[i + 2]).add(ay.mul(m[i + 6])).add(az.mul(m[i + 10]))));
        }
        VectorMask<Double> away = sumX.mul(fromArray(SPECIES, normal[0], h)).add(sumY.mul(fromArray(SPECIES, normal[1], h)))
                .add(sumZ.mul(fromArray(SPECIES, normal[2], h))).compare(LT, 0);
        sumX = sumX.blend(sumX.neg(), away);
        sumY = sumY.blend(sumY.neg(), away);
        sumZ = sumZ.blend(sumZ.neg(), away);
        DoubleVector length = sumX.mul(sumX).add(sumY.mul(sumY)).add(sumZ.mul(sumZ)).sqrt();
        special |= length.compare(GT, 0).and(length.compare(LT, Double.POSITIVE_INFINITY)).not().toLong() << h;
        sumX.div(length).intoArray(shadingNormal[0], h);
        sumY.div(length).intoArray(shadingNormal[1], h);
        sumZ.div(length).intoArray(shadingNormal[2], h);
    }

    /** Finds the hits whose shading normal is bent toward the viewer. */
    private void testBending(int h) {
        DoubleVector dx = fromArray(SPECIES, direction[0], h);
        DoubleVector dy = fromArray(SPECIES, direction[1], h);
        DoubleVector dz = fromArray(SPECIES, direction[2], h);
        DoubleVector back = broadcast(SPECIES, -1).div(dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sqrt());
        DoubleVector vx = dx.mul(back);
        DoubleVector vy = dy.mul(back);
        DoubleVector vz = dz.mul(back);
        DoubleVector x = fromArray(SPECIES, shadingNormal[0], h);
        DoubleVector y = fromArray(SPECIES, shadingNormal[1], h);
        DoubleVector z = fromArray(SPECIES, shadingNormal[2], h);
        DoubleVector twice = x.mul(vx).add(y.mul(vy)).add(z.mul(vz)).mul(2);
        DoubleVector gx = fromArray(SPECIES, normal[0], h);
        DoubleVector gy = fromArray(SPECIES, normal[1], h);
        DoubleVector gz = fromArray(SPECIES, normal[2], h);
        DoubleVector reflectedHeight = twice.mul(x).sub(vx).mul(gx).add(twice.mul(y).sub(vy).mul(gy)).add(twice.mul(z).sub(vz).mul(gz));
        DoubleVector viewerHeight = vx.mul(gx).add(vy.mul(gy)).add(vz.mul(gz));
        DoubleVector minHeight = viewerHeight.min(SurfaceHit.MIN_SINE);
        special |= twice.compare(GE, 0).and(reflectedHeight.compare(GE, minHeight)).not().toLong() << h;
    }

    private void computeReflectance(Transmission clarity, int h) {
        DoubleVector dx = fromArray(SPECIES, direction[0], h);
        DoubleVector dy = fromArray(SPECIES, direction[1], h);
        DoubleVector dz = fromArray(SPECIES, direction[2], h);
        DoubleVector length = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sqrt();
        DoubleVector c = rounded(fromArray(SPECIES, shadingNormal[0], h)).mul(rounded(dx.div(length)))
                .add(rounded(fromArray(SPECIES, shadingNormal[1], h)).mul(rounded(dy.div(length))))
                .add(rounded(fromArray(SPECIES, shadingNormal[2], h)).mul(rounded(dz.div(length)))).abs();
        double eta = 1 / clarity.ior();
        DoubleVector share = ClearTermLanes.reflectance(c, broadcast(SPECIES, eta), clarity.thin());
        ((FloatVector) share.convertShape(D2F, HALF, 0)).intoArray(reflectance, h);
    }

    private static DoubleVector rounded(DoubleVector v) {
        return (DoubleVector) v.convertShape(D2F, HALF, 0).convertShape(F2D, SPECIES, 0);
    }
}
