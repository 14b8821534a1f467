package lightning.render.trace.primitive;

import lightning.base.math.Vec3;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.material.BumpMapping;
import org.jspecify.annotations.Nullable;

/**
 * Surface data at a ray's hit: the point in local space, in double, and the values for shading, rounded to float.
 *
 * <p>The stored point is offset from the surface along the normal, on the side that the ray came from, by a bound on its own
 * error. The bound is twice the effect of rounding each coordinate to float, Σ|nᵢ·pᵢ|·2⁻²⁴, plus the error of the hit in
 * double, which grows with the coordinates of the shape and of the ray's origin. So rays that start at it need no epsilon. The
 * normal has length 1 and faces the incoming ray. Meshes with vertex normals are shaded by these, from a lifted point
 * ({@link SmoothNormal}). Materials with bump or normal maps use the perturbed normal ({@link BumpNormal}).
 */
public final class SurfaceHit {
    /** Offset relative to a point's coordinates, weighted by the normal: two float roundings. */
    public static final double OFFSET = 0x1p-23;
    /** Error of a hit in double, relative to the coordinates of the ray's origin and of the shape. */
    public static final double HIT_ERROR = 0x1p-46;

    /** Sine of about half a degree: the minimum elevation of a reflected ray over a surface with a shading normal. */
    public static final double MIN_SINE = 0x1p-7;

    private final double[] outward = new double[3];
    private final TrianglePoint facet = new TrianglePoint();
    private final SmoothNormal smoothNormal = new SmoothNormal();
    private final BumpNormal bumpNormal = new BumpNormal();
    private final ShadingNormal shadingNormal = new ShadingNormal();
    public double localX;
    public double localY;
    public double localZ;
    public float px;
    public float py;
    public float pz;
    /** Point on the other side of the surface, offset by the same bound; valid after {@link #computeBackPoint}. */
    public float backX;
    public float backY;
    public float backZ;
    /** Point on the facet, offset by the same bound and not lifted; valid after {@link #computeFacetPoint}. */
    public float facetX;
    public float facetY;
    public float facetZ;
    /** Whether vertex normals lift points. */
    public boolean lifts = true;
    public float nx;
    public float ny;
    public float nz;

    private double hitX;
    private double hitY;
    private double hitZ;
    private double geometricX;
    private double geometricY;
    private double geometricZ;
    private double hitError;
    private boolean inside;
    /** Whether the shading normal is not the geometric one. */
    private boolean hasShadingNormal;

    /** Computes the surface of a part of primitive {@code s} at distance {@code t} along the ray. */
    public void compute(PrimitiveTable primitives, int s, int part, double ox, double oy, double oz, double dx, double dy, double dz,
            double t) {
        computeNormal(primitives, s, part, ox, oy, oz, dx, dy, dz, t);
        hitError = (Math.abs(ox) + Math.abs(oy) + Math.abs(oz)) * HIT_ERROR + primitives.hitError[s];
        double x = hitX;
        double y = hitY;
        double z = hitZ;
        MeshSolid mesh = primitives.mesh(s);
        if (lifts && mesh != null && facet.isSmooth()) {
            smoothNormal.computeLift(facet, mesh.facetNormals(), geometricX, geometricY, geometricZ);
            x += smoothNormal.liftX;
            y += smoothNormal.liftY;
            z += smoothNormal.liftZ;
        }
        double offset = (Math.abs(x * geometricX) + Math.abs(y * geometricY) + Math.abs(z * geometricZ)) * OFFSET + hitError;
        px = (float) (x + geometricX * offset);
        py = (float) (y + geometricY * offset);
        pz = (float) (z + geometricZ * offset);
    }

    /** Computes only local coordinates, normal and side, without the point. */
    public void computeNormal(PrimitiveTable primitives, int s, int part, double ox, double oy, double oz, double dx, double dy, double dz,
            double t) {
        double x = ox + t * dx;
        double y = oy + t * dy;
        double z = oz + t * dz;
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        localX = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        localY = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        localZ = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        MeshSolid mesh = primitives.mesh(s);
        if (mesh == null) {
            primitives.kind(s).geometry().outwardNormal(m, i, localX, localY, localZ, outward);
        } else {
            facet.setPoint(mesh.mesh(), part, localX, localY, localZ);
        }
        double ax = mesh == null ? outward[0] : facet.nx;
        double ay = mesh == null ? outward[1] : facet.ny;
        double az = mesh == null ? outward[2] : facet.nz;
        // Normals are transformed by the transpose of the inverse.
        double bx = m[i] * ax + m[i + 4] * ay + m[i + 8] * az;
        double by = m[i + 1] * ax + m[i + 5] * ay + m[i + 9] * az;
        double bz = m[i + 2] * ax + m[i + 6] * ay + m[i + 10] * az;
        double square = bx * bx + by * by + bz * bz;
        if (!(square > 0)) {
            // At a cone's apex, or on a shape smaller than the spacing of doubles at its position, the normal faces the ray.
            bx = -dx;
            by = -dy;
            bz = -dz;
            square = bx * bx + by * by + bz * bz;
        }
        double length = Math.sqrt(square);
        double facing = bx * dx + by * dy + bz * dz > 0 ? -length : length;
        double unit = 1 / facing;
        bx = bx * unit;
        by = by * unit;
        bz = bz * unit;
        nx = (float) bx;
        ny = (float) by;
        nz = (float) bz;
        hitX = x;
        hitY = y;
        hitZ = z;
        geometricX = bx;
        geometricY = by;
        geometricZ = bz;
        inside = facing < 0;
        hasShadingNormal = false;
        boolean smoothMesh = mesh != null && facet.isSmooth();
        if (smoothMesh) {
            smoothNormal.compute(facet, m, i, bx, by, bz, shadingNormal);
        }
        @Nullable
        BumpMapping bumpMapping = primitives.bumpMapping(s);
        if (smoothMesh || bumpMapping != null) {
            applyShadingNormal(primitives, s, bumpMapping, smoothMesh, dx, dy, dz);
        }
    }

