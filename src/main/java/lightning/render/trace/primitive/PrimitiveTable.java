package lightning.render.trace.primitive;

import java.util.Arrays;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.mesh.AlphaTest;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidKind;
import lightning.render.trace.solid.SurfaceContact;
import lightning.scene.AlphaCutout;
import lightning.scene.BumpMapping;
import lightning.scene.Material;
import lightning.scene.PlacedShape;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;

/**
 * All that rays of a scene can meet, as plain columns, in render space.
 *
 * <p>Primitive {@code s} is a canonical solid of kind {@link #kind} or a {@link #mesh}, a part of the shape with index
 * {@code owner[s]}, of material index {@code material[s]}. Its data begin at {@code data[at[s]]}, as {@link SolidGeometry} has them: the map
 * from render space to its own space, and numbers of its own. What is met of a mesh is one of its triangles, the <em>part</em> of a
 * hit; of a solid it is 0.
 */
public final class PrimitiveTable {
    /** The error of a way to a light as a share of the coordinates of its ends ({@link #placementError}). */
    public static final double SHADOW_RAY_ERROR = 0x1p-47;

    public final int count;
    public final int[] owner;
    public final int[] material;
    public final int[] dataStart;
    public final double[] data;
    /** A bound on the error of a hit point on the primitive that its distance from the camera causes, scene units. */
    public final double[] hitError;
    /** Where the primitives stand. Placed shapes are made anew for each camera: kept, each would take 112 bytes. */
    public final Stage stage;

    /** The ordinal of each solid's kind; {@link #MESH} for a mesh. */
    private final byte[] kind;
    /** The mesh of each primitive that is one; null where none is. */
    private final MeshSolid[] meshes;
    private final SurfaceTraits traits;
    /** How far a point that was put on the primitive may lie off it because shape and camera are rounded, scene units. */
    private final double[] placementError;
    /** Whether the eye lies on the primitive. */
    private final boolean[] eyeOnSurface;
    /** How far the primitive reaches from its place, scene units along an axis. */
    private final double[] extent;
    /** The largest coordinate of a primitive, render space: rays may start within it. */
    public final double maxCoordinate;
    /** More than the |x| + |y| + |z| of any point of a primitive. */
    public final double maxCoordinateSum;
    /** The most that a point put on any primitive may lie off it because shape and camera are rounded, scene units. */
    private final double maxPlacementError;

    private static final byte MESH = -1;

    /**
     * Primitives with their boxes, which the tree keeps.
     *
     * @param boxes as {@link PrimitiveBoxes} makes them
     */
    public record BoxedPrimitives(PrimitiveTable primitives, float[] boxes) {}

    /** Writes to {@code bounds}, {@code padding} and {@code roundingShare} what {@link PrimitiveBoxes} wants. */
    private PrimitiveTable(byte[] kind, MeshSolid[] meshes, SurfaceTraits traits, int[] material, int[] owner, int[] dataStart,
            double[] data,
            Stage stage, Vec3 camera, double[] bounds, double[] padding, double[] roundingShare) {
        count = kind.length;
        this.kind = kind;
        this.meshes = meshes;
        this.traits = traits;
        this.material = material;
        this.owner = owner;
        this.dataStart = dataStart;
        this.data = data;
        this.stage = stage;
        hitError = new double[count];
        placementError = new double[count];
        extent = new double[count];
        eyeOnSurface = new boolean[count];
        double[] maxima = new double[2];
        int[] next = {0};
        stage.forEachPlacedShape(shape -> {
            int s = next[0]++;
            var transform = new ObjectTransform(shape, camera);
            Transform toRenderSpace = transform.toRenderSpace;
            transform.storeInverse(data, dataStart[s]);
            extent(s, toRenderSpace.m00(), toRenderSpace.m01(), toRenderSpace.m02(), toRenderSpace.t0(), bounds, 6 * s);
            extent(s, toRenderSpace.m10(), toRenderSpace.m11(), toRenderSpace.m12(), toRenderSpace.t1(), bounds, 6 * s + 1);
            extent(s, toRenderSpace.m20(), toRenderSpace.m21(), toRenderSpace.m22(), toRenderSpace.t2(), bounds, 6 * s + 2);
            double far = 0;
            for (int i = 6 * s; i < 6 * s + 6; i++) {
                far = Math.max(far, Math.abs(bounds[i]));
            }
            hitError[s] = far * SurfaceHit.HIT_ERROR;
            padding[s] = BoxPadding.inverseErrorPadding(toRenderSpace, transform.inverse, far);
            roundingShare[s] = mesh(s) == null
                    ? BoxPadding.roundingShare(toRenderSpace, transform.inverse, kind(s).geometry().edgeMarginFactor(data, dataStart[s]))
                    : 0;
            maxima[0] = Math.max(maxima[0], far);
            computePlacementError(s, shape, transform, bounds, camera);
            eyeOnSurface[s] = surfaceDistance(s, 0, 0, 0) <= placementError[s];
            maxima[1] = Math.max(maxima[1], placementError[s]);
        });
        maxCoordinate = maxima[0];
        maxCoordinateSum = 4 * maxCoordinate;
        maxPlacementError = maxima[1];
    }

