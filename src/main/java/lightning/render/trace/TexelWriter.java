package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.primitive.SurfaceTangent;
import lightning.render.trace.primitive.TextureFootprint;
import lightning.render.trace.primitive.TextureLookup;
import lightning.scene.asset.TextureMap;

/**
 * Writes the colors of vertices and of the materials' images, and the tangents, of rows whose surfaces were just computed. Holds scratch memory: use one per
 * thread.
 */
final class TexelWriter {
    private final PrimitiveTable primitives;
    private final MaterialTable materials;
    private final float[] texel = new float[3];
    private final SurfaceHit surface = new SurfaceHit();
    private final TextureLookup lookup = new TextureLookup();
    private final TextureFootprint footprint = new TextureFootprint();
    private final SurfaceTangent tangent = new SurfaceTangent();

    TexelWriter(Geometry geometry) {
        primitives = geometry.primitives();
        materials = geometry.materials();
    }

    /**
     * Writes texels from {@code row} on. The rows are the rays' hits in order; consecutive ones often have the same primitive.
     */
    void write(HitRows rows, int row, RayColumns rays) {
        for (ColumnGroup group : ColumnGroup.TEXELS) {
            if (rows.texel(group, 0) != null) {
                if (group == ColumnGroup.COAT_NORMAL) {
                    writeCoatNormals(rows, row, rays);
                } else {
                    write(group, rows, row, rays);
                }
            }
        }
        if (rows.tangentX != null) {
            writeTangents(rows, row, rays);
        }
    }

    private void writeTangents(HitRows rows, int row, RayColumns rays) {
        float[][] columns = rows.texels(ColumnGroup.TANGENT);
        for (int i = 0; i < rays.hitCount; i++) {
            int ray = rays.order[i];
            int primitive = rays.primitive[ray];
            if (materials.texels(primitives.material[primitive]).has(ColumnGroup.TANGENT)) {
                int to = row + i;
                tangent.compute(primitives, primitive, rays.part[ray], rays.localX[i], rays.localY[i], rays.localZ[i], rows.nx[to],
                        rows.ny[to], rows.nz[to], texel);
                writeTexel(columns, 0, to);
            }
        }
    }

    private void write(ColumnGroup group, HitRows rows, int row, RayColumns rays) {
        float[][] columns = rows.texels(group);
        int lastPrimitive = -1;
        boolean isMapped = false;
        int firstChannel = 0;
        TextureMap map = null;
        for (int i = 0; i < rays.hitCount; i++) {
            int ray = rays.order[i];
            int primitive = rays.primitive[ray];
            if (primitive != lastPrimitive) {
                lastPrimitive = primitive;
                int material = primitives.material[primitive];
                isMapped = materials.texels(material).has(group);
                firstChannel = group.firstChannel(materials.material(material));
                map = materials.map(group, material);
            }
            if (isMapped) {
                if (group == ColumnGroup.TEXEL) {
                    lookup.lookUp(primitives, primitive, rays.part[ray], map, rays.localX[i], rays.localY[i], rays.localZ[i], texel);
                } else {
                    lookup.lookUpMap(primitives, primitive, rays.part[ray], requireNonNull(map), rays.localX[i], rays.localY[i],
                            rays.localZ[i], texel);
                }
                writeTexel(columns, firstChannel, row + i);
            }
        }
    }

    private void writeCoatNormals(HitRows rows, int row, RayColumns rays) {
        float[][] columns = rows.texels(ColumnGroup.COAT_NORMAL);
        for (int i = 0; i < rays.hitCount; i++) {
            int ray = rays.order[i];
            int primitive = rays.primitive[ray];
            int material = primitives.material[primitive];
            if (materials.texels(material).has(ColumnGroup.COAT_NORMAL)) {
                surface.computeNormal(primitives, primitive, rays.part[ray], rays.originX(ray), rays.originY(ray), rays.originZ(ray),
                        rays.dx[ray], rays.dy[ray], rays.dz[ray], rays.t[ray]);
                surface.computeCoatNormal(primitives, primitive, materials.material(material).coatNormals().map(), rays.dx[ray],
                        rays.dy[ray], rays.dz[ray]);
                columns[0][row + i] = surface.nx;
                columns[1][row + i] = surface.ny;
                columns[2][row + i] = surface.nz;
            }
        }
    }

    private void writeTexel(float[][] columns, int firstChannel, int row) {
        for (int c = 0; c < columns.length; c++) {
            columns[c][row] = texel[firstChannel + c];
        }
    }

    /**
     * Replaces the texels of rows by means over squares on their surfaces.
     *
     * @param rows  hits of the rays, in order
     * @param sides side of each row's square, scene units
     */
    void writeMeans(HitRows rows, RayColumns rays, double[] sides) {
        for (ColumnGroup group : ColumnGroup.TEXELS) {
            if (rows.texel(group, 0) != null && group != ColumnGroup.COAT_NORMAL) {
                writeMeans(group, rows, rays, sides);
            }
        }
    }

    private void writeMeans(ColumnGroup group, HitRows rows, RayColumns rays, double[] sides) {
        float[][] columns = rows.texels(group);
        for (int row = 0; row < rows.count; row++) {
            int ray = rays.order[row];
            int primitive = rays.primitive[ray];
            int material = primitives.material[primitive];
            if (materials.texels(material).has(group)) {
                writeMean(group, primitive, rays.part[ray], rays, rows, row, sides[row]);
                writeTexel(columns, group.firstChannel(materials.material(material)), row);
            }
        }
    }

    private void writeMean(ColumnGroup group, int primitive, int part, RayColumns rays, HitRows rows, int row, double side) {
        TextureMap map = materials.map(group, primitives.material[primitive]);
        if (group == ColumnGroup.TEXEL) {
            footprint.lookUp(primitives, primitive, part, map, rays.localX[row], rays.localY[row], rays.localZ[row], rows.nx[row],
                    rows.ny[row], rows.nz[row], side, texel);
        } else {
            footprint.lookUpMap(primitives, primitive, part, requireNonNull(map), rays.localX[row], rays.localY[row], rays.localZ[row],
                    rows.nx[row],
                    rows.ny[row], rows.nz[row], side, texel);
        }
    }
}
