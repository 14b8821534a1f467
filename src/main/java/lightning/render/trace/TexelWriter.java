package lightning.render.trace;

import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.TextureFootprint;
import lightning.render.trace.primitive.TextureLookup;
import lightning.scene.asset.TextureMap;

/** Writes the colors of textures, vertices and glow maps of rows whose surfaces were just computed. Holds scratch memory: use one per thread. */
final class TexelWriter {
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final float[] texel = new float[3];
    private final TextureLookup lookup = new TextureLookup();
    private final TextureFootprint footprint = new TextureFootprint();

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
        TextureMap glowMap = null;
        for (int i = 0; i < rays.hitCount; i++) {
            int ray = rays.order[i];
            int primitive = rays.primitive[ray];
            if (primitive != lastPrimitive) {
                lastPrimitive = primitive;
                int material = primitives.material[primitive];
                textured = materials.isTextured(material);
                map = materials.texture(material);
                glowMap = materials.glowMap(material);
            }
            if (textured) {
                lookup.lookUp(primitives, primitive, rays.part[ray], map, rays.localX[i], rays.localY[i], rays.localZ[i], texel);
                rows.texelRed[row + i] = texel[0];
                rows.texelGreen[row + i] = texel[1];
                rows.texelBlue[row + i] = texel[2];
            }
            if (glowMap != null) {
                lookup.lookUpMap(primitives, primitive, rays.part[ray], glowMap, rays.localX[i], rays.localY[i], rays.localZ[i], texel);
                writeGlow(rows, row + i);
            }
        }
    }

    /**
     * Replaces the texels of rows by means over squares on their surfaces.
     *
     * @param rows  hits of the rays, in order
     * @param sides side of each row's square, scene units
     */
    void writeMeans(HitRows rows, RayColumns rays, double[] sides) {
        for (int row = 0; row < rows.count; row++) {
            int ray = rays.order[row];
            int primitive = rays.primitive[ray];
            int material = primitives.material[primitive];
            if (materials.isTextured(material)) {
                footprint.lookUp(primitives, primitive, rays.part[ray], materials.texture(material), rays.localX[row], rays.localY[row],
                        rays.localZ[row], rows.nx[row], rows.ny[row], rows.nz[row], sides[row], texel);
                rows.texelRed[row] = texel[0];
                rows.texelGreen[row] = texel[1];
                rows.texelBlue[row] = texel[2];
            }
            if (materials.glowMap(material) != null) {
                footprint.lookUpMap(primitives, primitive, rays.part[ray], materials.glowMap(material), rays.localX[row], rays.localY[row],
                        rays.localZ[row], rows.nx[row], rows.ny[row], rows.nz[row], sides[row], texel);
                writeGlow(rows, row);
            }
        }
    }

    private void writeGlow(HitRows rows, int row) {
        rows.glowTexelRed[row] = texel[0];
        rows.glowTexelGreen[row] = texel[1];
        rows.glowTexelBlue[row] = texel[2];
    }
}
