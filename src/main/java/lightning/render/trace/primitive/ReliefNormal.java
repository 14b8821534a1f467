package lightning.render.trace.primitive;

import lightning.render.trace.mesh.Facet;
import lightning.render.trace.mesh.MeshSolid;
import lightning.scene.Relief;

/**
 * How a normal is bent by a material's relief, in the frame that the texture coordinates u, v make of a surface. Reused for one after the
 * other.
 *
 * <p><b>The frame</b> are the gradients of u and v along the surface, ∇u and ∇v: how fast they grow, and where to. They are gradients in
 * the primitive's own space, brought to the scene by the transpose of the map back, as normals are, less what is along the normal N, which
 * points outwards. So they need no tangents, hold under any placement, and where u and v are not at a right angle.
 *
 * <p><b>Heights</b> h tilt N to N − ∇h, ∇h = h′u·∇u + h′v·∇v (Blinn 1978, Simulation of Wrinkled Surfaces, in the form of Mikkelsen 2010,
 * Bump Mapping Unparametrized Surfaces on the GPU): the normal of the surface that lies h above this one, but for its curvature. <b>A
 * picture's normal</b> (x, y, z) = 2·rgb − 1 is x·s·T + y·s·B + z·N as in glTF 2.0, s the strength: B is the unit vector along ∇v, and T
 * that at a right angle to B and N on the side where u grows; on a mesh with tangents they are those of the {@link TangentFrame}. With both it is x·s·T + y·s·B + z·(N − ∇h).
 *
 * <p>A normal that nothing tilts keeps its bits, and so does one where u and v have no gradient: at the pole of a sphere, at an apex, on a
 * mesh without texture coordinates.
 */
final class ReliefNormal {
    private final PictureCell cell = new PictureCell();
    private final double[] uv = new double[2];
    /** Of u, then of v. */
    private final double[] own = new double[6];
    private final double[] rise = new double[6];
    private final float[] rgb = new float[3];
    private final TangentFrame frame = new TangentFrame();

    /**
     * Tilts a normal.
     *
     * @param facet  the triangle and the point; of no use where the primitive is no mesh
     * @param x      the point in own space, and so {@code y}, {@code z}
     * @param side   1 where the normal that is given leads out of the surface, −1 where it leads into it
     * @param normal of length 1
     * @return whether anything tilts it
     */
    boolean at(PrimitiveTable primitives, int s, Relief relief, Facet facet, double x, double y, double z, double side,
            ShadingNormal normal) {
        coordinates(primitives, s, facet, x, y, z);
        double nx = side * normal.x;
        double ny = side * normal.y;
        double nz = side * normal.z;
        toScene(primitives.data, primitives.at[s], 0, nx, ny, nz);
        toScene(primitives.data, primitives.at[s], 3, nx, ny, nz);
        double tx = 0;
        double ty = 0;
        double tz = 1;
        double hu = 0;
        double hv = 0;
        if (relief.bumps()) {
            cell.at(relief.bump().get(), uv[0], uv[1]);
            hu = relief.height() * relief.bump().get().repeatU() * cell.slopeAcross();
            hv = relief.height() * relief.bump().get().repeatV() * cell.slopeUpwards();
        }
        if (relief.leans()) {
            cell.at(relief.normals().get(), uv[0], uv[1]);
            cell.color(rgb);
            tx = sign(relief.normals().get().repeatU()) * relief.strength() * (2.0 * rgb[0] - 1);
            ty = sign(relief.normals().get().repeatV()) * relief.strength() * (2.0 * rgb[1] - 1);
            tz = 2.0 * rgb[2] - 1;
        }
        if (hu == 0 && hv == 0 && tx == 0 && ty == 0 && tz > 0) {
            return false;
        }
        if (relief.leans() && primitives.mesh(s) != null && facet.hasTangents()
                && frame.at(facet, primitives.data, primitives.at[s], nx, ny, nz)) {
            return normal.take(side * (tz * (nx - hu * rise[0] - hv * rise[3]) + tx * frame.tx + ty * frame.bx),
                    side * (tz * (ny - hu * rise[1] - hv * rise[4]) + tx * frame.ty + ty * frame.by),
                    side * (tz * (nz - hu * rise[2] - hv * rise[5]) + tx * frame.tz + ty * frame.bz));
        }
        double upX = rise[3];
        double upY = rise[4];
        double upZ = rise[5];
        // ∇v × N leads where u grows, or the other way: along it, u grows by this.
        double acrossX = upY * nz - upZ * ny;
        double acrossY = upZ * nx - upX * nz;
        double acrossZ = upX * ny - upY * nx;
        double turn = sign(acrossX * rise[0] + acrossY * rise[1] + acrossZ * rise[2]);
        double unit = 1 / Math.sqrt(upX * upX + upY * upY + upZ * upZ);
        if (!(unit < Double.POSITIVE_INFINITY)) {
            return false;
        }
        double bu = -tz * hu;
        double bv = -tz * hv + ty * unit;
        double bt = tx * unit * turn;
        return normal.take(side * (tz * nx + bu * rise[0] + bv * upX + bt * acrossX),
                side * (tz * ny + bu * rise[1] + bv * upY + bt * acrossY),
                side * (tz * nz + bu * rise[2] + bv * upZ + bt * acrossZ));
    }

    private void coordinates(PrimitiveTable primitives, int s, Facet facet, double x, double y, double z) {
        MeshSolid mesh = primitives.mesh(s);
        if (mesh == null) {
            primitives.kind(s).form().coordinates(primitives.data, primitives.at[s], x, y, z, uv);
            primitives.kind(s).form().gradients(primitives.data, primitives.at[s], x, y, z, own);
        } else {
            uv[0] = facet.coordinate(0);
            uv[1] = facet.coordinate(1);
            facet.gradient(0, own, 0);
            facet.gradient(1, own, 3);
        }
    }

    /** Brings one of the gradients into the scene, along the surface. */
    private void toScene(double[] m, int i, int g, double nx, double ny, double nz) {
        double x = m[i] * own[g] + m[i + 4] * own[g + 1] + m[i + 8] * own[g + 2];
        double y = m[i + 1] * own[g] + m[i + 5] * own[g + 1] + m[i + 9] * own[g + 2];
        double z = m[i + 2] * own[g] + m[i + 6] * own[g + 1] + m[i + 10] * own[g + 2];
        double along = x * nx + y * ny + z * nz;
        rise[g] = x - along * nx;
        rise[g + 1] = y - along * ny;
        rise[g + 2] = z - along * nz;
    }

    private static double sign(double v) {
        return v < 0 ? -1 : 1;
    }
}
