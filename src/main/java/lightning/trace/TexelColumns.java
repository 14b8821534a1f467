package lightning.trace;

import lightning.trace.mesh.Facet;
import lightning.trace.primitive.PrimitiveTable;

/** Writes the texels of rows whose surfaces were just computed. Holds scratch memory: one for each thread. */
final class TexelColumns {
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final float[] texel = new float[3];
    private final Facet facet = new Facet();

    TexelColumns(Geometry geometry) {
        primitives = geometry.primitives();
        materials = geometry.materials();
    }

    /** Writes the rows from {@code row} on, which are the hits of the rays in their order. */
    void write(HitRows rows, int row, RayColumns rays) {
        for (int i = 0; i < rays.hits; i++) {
            int ray = rays.order[i];
            int primitive = rays.primitive[ray];
            int material = primitives.material[primitive];
            if (materials.isTextured(material)) {
                primitives.texel(primitive, rays.part[ray], materials.texture(material), rays.ownX[i], rays.ownY[i], rays.ownZ[i], facet,
                        texel);
                rows.texelRed[row + i] = texel[0];
                rows.texelGreen[row + i] = texel[1];
                rows.texelBlue[row + i] = texel[2];
            }
        }
    }
}
