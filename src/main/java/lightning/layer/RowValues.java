package lightning.layer;

import lightning.base.math.Vec3;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.PixelRays;
import lightning.render.trace.PrincipledColors;
import lightning.scene.Camera;
import lightning.scene.material.Material;

/**
 * The values of {@link SurfaceValues} from stored rows, as images of three channels, {@code float[3][1024]} each; 0 where a ray hits
 * nothing. Holds scratch memory: use one per thread.
 */
final class RowValues {
    private final Geometry geometry;
    private final MaterialTable materials;
    private final Vec3 eye;
    private final Vec3 viewDirection;
    private final MappedSurface mapped = new MappedSurface();

    RowValues(PixelCache cache) {
        geometry = cache.geometry();
        materials = geometry.materials();
        eye = new PixelRays(cache.scene()).ray(0, 0).origin();
        Camera camera = cache.scene().camera();
        viewDirection = camera.to().minus(camera.from()).normalized();
    }

    float[][] normals(CachedTile tile) {
        float[][] to = new float[3][Film.TILE_PIXELS];
        HitRows rows = tile.rows();
        for (int row = 0; row < rows.count; row++) {
            put(to, rows.parent[row], rows.nx[row], rows.ny[row], rows.nz[row]);
        }
        return to;
    }

    /** Returns the positions in scene coordinates. */
    float[][] positions(CachedTile tile) {
        float[][] to = new float[3][Film.TILE_PIXELS];
        HitRows rows = tile.rows();
        for (int row = 0; row < rows.count; row++) {
            Vec3 point = geometry.toScene(new Vec3(rows.px[row], rows.py[row], rows.pz[row]));
            put(to, rows.parent[row], (float) point.x(), (float) point.y(), (float) point.z());
        }
        return to;
    }

    /** Returns 1 where a ray hits a surface, and its depth, in the first two channels. */
    float[][] hitsAndDepths(CachedTile tile) {
        float[][] to = new float[3][Film.TILE_PIXELS];
        HitRows rows = tile.rows();
        for (int row = 0; row < rows.count; row++) {
            Vec3 position = new Vec3(rows.px[row], rows.py[row], rows.pz[row]);
            put(to, rows.parent[row], 1, (float) position.minus(eye).dot(viewDirection), 0);
        }
        return to;
    }

    /** Returns the colors; faces of lights reflect nothing, so that they are black. */
    float[][] colors(CachedTile tile) {
        float[][] to = new float[3][Film.TILE_PIXELS];
        HitRows rows = tile.rows();
        for (int run = 0; run < rows.runCount; run++) {
            int m = rows.runMaterial[run];
            Material material = materials.material(m);
            boolean changesColors = material.isPrincipled() && material.surfaceMaps().changeColors();
            if (changesColors) {
                mapped.start(material, rows);
            }
            for (int row = rows.runStart(run); row < rows.runEnd[run]; row++) {
                if (changesColors) {
                    mapped.moveTo(row);
                }
                for (int c = 0; c < 3; c++) {
                    float[] texels = materials.isTextured(m) ? rows.texel(c) : null;
                    float texel = texels == null ? 1 : texels[row];
                    to[c][rows.parent[row]] = Math.min(1, changesColors ? color(new PrincipledColors(material), c, texel)
                            : materials.diffuse(m, c) * texel + (materials.metalF0(m, c) * texel + materials.specular(m, c)));
                }
            }
        }
        return to;
    }

    private float color(PrincipledColors colors, int c, float texel) {
        return colors.diffuse(c, mapped) * texel + colors.f0(c, mapped, texel);
    }

    private static void put(float[][] to, int parent, float x, float y, float z) {
        to[0][parent] = x;
        to[1][parent] = y;
        to[2][parent] = z;
    }
}
