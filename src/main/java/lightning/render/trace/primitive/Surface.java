package lightning.render.trace.primitive;

import lightning.base.math.Vec3;
import lightning.render.trace.mesh.Facet;
import lightning.render.trace.mesh.MeshSolid;
import lightning.scene.Relief;

/**
 * Where a ray meets a shape, in two forms: the point in the shape's own space, in double, and what
 * shading sees, rounded to float.
 *
 * <p>The stored point lies off the surface, on the side that the ray came from, by a bound on its own
 * error along the normal: twice what rounding each coordinate to float can move it that way, Σ|nᵢ·pᵢ|·2⁻²⁴, and
 * the error of the hit in double, which grows with the coordinates of the shape and of the ray's origin. Rays
 * that leave from it need no further care. The normal has length 1 and faces the incoming ray. A mesh that has normals is shaded by
 * them, and the point is lifted first ({@link SmoothNormal}); one whose material has a relief by what that makes of the normal
 * ({@link ReliefNormal}).
 */
public final class Surface {
    /** The share of a point's coordinates, seen along the normal, by which it is moved: two float roundings. */
    public static final double OFFSET = 0x1p-23;
    /** The error of a hit in double, as a share of the coordinates of the ray's origin and of the shape. */
    public static final double ERROR = 0x1p-46;

    private final double[] outward = new double[3];
    private final Facet facet = new Facet();
    private final SmoothNormal smooth = new SmoothNormal();
    private final ReliefNormal tilted = new ReliefNormal();
    private final ShadingNormal shading = new ShadingNormal();
    public double ownX;
    public double ownY;
    public double ownZ;
    public float px;
    public float py;
    public float pz;
    /** The point on the other side of the surface, off it by the same bound, once {@link #behind} was called. */
    public float behindX;
    public float behindY;
    public float behindZ;
    public float nx;
    public float ny;
    public float nz;

    private double hitX;
    private double hitY;
    private double hitZ;
    private double unitX;
    private double unitY;
    private double unitZ;
    private double slack;
    private boolean inside;

    /** Computes the surface of a part of primitive {@code s} at distance {@code t} along the ray. */
    public void at(PrimitiveTable primitives, int s, int part, double ox, double oy, double oz, double dx, double dy, double dz, double t) {
        face(primitives, s, part, ox, oy, oz, dx, dy, dz, t);
        slack = (Math.abs(ox) + Math.abs(oy) + Math.abs(oz)) * ERROR + primitives.error[s];
        double x = hitX;
        double y = hitY;
        double z = hitZ;
        if (isRound(primitives, s)) {
            smooth.lift(facet, unitX, unitY, unitZ);
            x += smooth.liftX;
            y += smooth.liftY;
            z += smooth.liftZ;
        }
        double off = (Math.abs(x * unitX) + Math.abs(y * unitY) + Math.abs(z * unitZ)) * OFFSET + slack;
        px = (float) (x + unitX * off);
        py = (float) (y + unitY * off);
        pz = (float) (z + unitZ * off);
    }

    /** The same without a point: own coordinates, normal and side alone. */
    public void face(PrimitiveTable primitives, int s, int part, double ox, double oy, double oz, double dx, double dy, double dz,
            double t) {
        double x = ox + t * dx;
        double y = oy + t * dy;
        double z = oz + t * dz;
        double[] m = primitives.data;
        int i = primitives.at[s];
        ownX = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        ownY = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        ownZ = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        MeshSolid mesh = primitives.mesh(s);
        if (mesh == null) {
            primitives.kind(s).form().outward(m, i, ownX, ownY, ownZ, outward);
        } else {
            facet.at(mesh.mesh(), part, ownX, ownY, ownZ);
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
        unitX = bx;
        unitY = by;
        unitZ = bz;
        inside = facing < 0;
        boolean round = mesh != null && facet.isSmooth();
        if (round) {
            smooth.at(facet, m, i, bx, by, bz, shading);
        }
        Relief relief = primitives.relief(s);
        if (round || relief != null) {
            shade(primitives, s, relief, round, dx, dy, dz);
        }
    }

    /** Finds the point behind the surface that was computed last, where a ray that passes goes on. No mesh's normals lift it. */
    public void behind() {
        double off = (Math.abs(hitX * unitX) + Math.abs(hitY * unitY) + Math.abs(hitZ * unitZ)) * OFFSET + slack;
        behindX = (float) (hitX - unitX * off);
        behindY = (float) (hitY - unitY * off);
        behindZ = (float) (hitZ - unitZ * off);
    }

    /** Whether the ray came to the surface that was computed last from inside: along its outward normal. */
    public boolean isInside() {
        return inside;
    }

    /** The normal of the surface that was computed last, whatever shades it: of length 1, on the side that is seen. */
    public Vec3 own() {
        return new Vec3(unitX, unitY, unitZ);
    }

    /**
     * By what the primitive that was computed last would be shaded if nothing bent it towards the viewer: computed once more.
     *
     * @param round  by the normals of a mesh's vertices, which there are
     * @param relief null for none
     * @return of length 1, on the side that is seen; null where the relief tilts nothing
     */
    public Vec3 unbent(PrimitiveTable primitives, int s, boolean round, Relief relief) {
        if (round) {
            smooth.at(facet, primitives.data, primitives.at[s], unitX, unitY, unitZ, shading);
        }
        boolean tilts = tilt(primitives, s, relief, round);
        return relief != null && !tilts ? null : new Vec3(shading.x, shading.y, shading.z);
    }

    /** How far the vertices' normals lifted the point that was computed last, scene units. */
    public double lift() {
        return Math.sqrt(smooth.liftX * smooth.liftX + smooth.liftY * smooth.liftY + smooth.liftZ * smooth.liftZ);
    }

    /** Whether the primitive that was computed last is a mesh with normals at its vertices. */
    public boolean isRound(PrimitiveTable primitives, int s) {
        return primitives.mesh(s) != null && facet.isSmooth();
    }

    /** Shades by another normal than the surface's own, by the relief and the mesh's normals, as far as there are any. */
    private void shade(PrimitiveTable primitives, int s, Relief relief, boolean round, double dx, double dy, double dz) {
        if (tilt(primitives, s, relief, round) || round) {
            shading.bend(unitX, unitY, unitZ, dx, dy, dz);
            nx = (float) shading.x;
            ny = (float) shading.y;
            nz = (float) shading.z;
        }
    }

    /** Begins with the surface's own normal, unless a mesh's is there already; whether the relief tilts it. */
    private boolean tilt(PrimitiveTable primitives, int s, Relief relief, boolean round) {
        if (!round) {
            shading.x = unitX;
            shading.y = unitY;
            shading.z = unitZ;
        }
        return relief != null
                && tilted.at(primitives, s, relief, facet, ownX, ownY, ownZ, round ? smooth.side : inside ? -1 : 1, shading);
    }
}
