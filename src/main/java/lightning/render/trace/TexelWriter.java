package lightning.render.trace;

import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.TextureLookup;
import lightning.scene.TextureMap;

/** Writes the texels of rows whose surfaces were just computed. Holds scratch memory: use one per thread. */
final class TexelWriter {
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final float[] texel = new float[3];
    private final TextureLookup lookup = new TextureLookup();

    TexelWriter(Geometry geometry) {
        primitives = geometry.primitives();
        materials = geometry.materials();
    }

    /**
     * Writes texels from {@code row} on. The rows are the rays' hits in order; consecutive ones often have the same primitive.
     */
    void write(HitRows rows, int row, RayColumns rays) {
        int lastPrimitive = -1;
        boolean textured = false;
        TextureMap map = null;
        for (int i = 0; i < rays.hitCount; i++) {
            int ray = rays.order[i];
            int primitive = rays.primitive[ray];
            if (primitive != lastPrimitive) {
                lastPrimitive = primitive;
                int material = primitives.material[primitive];
                textured = materials.isTextured(material);
                map = materials.texture(material);
            }
            if (textured) {
                lookup.lookUp(primitives, primitive, rays.part[ray], map, rays.localX[i], rays.localY[i], rays.localZ[i], texel);
                rows.texelRed[row + i] = texel[0];
                rows.texelGreen[row + i] = texel[1];
                rows.texelBlue[row + i] = texel[2];
            }
        }
    }
}
