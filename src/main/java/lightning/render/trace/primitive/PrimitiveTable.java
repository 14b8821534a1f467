package lightning.render.trace.primitive;

import java.util.Arrays;
import java.util.List;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.mesh.AlphaTest;
import lightning.render.trace.mesh.LightBuffer;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SolidKind;
import lightning.render.trace.solid.SurfaceContact;
import lightning.scene.PlacedShape;
import lightning.scene.Stage;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.jspecify.annotations.Nullable;

/**
 * All primitives of a scene as columns, in render space.
 *
 * <p>Primitive {@code s} is a canonical solid of kind {@link #kind} or a {@link #mesh}, a part of the shape with index
 * {@code owner[s]}, with material index {@code material[s]}. Its data begins at {@code data[dataStart[s]]} in the layout of
 * {@link SolidGeometry}: the transform from render space to local space, then its parameters. A hit on a mesh is on one of its
 * triangles, the <em>part</em> of the hit; for a solid the part is 0.
 */
public final class PrimitiveTable {
    /** Error of a shadow ray relative to the coordinates of its ends ({@link #placementError}). */
    public static final double SHADOW_RAY_ERROR = 0x1p-47;

    public final int count;
    public final int[] owner;
    public final int[] material;
    public final int[] dataStart;
    public final double[] data;
    /** Error bound of a hit point on the primitive because of its distance from the camera, scene units. */
    public final double[] hitError;
    /** Stage with the placements. Placed shapes are recreated for each camera: storing them would take 112 bytes each. */
    public final Stage stage;

    /** Ordinal of each solid's kind; {@link #MESH} for a mesh. */
    private final byte[] kind;
    /** Meshes by primitive; null if there are none. */
    private final MeshSolid @Nullable [] meshes;
    private final SurfaceTraits traits;
    /** Maximum distance from the primitive of a point placed on it, because shape and camera are rounded, scene units. */
    private final double[] placementError;
    /** True for primitives that contain the eye. */
    private final boolean[] eyeOnSurface;
    /** Maximum distance of the primitive from its position, scene units along an axis. */
    private final double[] extent;
    /** Largest coordinate of any primitive, render space: rays may start within it. */
    public final double maxCoordinate;
    /** Largest radius of a lens that boxes allow for, scene units. */
    public final double maxLens;
    /** Upper bound on |x| + |y| + |z| of any point of a primitive. */
    public final double maxCoordinateSum;
    /** Maximum of {@link #placementError} over all primitives, scene units. */
    private final double maxPlacementError;

    private static final byte MESH = -1;

    /**
     * Primitives with their boxes, which the BVH stores.
     *
     * @param primitives table of the primitives
     * @param boxes boxes from {@link PrimitiveBoxes}
     */
    public record BoxedPrimitives(PrimitiveTable primitives, float[] boxes) {}

    /** Also writes {@code bounds}, {@code padding} and {@code roundingShare} for {@link PrimitiveBoxes}. */
    private PrimitiveTable(byte[] kind, MeshSolid @Nullable [] meshes, SurfaceTraits traits, int[] material, int[] owner, int[] dataStart,
            double[] data,
            Stage stage, Vec3 camera, double lens, double[] bounds, double[] padding, double[] roundingShare) {
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
        maxLens = Math.max(maxima[0], lens);
        maxCoordinateSum = 4 * maxCoordinate;
        maxPlacementError = maxima[1];
    }

    /**
     * @param material material index of each shape
     * @param lens     radius of the camera's lens, on which rays start
     */
    public static BoxedPrimitives of(Stage stage, int[] material, Vec3 camera, double lens) {
        List<Shape> shapes = stage.shapes();
        int count = shapes.size();
        byte[] kind = new byte[count];
        int[] owner = new int[count];
        int[] dataStart = new int[count];
        MeshSolid @Nullable [] meshes = null;
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
        return withBoxes(kind, meshes, new SurfaceTraits(stage), material, owner, dataStart, data, stage, camera, lens);
    }

    private static BoxedPrimitives withBoxes(byte[] kind, MeshSolid @Nullable [] meshes, SurfaceTraits traits, int[] material, int[] owner,
            int[] dataStart, double[] data,
            Stage stage, Vec3 camera, double lens) {
        double[] bounds = new double[6 * kind.length];
        double[] padding = new double[kind.length];
        double[] roundingShare = new double[kind.length];
        PrimitiveTable table =
                new PrimitiveTable(kind, meshes, traits, material, owner, dataStart, data, stage, camera, lens, bounds, padding,
                        roundingShare);
        return new BoxedPrimitives(table, PrimitiveBoxes.of(bounds, padding, roundingShare, lens));
    }