    /** @param material the material index of each shape */
    public static BoxedPrimitives of(Stage stage, int[] material, Vec3 camera) {
        List<Shape> shapes = stage.shapes();
        int count = shapes.size();
        byte[] kind = new byte[count];
        int[] owner = new int[count];
        int[] dataStart = new int[count];
        MeshSolid[] meshes = null;
        int dataCount = 0;
        for (int s = 0; s < count; s++) {
            owner[s] = s;
            dataStart[s] = dataCount;
            switch (shapes.get(s).solid()) {
                case Solid.Canonical solid -> {
                    kind[s] = (byte) SolidKind.of(solid).ordinal();
                    dataCount += SolidGeometry.MAP_SIZE + SolidKind.parameters(solid).length;
                }
                case Solid.TriangleMesh triangles -> {
                    kind[s] = MESH;
                    meshes = meshes == null ? new MeshSolid[count] : meshes;
                    meshes[s] = new MeshSolid(triangles.mesh());
                    dataCount += SolidGeometry.MAP_SIZE;
                }
            }
        }
        double[] data = new double[dataCount];
        for (int s = 0; s < count; s++) {
            if (shapes.get(s).solid() instanceof Solid.Canonical solid) {
                double[] parameters = SolidKind.parameters(solid);
                System.arraycopy(parameters, 0, data, dataStart[s] + SolidGeometry.MAP_SIZE, parameters.length);
            }
        }
        return withBoxes(kind, meshes, new SurfaceTraits(stage), material, owner, dataStart, data, stage, camera);
    }

    private static BoxedPrimitives withBoxes(byte[] kind, MeshSolid[] meshes, SurfaceTraits traits, int[] material, int[] owner,
            int[] dataStart, double[] data,
            Stage stage, Vec3 camera) {
        double[] bounds = new double[6 * kind.length];
        double[] padding = new double[kind.length];
        double[] roundingShare = new double[kind.length];
        PrimitiveTable table =
                new PrimitiveTable(kind, meshes, traits, material, owner, dataStart, data, stage, camera, bounds, padding, roundingShare);
        return new BoxedPrimitives(table, PrimitiveBoxes.of(bounds, padding, roundingShare));
    }

    /**
     * Whether all that rays read of primitive {@code s} has the same bits as what they read of primitive {@code t} of another table
     * in the same render space; materials may differ, normals that are bent, and what passes through.
     */
    public boolean hasSameGeometry(int s, PrimitiveTable other, int t) {
        return kind[s] == other.kind[t] && (kind[s] != MESH || mesh(s).mesh() == other.mesh(t).mesh())
                && Arrays.equals(data, dataStart[s], dataEnd(s), other.data, other.dataStart[t], other.dataEnd(t))
                && hitError[s] == other.hitError[t] && placementError[s] == other.placementError[t]
                && extent[s] == other.extent[t] && eyeOnSurface[s] == other.eyeOnSurface[t] && traits.hasSameCutout(s, other.traits, t);
    }

    private int dataEnd(int s) {
        return s + 1 < count ? dataStart[s + 1] : data.length;
    }

    /** The same primitives seen from elsewhere. */
    public BoxedPrimitives movedCamera(Vec3 camera) {
        return withBoxes(kind, meshes, traits, material, owner, dataStart, data.clone(), stage, camera);
    }

