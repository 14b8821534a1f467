package lightning.render.trace.primitive;

import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.BumpMapping;

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
final class BumpNormal {
    private final BilinearLookup lookup = new BilinearLookup();
    private final double[] uv = new double[2];
    /** Of u, then of v. */
    private final double[] localGradients = new double[6];
    private final double[] sceneGradients = new double[6];
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
    boolean tilt(PrimitiveTable primitives, int s, BumpMapping bumpMapping, TrianglePoint facet, double x, double y, double z, double side,
            ShadingNormal normal) {
        readCoordinates(primitives, s, facet, x, y, z);
        double nx = side * normal.x;
        double ny = side * normal.y;
        double nz = side * normal.z;
        transformToScene(primitives.data, primitives.dataStart[s], 0, nx, ny, nz);
        transformToScene(primitives.data, primitives.dataStart[s], 3, nx, ny, nz);
        double tx = 0;
        double ty = 0;
        double tz = 1;
        double heightSlopeU = 0;
        double heightSlopeV = 0;
        if (bumpMapping.hasBumpMap()) {
            lookup.setCoordinates(bumpMapping.bump().get(), uv[0], uv[1]);
            heightSlopeU = bumpMapping.height() * bumpMapping.bump().get().repeatU() * lookup.slopeU();
            heightSlopeV = bumpMapping.height() * bumpMapping.bump().get().repeatV() * lookup.slopeV();
        }
        if (bumpMapping.hasNormalMap()) {
            lookup.setCoordinates(bumpMapping.normalMap().get(), uv[0], uv[1]);
            lookup.readColor(rgb);
            tx = sign(bumpMapping.normalMap().get().repeatU()) * bumpMapping.strength() * (2.0 * rgb[0] - 1);
            ty = sign(bumpMapping.normalMap().get().repeatV()) * bumpMapping.strength() * (2.0 * rgb[1] - 1);
            tz = 2.0 * rgb[2] - 1;
        }
        if (heightSlopeU == 0 && heightSlopeV == 0 && tx == 0 && ty == 0 && tz > 0) {
            return false;
        }
        if (bumpMapping.hasNormalMap() && primitives.mesh(s) != null && facet.hasTangents()
                && frame.compute(facet, primitives.data, primitives.dataStart[s], nx, ny, nz)) {
            return normal.setNormalized(side
                    * (tz * (nx - heightSlopeU * sceneGradients[0] - heightSlopeV * sceneGradients[3]) + tx * frame.tx + ty * frame.bx),
                    side * (tz * (ny - heightSlopeU * sceneGradients[1] - heightSlopeV * sceneGradients[4]) + tx * frame.ty
                            + ty * frame.by),
                    side * (tz * (nz - heightSlopeU * sceneGradients[2] - heightSlopeV * sceneGradients[5]) + tx * frame.tz
                            + ty * frame.bz));
        }
        double upX = sceneGradients[3];
        double upY = sceneGradients[4];
        double upZ = sceneGradients[5];
        // ∇v × N leads where u grows, or the other way: along it, u grows by this.
        double acrossX = upY * nz - upZ * ny;
        double acrossY = upZ * nx - upX * nz;
        double acrossZ = upX * ny - upY * nx;
        double sideSign = sign(acrossX * sceneGradients[0] + acrossY * sceneGradients[1] + acrossZ * sceneGradients[2]);
        double unit = 1 / Math.sqrt(upX * upX + upY * upY + upZ * upZ);
        if (!(unit < Double.POSITIVE_INFINITY)) {
            return false;
        }
        double bu = -tz * heightSlopeU;
        double bv = -tz * heightSlopeV + ty * unit;
        double bt = tx * unit * sideSign;
        return normal.setNormalized(side * (tz * nx + bu * sceneGradients[0] + bv * upX + bt * acrossX),
                side * (tz * ny + bu * sceneGradients[1] + bv * upY + bt * acrossY),
                side * (tz * nz + bu * sceneGradients[2] + bv * upZ + bt * acrossZ));
    }

    private void readCoordinates(PrimitiveTable primitives, int s, TrianglePoint facet, double x, double y, double z) {
        MeshSolid mesh = primitives.mesh(s);
        if (mesh == null) {
            primitives.kind(s).geometry().textureCoordinates(primitives.data, primitives.dataStart[s], x, y, z, uv);
            primitives.kind(s).geometry().textureGradients(primitives.data, primitives.dataStart[s], x, y, z, localGradients);
        } else {
            uv[0] = facet.textureCoordinate(0);
            uv[1] = facet.textureCoordinate(1);
            facet.textureGradient(0, localGradients, 0);
            facet.textureGradient(1, localGradients, 3);
        }
    }

    /** Brings one of the gradients into the scene, along the surface. */
    private void transformToScene(double[] m, int i, int g, double nx, double ny, double nz) {
        double x = m[i] * localGradients[g] + m[i + 4] * localGradients[g + 1] + m[i + 8] * localGradients[g + 2];
        double y = m[i + 1] * localGradients[g] + m[i + 5] * localGradients[g + 1] + m[i + 9] * localGradients[g + 2];
        double z = m[i + 2] * localGradients[g] + m[i + 6] * localGradients[g + 1] + m[i + 10] * localGradients[g + 2];
        double along = x * nx + y * ny + z * nz;
        sceneGradients[g] = x - along * nx;
        sceneGradients[g + 1] = y - along * ny;
        sceneGradients[g + 2] = z - along * nz;
    }

    private static double sign(double v) {
        return v < 0 ? -1 : 1;
    }
}