    /**
     * Returns whether rays read the same bits of primitive {@code s} and of primitive {@code t} of another table in the same
     * render space. Materials, bent normals and transmission may differ.
     */
    public boolean hasSameGeometry(int s, PrimitiveTable other, int t) {
        MeshSolid mesh = mesh(s);
        MeshSolid otherMesh = other.mesh(t);
        return kind[s] == other.kind[t] && (mesh == null || otherMesh == null || mesh.mesh() == otherMesh.mesh())
                && Arrays.equals(data, dataStart[s], dataEnd(s), other.data, other.dataStart[t], other.dataEnd(t))
                && hitError[s] == other.hitError[t] && placementError[s] == other.placementError[t]
                && extent[s] == other.extent[t] && eyeOnSurface[s] == other.eyeOnSurface[t] && traits.hasSameCutout(s, other.traits, t);
    }

    private int dataEnd(int s) {
        return s + 1 < count ? dataStart[s + 1] : data.length;
    }

    /** Returns the same primitives seen from another camera position through another lens. */
    public BoxedPrimitives movedCamera(Vec3 camera, double lens) {
        return withBoxes(kind, meshes, traits, material, owner, dataStart, data.clone(), stage, camera, lens);
    }

    /**
     * Computes the bound on the distance of a point placed on the shape from the surface that rays hit, scene units. Proof:
     * docs/numerics.md, "Proof: points placed on a surface".
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
     * Returns the maximum distance of a light placed on a primitive from it, scene units.
     *
     * @param coordinateSum sum of |x| + |y| + |z| at both ends of a shadow ray, render space
     */
    public double lightTolerance(int s, double coordinateSum) {
        return placementError[s] + SHADOW_RAY_ERROR * (extent[s] + coordinateSum);
    }

    /**
     * Returns an upper bound of the tolerance for any primitive: none extends farther from its position than
     * {@link #maxCoordinateSum}, and rounding is monotone.
     */
    public double lightTolerance(double coordinateSum) {
        return maxPlacementError + SHADOW_RAY_ERROR * (maxCoordinateSum + coordinateSum);
    }

    /** Returns the maximum distance of an eye placed on a primitive from it, scene units. */
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

    /** Returns whether any primitive is a mesh. */
    public boolean hasMeshes() {
        return meshes != null;
    }

    /** Returns the mesh of primitive {@code s}; null for a canonical solid. */
    public @Nullable MeshSolid mesh(int s) {
        return meshes == null ? null : meshes[s];
    }

    /** Returns the maximum local length of a step of at most 1 along each axis of the scene. */
    public double maxScale(int s) {
        double[] m = data;
        int i = dataStart[s];
        return new Vec3(Math.abs(m[i]) + Math.abs(m[i + 1]) + Math.abs(m[i + 2]),
                Math.abs(m[i + 4]) + Math.abs(m[i + 5]) + Math.abs(m[i + 6]),
                Math.abs(m[i + 8]) + Math.abs(m[i + 9]) + Math.abs(m[i + 10])).length();
    }

    /**
     * Returns a lower bound on the distance of a point in render space from the surface of a primitive, scene units. Uses each
     * axis separately for the plane. For other solids it uses the local distance, divided by the maximum local length of a
     * scene step.
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

    /** Returns whether any primitive has cutouts. */
    public boolean hasCutouts() {
        return traits.hasCutouts();
    }

    /** Returns whether primitive {@code s} has cutouts. */
    public boolean hasCutout(int s) {
        return cutout(s) != null;
    }

    @Nullable
    AlphaCutout cutout(int s) {
        return traits.cutout(s);
    }

    /** Returns the alpha test of a ray for primitive {@code s}, which has cutouts. */
    private CutoutTest cutoutTest(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return new CutoutTest(this).setRay(s, ox, oy, oz, dx, dy, dz);
    }

    /** Returns the bump mapping of primitive {@code s}; null for none. */
    public @Nullable BumpMapping bumpMapping(int s) {
        return traits.bumpMapping(s);
    }

    /** Returns whether primitive {@code s} may be shaded by other normals than those of its surface. */
    public boolean hasShadingNormals(int s) {
        MeshSolid mesh = mesh(s);
        return bumpMapping(s) != null || mesh != null && mesh.mesh().normals() != null;
    }

