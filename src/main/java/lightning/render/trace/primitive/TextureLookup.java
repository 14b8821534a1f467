package lightning.render.trace.primitive;

import java.util.Arrays;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.asset.TextureMap;
import org.jspecify.annotations.Nullable;

/**
 * Lookup of the factor for the diffuse color at a hit: texture color times interpolated vertex color. Holds scratch memory: use
 * one per thread.
 *
 * <p>Texture coordinates are multiplied by the repeat counts. The lookup is bilinear and the image repeats endlessly; v points
 * up from the image's bottom row.
 */
public final class TextureLookup {
    private final BilinearLookup lookup = new BilinearLookup();
    private final TrianglePoint facet = new TrianglePoint();
    private final double[] uv = new double[2];

    /**
     * Writes the linear RGB, 0…1, at a local point of primitive {@code s} to {@code rgb[0…2]}.
     *
     * @param part part that was hit
     * @param map texture of its material; null if it has none
     */
    public void lookUp(PrimitiveTable primitives, int s, int part, @Nullable TextureMap map, double x, double y, double z, float[] rgb) {
        MeshSolid mesh = setPoint(primitives, s, part, x, y, z);
        if (map == null) {
            Arrays.fill(rgb, 1);
        } else {
            read(primitives, s, mesh, map, x, y, z, rgb);
        }
        if (primitives.hasVertexColors(s)) {
            for (int c = 0; c < 3; c++) {
                rgb[c] *= (float) facet.color(c);
            }
        }
    }

    /** Writes the color of an image alone at texture coordinates to {@code rgb[0…2]}. */
    public void lookUpAt(TextureMap map, double u, double v, float[] rgb) {
        lookup.setCoordinates(map, u, v);
        lookup.readColor(rgb);
    }

    /** Writes the color of an image alone, as {@link #lookUp}. */
    public void lookUpMap(PrimitiveTable primitives, int s, int part, TextureMap map, double x, double y, double z, float[] rgb) {
        read(primitives, s, setPoint(primitives, s, part, x, y, z), map, x, y, z, rgb);
    }

    private @Nullable MeshSolid setPoint(PrimitiveTable primitives, int s, int part, double x, double y, double z) {
        MeshSolid mesh = primitives.mesh(s);
        if (mesh != null) {
            facet.setPoint(mesh.mesh(), part, x, y, z);
        }
        return mesh;
    }

    /** Writes the texture coordinates, horizontal and upward, at a local point of primitive {@code s} to {@code to[0]} and {@code to[1]}. */
    public void writeCoordinates(PrimitiveTable primitives, int s, int part, double x, double y, double z, double[] to) {
        coordinates(primitives, s, setPoint(primitives, s, part, x, y, z), x, y, z);
        to[0] = uv[0];
        to[1] = uv[1];
    }

    private void read(PrimitiveTable primitives, int s, @Nullable MeshSolid mesh, TextureMap map, double x, double y, double z,
            float[] rgb) {
        coordinates(primitives, s, mesh, x, y, z);
        lookup.setCoordinates(map, uv[0], uv[1]);
        lookup.readColor(rgb);
    }

    private void coordinates(PrimitiveTable primitives, int s, @Nullable MeshSolid mesh, double x, double y, double z) {
        if (mesh == null) {
            primitives.kind(s).geometry().textureCoordinates(primitives.data, primitives.dataStart[s], x, y, z, uv);
        } else {
            uv[0] = facet.textureCoordinate(0);
            uv[1] = facet.textureCoordinate(1);
        }
    }
}
