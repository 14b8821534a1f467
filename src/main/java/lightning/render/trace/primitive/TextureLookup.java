package lightning.render.trace.primitive;

import java.util.Arrays;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.TextureMap;

/**
 * The factor on the diffuse color where a primitive is met: the color of its texture, times that between the vertices of a mesh. Holds scratch memory: one for each thread.
 *
 * <p>Texture coordinates are multiplied by the repeat counts. The four nearest pixels are mixed bilinearly and the
 * picture repeats endlessly; v runs upwards, from the picture's bottom row.
 */
public final class TextureLookup {
    private final BilinearLookup lookup = new BilinearLookup();
    private final TrianglePoint facet = new TrianglePoint();
    private final double[] uv = new double[2];

    /**
     * Writes the linear RGB, 0…1, at an own point of primitive {@code s} to {@code rgb[0…2]}.
     *
     * @param part the part that was hit
     * @param map  the texture of its material; null where it has none
     */
    public void lookUp(PrimitiveTable primitives, int s, int part, TextureMap map, double x, double y, double z, float[] rgb) {
        MeshSolid mesh = primitives.mesh(s);
        if (mesh != null) {
            facet.setPoint(mesh.mesh(), part, x, y, z);
        }
        if (map == null) {
            Arrays.fill(rgb, 1);
        } else {
            coordinates(primitives, s, mesh, x, y, z);
            lookup.setCoordinates(map, uv[0], uv[1]);
            lookup.readColor(rgb);
        }
        if (primitives.hasVertexColors(s)) {
            for (int c = 0; c < 3; c++) {
                rgb[c] *= (float) facet.color(c);
            }
        }
    }

    private void coordinates(PrimitiveTable primitives, int s, MeshSolid mesh, double x, double y, double z) {
        if (mesh == null) {
            primitives.kind(s).geometry().textureCoordinates(primitives.data, primitives.dataStart[s], x, y, z, uv);
        } else {
            uv[0] = facet.textureCoordinate(0);
            uv[1] = facet.textureCoordinate(1);
        }
    }
}