    /** Returns whether primitive {@code s} refracts rays like primitive {@code t} of another table. */
    public boolean refractsLike(int s, PrimitiveTable o, int t) {
        return traits.refractsLike(s, o.traits, t);
    }

    /** Returns whether primitive {@code s} has the bump mapping of primitive {@code t} of another table. */
    public boolean hasSameNormals(int s, PrimitiveTable o, int t) {
        return traits.hasSameNormals(s, o.traits, t);
    }

    /** Returns whether primitive {@code s} shows vertex colors. */
    public boolean hasVertexColors(int s) {
        return meshes != null && stage.shapes().get(owner[s]).solid() instanceof Solid.TriangleMesh triangles
                && triangles.hasVertexColors();
    }

    /** Returns the kind of a canonical solid. */
    public SolidKind kind(int s) {
        return SolidKind.fromOrdinal(kind[s]);
    }

    /** Returns whether the eye is on primitive {@code s}, which then does not hide other primitives from it. */
    public boolean isEyeOnSurface(int s) {
        return eyeOnSurface[s];
    }

    /**
     * Returns the distance along the ray to primitive {@code s}, or {@code +∞}. A ray from the origin of render space is a
     * camera ray.
     */
    public double distance(int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        return distance(s, ox, oy, oz, dx, dy, dz, contact(s, ox, oy, oz));
    }

    private SurfaceContact contact(int s, double ox, double oy, double oz) {
        return eyeOnSurface[s] && ox == 0 && oy == 0 && oz == 0 ? SurfaceContact.START : SurfaceContact.NONE;
    }