    /**
     * Replaces the normal of the latest surface by that of its coat, which bumps of the surface do not change.
     *
     * @param map normal map of the coat
     * @param dx  component x of the unit direction of the ray, as {@code dy} and {@code dz}
     */
    public void computeCoatNormal(PrimitiveTable primitives, int s, BumpMapping map, double dx, double dy, double dz) {
        nx = (float) geometricX;
        ny = (float) geometricY;
        nz = (float) geometricZ;
        boolean isSmooth = isSmooth(primitives, s);
        if (isSmooth) {
            smoothNormal.compute(facet, primitives.data, primitives.dataStart[s], geometricX, geometricY, geometricZ, shadingNormal);
        }
        applyShadingNormal(primitives, s, map, isSmooth, dx, dy, dz);
    }

    /** Computes the point on the latest facet, at which rays start that gather light. Vertex normals do not lift it. */
    public void computeFacetPoint() {
        double offset = facetOffset();
        facetX = (float) (hitX + geometricX * offset);
        facetY = (float) (hitY + geometricY * offset);
        facetZ = (float) (hitZ + geometricZ * offset);
    }

    private double facetOffset() {
        return (Math.abs(hitX * geometricX) + Math.abs(hitY * geometricY) + Math.abs(hitZ * geometricZ)) * OFFSET + hitError;
    }

    /** Computes the point behind the latest surface, at which a refracted ray starts. Vertex normals do not lift it. */
    public void computeBackPoint() {
        double offset = facetOffset();
        backX = (float) (hitX - geometricX * offset);
        backY = (float) (hitY - geometricY * offset);
        backZ = (float) (hitZ - geometricZ * offset);
    }

    /** Returns whether the ray reached the latest surface from inside, along its outward normal. */
    public boolean isInside() {
        return inside;
    }

    /** Returns whether bump mapping or vertex normals shade the latest surface by another normal than the geometric one. */
    public boolean hasShadingNormal() {
        return hasShadingNormal;
    }

    /** Returns the geometric normal of the latest surface: of length 1, on the visible side. */
    public Vec3 geometricNormal() {
        return new Vec3(geometricX, geometricY, geometricZ);
    }

    /**
     * Recomputes the shading normal of the latest surface before it is bent toward the viewer.
     *
     * @param smoothMesh true to use vertex normals, which must exist
     * @param bumpMapping null for none
     * @return normal of length 1, on the visible side; null if the bump mapping does not tilt it
     */
    public @Nullable Vec3 unbentNormal(PrimitiveTable primitives, int s, boolean smoothMesh, @Nullable BumpMapping bumpMapping) {
        if (smoothMesh) {
            smoothNormal.compute(facet, primitives.data, primitives.dataStart[s], geometricX, geometricY, geometricZ, shadingNormal);
        }
        boolean tilts = tiltNormal(primitives, s, bumpMapping, smoothMesh);
        return bumpMapping != null && !tilts ? null : new Vec3(shadingNormal.x, shadingNormal.y, shadingNormal.z);
    }

    /** Returns the lift of the latest point by vertex normals, scene units. */
    public double liftDistance() {
        return Math.sqrt(smoothNormal.liftX * smoothNormal.liftX + smoothNormal.liftY * smoothNormal.liftY
                + smoothNormal.liftZ * smoothNormal.liftZ);
    }

    /** Returns whether the latest primitive is a mesh with vertex normals. */
    public boolean isSmooth(PrimitiveTable primitives, int s) {
        return primitives.mesh(s) != null && facet.isSmooth();
    }

    /** Replaces the geometric normal by the shading normal from bump mapping and vertex normals, if any. */
    private void applyShadingNormal(PrimitiveTable primitives, int s, @Nullable BumpMapping bumpMapping, boolean smoothMesh, double dx,
            double dy, double dz) {
        hasShadingNormal = tiltNormal(primitives, s, bumpMapping, smoothMesh) || smoothMesh;
        if (hasShadingNormal) {
            shadingNormal.bend(geometricX, geometricY, geometricZ, dx, dy, dz);
            nx = (float) shadingNormal.x;
            ny = (float) shadingNormal.y;
            nz = (float) shadingNormal.z;
        }
    }

    /** Applies bump mapping to the geometric normal, or to the smooth normal if one is set; returns true if it tilts it. */
    private boolean tiltNormal(PrimitiveTable primitives, int s, @Nullable BumpMapping bumpMapping, boolean smoothMesh) {
        if (!smoothMesh) {
            shadingNormal.x = geometricX;
            shadingNormal.y = geometricY;
            shadingNormal.z = geometricZ;
        }
        return bumpMapping != null
                && bumpNormal.tilt(primitives, s, bumpMapping, facet, localX, localY, localZ,
                        smoothMesh ? smoothNormal.side : inside ? -1 : 1, shadingNormal);
    }
}
