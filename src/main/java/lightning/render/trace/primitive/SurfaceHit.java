package lightning.render.trace.primitive;

import lightning.base.math.Vec3;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.BumpMapping;

/**
 * Where a ray meets a shape, in two forms: the point in the shape's own space, in double, and what
 * shading sees, rounded to float.
 *
 * <p>The stored point lies off the surface, on the side that the ray came from, by a bound on its own
 * error along the normal: twice what rounding each coordinate to float can move it that way, Σ|nᵢ·pᵢ|·2⁻²⁴, and
 * the error of the hit in double, which grows with the coordinates of the shape and of the ray's origin. Rays
 * that leave from it need no further care. The normal has length 1 and faces the incoming ray. A mesh that has normals is shaded by
 * them, and the point is lifted first ({@link SmoothNormal}); one whose material has a relief by what that makes of the normal
 * ({@link BumpNormal}).
 */
public final class SurfaceHit {
    /** The share of a point's coordinates, seen along the normal, by which it is moved: two float roundings. */
    public static final double OFFSET = 0x1p-23;
    /** The error of a hit in double, as a share of the coordinates of the ray's origin and of the shape. */
    public static final double HIT_ERROR = 0x1p-46;

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
    /** The point on the other side of the surface, off it by the same bound, once {@link #computeBackPoint} was called. */
    public float backX;
    public float backY;
    public float backZ;
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

    /** Computes the surface of a part of primitive {@code s} at distance {@code t} along the ray. */
    public void compute(PrimitiveTable primitives, int s, int part, double ox, double oy, double oz, double dx, double dy, double dz,
            double t) {
        computeNormal(primitives, s, part, ox, oy, oz, dx, dy, dz, t);
        hitError = (Math.abs(ox) + Math.abs(oy) + Math.abs(oz)) * HIT_ERROR + primitives.hitError[s];
        double x = hitX;
        double y = hitY;
        double z = hitZ;
        if (isSmooth(primitives, s)) {
            smoothNormal.computeLift(facet, geometricX, geometricY, geometricZ);
            x += smoothNormal.liftX;
            y += smoothNormal.liftY;
            z += smoothNormal.liftZ;
        }
        double offset = (Math.abs(x * geometricX) + Math.abs(y * geometricY) + Math.abs(z * geometricZ)) * OFFSET + hitError;
        px = (float) (x + geometricX * offset);
        py = (float) (y + geometricY * offset);
        pz = (float) (z + geometricZ * offset);
    }

    /** The same without a point: own coordinates, normal and side alone. */
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
        // Normals go by the transpose of the inverse map.
        double bx = m[i] * ax + m[i + 4] * ay + m[i + 8] * az;
        double by = m[i + 1] * ax + m[i + 5] * ay + m[i + 9] * az;
        double bz = m[i + 2] * ax + m[i + 6] * ay + m[i + 10] * az;
        double square = bx * bx + by * by + bz * bz;
        if (!(square > 0)) {
            // A cone's apex, or a shape smaller than the spacing of doubles where it stands: it faces whoever sees it.
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
        boolean smoothMesh = mesh != null && facet.isSmooth();
        if (smoothMesh) {
            smoothNormal.compute(facet, m, i, bx, by, bz, shadingNormal);
        }
        BumpMapping bumpMapping = primitives.bumpMapping(s);
        if (smoothMesh || bumpMapping != null) {
            applyShadingNormal(primitives, s, bumpMapping, smoothMesh, dx, dy, dz);
        }
    }

    /** Finds the point behind the surface that was computed last, where a ray that passes goes on. No mesh's normals lift it. */
    public void computeBackPoint() {
        double offset = (Math.abs(hitX * geometricX) + Math.abs(hitY * geometricY) + Math.abs(hitZ * geometricZ)) * OFFSET + hitError;
        backX = (float) (hitX - geometricX * offset);
        backY = (float) (hitY - geometricY * offset);
        backZ = (float) (hitZ - geometricZ * offset);
    }

    /** Whether the ray came to the surface that was computed last from inside: along its outward normal. */
    public boolean isInside() {
        return inside;
    }

    /** The normal of the surface that was computed last, whatever shades it: of length 1, on the side that is seen. */
    public Vec3 geometricNormal() {
        return new Vec3(geometricX, geometricY, geometricZ);
    }

    /**
     * By what the primitive that was computed last would be shaded if nothing bent it towards the viewer: computed once more.
     *
     * @param smoothMesh  by the normals of a mesh's vertices, which there are
     * @param bumpMapping null for none
     * @return of length 1, on the side that is seen; null where the relief tilts nothing
     */
    public Vec3 unbentNormal(PrimitiveTable primitives, int s, boolean smoothMesh, BumpMapping bumpMapping) {
        if (smoothMesh) {
            smoothNormal.compute(facet, primitives.data, primitives.dataStart[s], geometricX, geometricY, geometricZ, shadingNormal);
        }
        boolean tilts = tiltNormal(primitives, s, bumpMapping, smoothMesh);
        return bumpMapping != null && !tilts ? null : new Vec3(shadingNormal.x, shadingNormal.y, shadingNormal.z);
    }

    /** How far the vertices' normals lifted the point that was computed last, scene units. */
    public double liftDistance() {
        return Math.sqrt(smoothNormal.liftX * smoothNormal.liftX + smoothNormal.liftY * smoothNormal.liftY
                + smoothNormal.liftZ * smoothNormal.liftZ);
    }

    /** Whether the primitive that was computed last is a mesh with normals at its vertices. */
    public boolean isSmooth(PrimitiveTable primitives, int s) {
        return primitives.mesh(s) != null && facet.isSmooth();
    }

    /** Shades by another normal than the surface's own, by the relief and the mesh's normals, as far as there are any. */
    private void applyShadingNormal(PrimitiveTable primitives, int s, BumpMapping bumpMapping, boolean smoothMesh, double dx, double dy,
            double dz) {
        if (tiltNormal(primitives, s, bumpMapping, smoothMesh) || smoothMesh) {
            shadingNormal.bend(geometricX, geometricY, geometricZ, dx, dy, dz);
            nx = (float) shadingNormal.x;
            ny = (float) shadingNormal.y;
            nz = (float) shadingNormal.z;
        }
    }

    /** Begins with the surface's own normal, unless a mesh's is there already; whether the relief tilts it. */
    private boolean tiltNormal(PrimitiveTable primitives, int s, BumpMapping bumpMapping, boolean smoothMesh) {
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