    /**
     * The bound on how far a point x that was put on the shape lies off the surface that rays meet, scene units.
     *
     * <p>Its own point is B·(x − place). A number of B is off by what {@code PlacementError} tells, times a distance within the
     * shape; the place by the same. Maximum norms, u = 2⁻⁵³: x and the camera are decimals made doubles and subtracted, u·(2|x|
     * + |camera|), the place u·|place|; mapping takes 4u·|x| + 4u·|place|, and for the eye, x = 0, only 3u·|place|. For the eye that
     * is all, with 4u in own units for the surface's formula, where 1 is no more than the shape's size in the scene.
     *
     * <p>A way from p to a light at x has errors of its own: 6u·|x| + u·|place| are left from above; 13u·|p| + 8u·|place| + 5u·|x| in
     * its map, and 8 units in the last place of its length in what its {@link SolidGeometry} finds, 16u·(|p| + |place|) and 16u in own units.
     * As |place| ≤ |x| + size, all of it is less than 64u of |x|, |p| and the size.
     */
    private void computePlacementError(int s, PlacedShape shape, ObjectTransform transform, double[] bounds, Vec3 camera) {
        int b = 6 * s;
        Vec3 origin = transform.renderOrigin;
        extent[s] = Math.max(new Vec3(bounds[b], bounds[b + 1], bounds[b + 2]).minus(origin).maxAbs(),
                new Vec3(bounds[b + 3], bounds[b + 4], bounds[b + 5]).minus(origin).maxAbs());
        placementError[s] = transform.inverseRelativeError() * extent[s] + shape.error().positionError()
                + 0x1p-51 * (extent[s] + origin.maxAbs() + camera.maxAbs());
    }

    /**
     * How far a light that was put on a primitive may lie off it, scene units.
     *
     * @param coordinateSum the sum of |x| + |y| + |z| at both ends of a way to it, render space
     */
    public double lightTolerance(int s, double coordinateSum) {
        return placementError[s] + SHADOW_RAY_ERROR * (extent[s] + coordinateSum);
    }

    /** No less than that of any primitive: none reaches farther from its place than {@link #maxCoordinateSum}, and rounding keeps order. */
    public double lightTolerance(double coordinateSum) {
        return maxPlacementError + SHADOW_RAY_ERROR * (maxCoordinateSum + coordinateSum);
    }

    /** How far the eye may lie off a primitive on which it was put, scene units. */
    public double eyeTolerance(int s) {
        return placementError[s];
    }

    private void extent(int s, double mx, double my, double mz, double t, double[] bounds, int i) {
        MeshSolid mesh = mesh(s);
        if (mesh == null) {
            kind(s).geometry().extent(data, dataStart[s], mx, my, mz, t, bounds, i);
        } else {
            mesh.extent(mx, my, mz, t, bounds, i);
        }
    }

    /** Whether any primitive is a mesh. */
    public boolean hasMeshes() {
        return meshes != null;
    }

    /** The mesh that primitive {@code s} is; null where it is a canonical solid. */
    public MeshSolid mesh(int s) {
        return meshes == null ? null : meshes[s];
    }

    /** How long a step of at most 1 along each axis of the scene can be in its own units. */
    public double maxScale(int s) {
        double[] m = data;
        int i = dataStart[s];
        return new Vec3(Math.abs(m[i]) + Math.abs(m[i + 1]) + Math.abs(m[i + 2]),
                Math.abs(m[i + 4]) + Math.abs(m[i + 5]) + Math.abs(m[i + 6]),
                Math.abs(m[i + 8]) + Math.abs(m[i + 9]) + Math.abs(m[i + 10])).length();
    }

    /**
     * How far a point in render space lies off the surface of a primitive at least, scene units: from the patch on each axis
     * by itself; from a solid by its own distance, which changes by no more than a point moves, over how long a step of the
     * scene can be in it.
     */
    public double surfaceDistance(int s, double x, double y, double z) {
        double[] m = data;
        int i = dataStart[s];
        double px = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        double py = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        double pz = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        MeshSolid mesh = mesh(s);
        return mesh == null ? kind(s).geometry().surfaceDistance(m, i, px, py, pz, maxScale(s))
                : mesh.surfaceDistance(px, py, pz) / maxScale(s);
    }

    /** Whether rays may pass any primitive where they meet it. */
    public boolean hasCutouts() {
        return traits.hasCutouts();
    }

    /** Whether rays may pass primitive {@code s} where they meet it. */
    public boolean hasCutout(int s) {
        return cutout(s) != null;
    }

    AlphaCutout cutout(int s) {
        return traits.cutout(s);
    }

    /** Where a ray finds holes in primitive {@code s}, which has some. */
    private CutoutTest cutoutTest(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return new CutoutTest(this).setRay(s, ox, oy, oz, dx, dy, dz);
    }

