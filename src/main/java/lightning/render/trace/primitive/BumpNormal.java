package lightning.render.trace.primitive;

import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.material.BumpMapping;

/**
 * Normal perturbed by a material's bump or normal map, in the frame of the texture coordinates u, v. Reused.
 *
 * <p><b>Frame:</b> the gradients of u and v along the surface, ∇u and ∇v. They are gradients in local space, transformed to the
 * scene by the transpose of the inverse, as normals are, and projected perpendicular to the outward normal N. So they need no
 * tangents and hold for any transform, even where u and v are not perpendicular.
 *
 * <p><b>Bump map:</b> heights h tilt N to N − ∇h, ∇h = h′u·∇u + h′v·∇v (Blinn 1978, Simulation of Wrinkled Surfaces, in the
 * form of Mikkelsen 2010, Bump Mapping Unparametrized Surfaces on the GPU). This is the normal of the surface displaced by h,
 * without its curvature.
 *
 * <p><b>Normal map:</b> (x, y, z) = 2·rgb − 1 becomes x·s·T + y·s·B + z·N as in glTF 2.0, with strength s. B is the unit vector
 * along ∇v; T is perpendicular to B and N on the side where u grows. On a mesh with tangents they are those of the
 * {@link TangentFrame}. With both maps it is x·s·T + y·s·B + z·(N − ∇h).
 *
 * <p>An unperturbed normal keeps its bits, and so does one where u and v have no gradient: at the pole of a sphere, at an apex,
 * on a mesh without texture coordinates.
 */
final class BumpNormal {
    private final BilinearLookup lookup = new BilinearLookup();
    private final double[] uv = new double[2];
    /** Gradient of u, then of v. */
    private final double[] localGradients = new double[6];
    private final double[] sceneGradients = new double[6];
    private final float[] rgb = new float[3];
    private final TangentFrame frame = new TangentFrame();

    /**
     * Tilts a normal.
     *
     * @param facet triangle and point; unused if the primitive is not a mesh
     * @param x point in local space; also {@code y}, {@code z}
     * @param side 1 if the given normal points out of the surface, −1 if it points into it
     * @param normal normal of length 1
     * @return true if the normal is tilted
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
            double slopeU = lookup.slopeU();
            double slopeV = lookup.slopeV();
            heightSlopeU = bumpMapping.height() * bumpMapping.bump().get().repeatU() * lookup.alongU(slopeU, slopeV);
            heightSlopeV = bumpMapping.height() * bumpMapping.bump().get().repeatV() * lookup.alongV(slopeU, slopeV);
        }
        if (bumpMapping.hasNormalMap()) {
            lookup.setCoordinates(bumpMapping.normalMap().get(), uv[0], uv[1]);
            lookup.readColor(rgb);
            double right = 2.0 * rgb[0] - 1;
            double up = 2.0 * rgb[1] - 1;
            tx = sign(bumpMapping.normalMap().get().repeatU()) * bumpMapping.strength() * lookup.alongU(right, up);
            ty = sign(bumpMapping.normalMap().get().repeatV()) * bumpMapping.strength() * lookup.alongV(right, up);
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
        // ∇v × N points where u grows, or opposite; u grows by this along it.
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

    /** Transforms one of the gradients to the scene and projects it onto the surface. */
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
