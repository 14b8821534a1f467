package lightning.trace;

/**
 * Writes what a hit looks like, for rows whose surfaces were just computed: the texels of textured materials, and the codes
 * that anti-aliasing compares. Holds scratch memory: one for each thread.
 */
final class TexelColumns {
    private final ShapeTable shapes;
    private final MaterialTable materials;
    private final float[] texel = new float[3];

    TexelColumns(Geometry geometry) {
        shapes = geometry.shapes();
        materials = geometry.materials();
    }

    /** Writes rows {@code row … row + live − 1}, which the lanes of the packet hit and whose normals are written. */
    void write(HitRows rows, int row, int live, RayPacket packet, SurfacePacket surface) {
        for (int i = 0; i < live; i++) {
            int r = row + i;
            int hit = packet.shape[i];
            boolean textured = materials.isTextured(shapes.material[hit]);
            if (textured) {
                TextureLookup.sample(materials.texture(shapes.material[hit]), shapes.kind[hit],
                        surface.ownX[i], surface.ownY[i], surface.ownZ[i], texel);
                rows.texelRed[r] = texel[0];
                rows.texelGreen[r] = texel[1];
                rows.texelBlue[r] = texel[2];
            }
            if (rows.code != null) {
                rows.code[r] = textured ? HitCode.of(hit, rows.nx[r], rows.ny[r], rows.nz[r], texel[0], texel[1], texel[2])
                        : HitCode.of(hit, rows.nx[r], rows.ny[r], rows.nz[r]);
            }
        }
    }
}
