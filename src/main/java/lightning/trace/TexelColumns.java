package lightning.trace;

/** Writes the texels of rows whose surfaces were just computed. Holds scratch memory: one for each thread. */
final class TexelColumns {
    private final ShapeTable shapes;
    private final MaterialTable materials;
    private final float[] texel = new float[3];

    TexelColumns(Geometry geometry) {
        shapes = geometry.shapes();
        materials = geometry.materials();
    }

    /** Writes rows {@code row … row + live − 1}, which the lanes of the packet hit. */
    void write(HitRows rows, int row, int live, RayPacket packet, SurfacePacket surface) {
        for (int i = 0; i < live; i++) {
            int material = shapes.material[packet.shape[i]];
            if (materials.isTextured(material)) {
                TextureLookup.sample(materials.texture(material), shapes.kind[packet.shape[i]],
                        surface.ownX[i], surface.ownY[i], surface.ownZ[i], texel);
                rows.texelRed[row + i] = texel[0];
                rows.texelGreen[row + i] = texel[1];
                rows.texelBlue[row + i] = texel[2];
            }
        }
    }
}