    /** Sets a mesh and a ray on a query. A ray from the origin of render space is a camera ray. */
    public void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz) {
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact(s, ox, oy, oz));
    }

    /** Sets a mesh and a shadow ray, which may end on the mesh, on a query. */
    public void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz, boolean ends) {
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, ends ? SurfaceContact.END : contact(s, ox, oy, oz));
    }

    /** Sets a mesh and a ray with a contact on a query. The ray ignores triangles that may contain that end. */
    public void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact contact) {
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact, cutout(s) == null ? null : cutoutTest(s, ox, oy, oz, dx, dy, dz));
    }

    /** Sets a mesh and a ray with an alpha test, null for none, on a query. */
    private void setProbeRay(MeshRayQuery probe, int s, double ox, double oy, double oz, double dx, double dy, double dz,
            SurfaceContact contact, @Nullable AlphaTest alphaTest) {
        double[] m = data;
        int i = dataStart[s];
        double px = m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3];
        double py = m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7];
        double pz = m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11];
        double vx = m[i] * dx + m[i + 1] * dy + m[i + 2] * dz;
        double vy = m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz;
        double vz = m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz;
        assert meshes != null;
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

    /** Returns the sum of |x| + |y| + |z| at both ends of a shadow ray. */
    private static double coordinateSum(double ox, double oy, double oz, double dx, double dy, double dz) {
        return Math.abs(ox + dx) + Math.abs(oy + dy) + Math.abs(oz + dz) + Math.abs(ox) + Math.abs(oy) + Math.abs(oz);
    }

    /** Tests all triangles of mesh {@code s}. */
    private double bruteForceDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact) {
        MeshRayQuery probe = new MeshRayQuery();
        setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact);
        return probe.nearestBruteForce();
    }

    /**
     * Returns the distance along a ray with one end possibly on primitive {@code s}, or {@code +∞}; tests every triangle of a
     * mesh.
     */
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
     * Returns the distance to the first hit on a solid with cutouts for a ray with no contact that hits the full surface at
     * {@code t}. Returns {@code +∞} if both crossings are in holes, and possibly if the hit is beyond a limit.
     *
     * @param cutoutTest scratch memory
     */
    public double cutoutDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, double t, double limit,
            CutoutTest cutoutTest) {
        return cutoutDistance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.NONE, t, limit, cutoutTest.setRay(s, ox, oy, oz, dx, dy, dz));
    }

    private double cutoutDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact, double t,
            double limit,
            CutoutTest cutoutTest) {
        if (!cutoutTest.isHole(0, t)) {
            return t;
        }
        double out = exitDistance(s, ox, oy, oz, dx, dy, dz, contact, t);
        return out < SolidGeometry.MISS && out <= limit && !cutoutTest.isHole(0, out) ? out : SolidGeometry.MISS;
    }

    /** Returns the distance to a surface without cutouts. */
    private double solidDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact) {
        double tolerance = switch (contact) {
            case NONE -> 0;
            case START -> eyeTolerance(s);
            case END -> lightTolerance(s, coordinateSum(ox, oy, oz, dx, dy, dz));
        };
        return solidDistance(s, ox, oy, oz, dx, dy, dz, contact, tolerance);
    }

    /** Returns the distance to a surface without cutouts if the end in contact is off by an error, in scene units. */
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

    /**
     * Returns the distance of the second crossing of a convex surface by a ray that crosses it first at {@code t}, or
     * {@code +∞}.
     */
    private double exitDistance(int s, double ox, double oy, double oz, double dx, double dy, double dz, SurfaceContact contact, double t) {
        double out =
                contact == SurfaceContact.NONE ? solidDistance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.START, 0) : SolidGeometry.MISS;
        return out > t ? out : SolidGeometry.MISS;
    }

    /** Returns whether any primitive transmits shadow rays with a tint. */
    public boolean hasShadowTints() {
        return traits.hasShadowTints();
    }

    /** Returns the material of primitive {@code s} if it tints shadow rays, otherwise null. */
    public @Nullable Material shadowTint(int s) {
        return traits.shadowTint(s);
    }

    /** Returns whether primitive {@code s} tints shadow rays like primitive {@code t} of another table. */
    public boolean hasSameShadowTint(int s, PrimitiveTable o, int t) {
        return traits.hasSameShadowTint(s, o.traits, t);
    }

    /**
     * Adds all hits of a shadow ray on primitive {@code s} before a distance.
     *
     * @param ends true if the ray ends on the primitive
     * @param probe query for meshes
     * @param bruteForce true to test each triangle of a mesh
     */
    public void addHits(int s, double ox, double oy, double oz, double dx, double dy, double dz, boolean ends, double limit,
            MeshRayQuery probe, boolean bruteForce, ShadowRayHits hits) {
        SurfaceContact contact = ends ? SurfaceContact.END : contact(s, ox, oy, oz);
        CutoutTest cutoutTest = cutout(s) == null ? null : cutoutTest(s, ox, oy, oz, dx, dy, dz);
        if (mesh(s) != null) {
            setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, contact, null);
            if (bruteForce) {
                probe.collectHitsBruteForce(limit);
            } else {
                probe.collectHits(limit);
            }
            addHits(s, probe, limit, cutoutTest, hits);
            return;
        }
        double t = solidDistance(s, ox, oy, oz, dx, dy, dz, contact);
        if (t < SolidGeometry.MISS) {
            hits.add(s, 0, t, limit, cutoutTest);
            hits.add(s, 0, exitDistance(s, ox, oy, oz, dx, dy, dz, contact, t), limit, cutoutTest);
        }
    }

    /**
     * Adds all hits of a shadow ray, which ends at distance 1, on mesh {@code s}. Neither end is on the mesh.
     *
     * @param buffer light buffer of the mesh and the ray's end
     */
    public void addHits(int s, double ox, double oy, double oz, double dx, double dy, double dz, LightBuffer buffer, MeshRayQuery probe,
            ShadowRayHits hits) {
        double[] m = data;
        int i = dataStart[s];
        assert meshes != null;
        probe.collectHits(buffer, meshes[s], m[i] * ox + m[i + 1] * oy + m[i + 2] * oz + m[i + 3],
                m[i + 4] * ox + m[i + 5] * oy + m[i + 6] * oz + m[i + 7], m[i + 8] * ox + m[i + 9] * oy + m[i + 10] * oz + m[i + 11],
                m[i] * dx + m[i + 1] * dy + m[i + 2] * dz, m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz,
                m[i + 8] * dx + m[i + 9] * dy + m[i + 10] * dz);
        if (probe.hitCount() > 0) {
            addHits(s, probe, 1, cutout(s) == null ? null : cutoutTest(s, ox, oy, oz, dx, dy, dz), hits);
        }
    }

    private static void addHits(int s, MeshRayQuery probe, double limit, @Nullable CutoutTest cutoutTest, ShadowRayHits hits) {
        for (int i = 0; i < probe.hitCount(); i++) {
            hits.add(s, probe.hitTriangle(i), probe.hitDistance(i), limit, cutoutTest);
        }
    }

    /** Adds the hits on a solid without cutouts for a shadow ray with no contact whose first hit is at {@code t}. */
    public void addHits(int s, double ox, double oy, double oz, double dx, double dy, double dz, double t, double limit,
            ShadowRayHits hits) {
        hits.add(s, 0, t, limit, null);
        hits.add(s, 0, exitDistance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.NONE, t), limit, null);
    }
}