    /** What bends the normals of primitive {@code s}; null for nothing. */
    public BumpMapping bumpMapping(int s) {
        return traits.bumpMapping(s);
    }

    /** Whether rays go on behind primitive {@code s} as they do behind primitive {@code t} of another table. */
    public boolean refractsLike(int s, PrimitiveTable o, int t) {
        return traits.refractsLike(s, o.traits, t);
    }

    /** Whether normals of primitive {@code s} are bent as those of primitive {@code t} of another table. */
    public boolean hasSameNormals(int s, PrimitiveTable o, int t) {
        return traits.hasSameNormals(s, o.traits, t);
    }

    /** Whether primitive {@code s} shows colors of its vertices. */
    public boolean hasVertexColors(int s) {
        return meshes != null && stage.shapes().get(owner[s]).solid() instanceof Solid.TriangleMesh triangles
                && triangles.hasVertexColors();
    }

    /** The kind of a canonical solid. */
    public SolidKind kind(int s) {
        return SolidKind.fromOrdinal(kind[s]);
    }

    /** Whether the eye lies on primitive {@code s}: it then does not hide from the eye what is before it. */
    public boolean isEyeOnSurface(int s) {
        return eyeOnSurface[s];
    }

    /** The distance along the ray to primitive {@code s}, or {@code +∞}; a ray from the origin of render space is the eye's. */
    public double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(s, ox, oy, oz, dx, dy, dz, contact(s, ox, oy, oz));
    }

    private SurfaceContact contact(int s, double ox, double oy, double oz) {
        return eyeOnSurface[s] && ox == 0 && oy == 0 && oz == 0 ? SurfaceContact.START : SurfaceContact.NONE;
    }

    /** Hands a mesh and a ray, which is the eye's where it begins at the origin of render space, to a probe. */
    public void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact(s, ox, oy, oz));
    }

    /** The same for a way that perhaps ends on the mesh. */
    public void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz, boolean ends) {
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, ends ? SurfaceContact.END : contact(s, ox, oy, oz));
    }

    /** The same for a way of which an end may lie on the mesh: it passes the triangles on which it may. */
    public void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact contact) {
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact, cutout(s) == null ? null : cutoutTest(s, ox, oy, oz, dx, dy, dz));
    }

    /** The same through a sieve; null for none. */
    private void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact contact,
            AlphaTest alphaTest) {
        double[] m = data;
        int i = dataStart[s];
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        probe.setRay(meshes[s], px, py, pz, vx, vy, vz);
        if (alphaTest != null) {
            probe.setAlphaTest(alphaTest);
        }
        switch (contact) {
            case NONE -> {}
            case START -> probe.ignoreNear(px, py, pz, maxScale(s) * eyeTolerance(s));
            case END -> probe.ignoreNear(px + vx, py + vy, pz + vz, maxScale(s) * lightTolerance(s, coordinateSum(ox, oy, oz, dx, dy, dz)));
        }
    }

    /** The sum of |x| + |y| + |z| at both ends of a way. */
    private static double coordinateSum(double ox, double oy, double oz, double dx, double dy, double dz) {
        return Math.abs(ox + dx) + Math.abs(oy + dy) + Math.abs(oz + dz) + Math.abs(ox) + Math.abs(oy) + Math.abs(oz);
    }

    /** Asks all triangles of mesh {@code s}. */
    private double bruteForceDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact) {
        MeshRayQuery probe = new MeshRayQuery();
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact);
        return probe.nearestBruteForce();
    }

    /** The part of primitive {@code s} that a ray meets first; the primitive is met. */
    public int hitPart(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        if (mesh(s) == null) {
            return 0;
        }
        MeshRayQuery probe = new MeshRayQuery();
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz);
        probe.nearestBruteForce();
        return probe.triangle();
    }

    /** The distance along a way of which an end may lie on primitive {@code s}, or {@code +∞}; every triangle of a mesh is asked. */
    public double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact) {
        if (mesh(s) != null) {
            return bruteForceDistance(s, ox, oy, oz, dx, dy, dz, contact);
        }
        double t = solidDistance(s, ox, oy, oz, dx, dy, dz, contact);
        if (t == SolidGeometry.MISS || cutout(s) == null) {
            return t;
        }
        return cutoutDistance(s, ox, oy, oz, dx, dy, dz, contact, t, SolidGeometry.MISS, cutoutTest(s, ox, oy, oz, dx, dy, dz));
    }

    /**
     * The distance to what is there first of a solid with holes, which a ray that neither begins nor ends on it meets at {@code t} if nothing is
     * missing; {@code +∞} where nothing is there, and perhaps where it lies beyond a limit.
     *
     * @param cutoutTest scratch
     */
    public double cutoutDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, double t, double limit,
            CutoutTest cutoutTest) {
        return cutoutDistance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.NONE, t, limit, cutoutTest.setRay(s, ox, oy, oz, dx, dy, dz));
    }

    private double cutoutDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact, double t,
            double limit,
            CutoutTest cutoutTest) {
        if (!cutoutTest.passes(0, t)) {
            return t;
        }
        double out = exitDistance(s, ox, oy, oz, dx, dy, dz, contact, t);
        return out < SolidGeometry.MISS && out <= limit && !cutoutTest.passes(0, out) ? out : SolidGeometry.MISS;
    }

    /** The distance to a surface without holes. */
    private double solidDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact) {
        double tolerance = switch (contact) {
            case NONE -> 0;
            case START -> eyeTolerance(s);
            case END -> lightTolerance(s, coordinateSum(ox, oy, oz, dx, dy, dz));
        };
        return solidDistance(s, ox, oy, oz, dx, dy, dz, contact, tolerance);
    }

    /** The same where the end that lies on the surface is off it by so much, in scene space. */
    private double solidDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact,
            double tolerance) {
        double[] m = data;
        int i = dataStart[s];
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        SolidGeometry form = kind(s).geometry();
        if (contact == SurfaceContact.NONE) {
            return form.distance(m, i, px, py, pz, vx, vy, vz);
        }
        double margin =
                tolerance == 0 ? 0 : 2 * form.edgeMarginFactor(m, i) * maxScale(s) * tolerance / Math.sqrt(vx * vx + vy * vy + vz * vz);
        return form.distance(m, i, px, py, pz, vx, vy, vz, contact, margin);
    }

    /** The distance to where a ray that met a convex surface at {@code t} meets it once more, or {@code +∞}. */
    private double exitDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact, double t) {
        double out =
                contact == SurfaceContact.NONE ? solidDistance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.START, 0) : SolidGeometry.MISS;
        return out > t ? out : SolidGeometry.MISS;
    }

    /** Whether light on its way to a point passes any primitive. */
    public boolean hasShadowTints() {
        return traits.hasShadowTints();
    }

    /** The material of primitive {@code s} where light on its way to a point passes it; else null. */
    public Material shadowTint(int s) {
        return traits.shadowTint(s);
    }

    /** Whether light passes primitive {@code s} as it passes primitive {@code t} of another table. */
    public boolean hasSameShadowTint(int s, PrimitiveTable o, int t) {
        return traits.hasSameShadowTint(s, o.traits, t);
    }

    /**
     * Adds all places where a way meets primitive {@code s} before a distance.
     *
     * @param ends  whether it ends on the primitive
     * @param probe for meshes
     * @param bruteForce whether each triangle of a mesh is asked
     */
    public void addHits(int s, double ox, double oy, double oz, double dx, double dy, double dz, boolean ends, double limit,
            MeshRayQuery probe, boolean bruteForce, ShadowRayHits hits) {
        SurfaceContact contact = ends ? SurfaceContact.END : contact(s, ox, oy, oz);
        CutoutTest cutoutTest = cutout(s) == null ? null : cutoutTest(s, ox, oy, oz, dx, dy, dz);
        if (mesh(s) != null) {
            // What is passed is noted, and all is.
            setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact, (triangle, t) -> {
                hits.add(s, triangle, t, limit, cutoutTest);
                return true;
            });
            if (bruteForce) {
                probe.nearestBruteForce();
            } else {
                probe.isBlocked(limit);
            }
            return;
        }
        double t = solidDistance(s, ox, oy, oz, dx, dy, dz, contact);
        if (t < SolidGeometry.MISS) {
            hits.add(s, 0, t, limit, cutoutTest);
            hits.add(s, 0, exitDistance(s, ox, oy, oz, dx, dy, dz, contact, t), limit, cutoutTest);
        }
    }

    /** The same for a solid without holes, which a way that neither begins nor ends on it is known to meet first at {@code t}. */
    public void addHits(int s, double ox, double oy, double oz, double dx, double dy, double dz, double t, double limit,
            ShadowRayHits hits) {
        hits.add(s, 0, t, limit, null);
        hits.add(s, 0, exitDistance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.NONE, t), limit, null);
    }
}
