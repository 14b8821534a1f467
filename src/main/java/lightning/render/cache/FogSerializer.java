package lightning.render.cache;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.List;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRays;
import lightning.render.shading.fog.FogLight;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.fog.PictureFog;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** Writes and reads fog of cached images: of the picture, and before the surfaces of each tile. */
final class FogSerializer {
    private FogSerializer() {}

    /** Writes the fog of a scene that a picture shows. */
    static void write(CachedScene shown, ColumnWriter out) throws IOException {
        PictureFog fog = shown.fog();
        out.writeInt(fog == null ? 0 : 1);
        if (fog != null) {
            out.writeFloatArrays(new float[][] {fog.depths()});
            writeRays(fog.rays(), out);
        }
        for (int l = 0; fog != null && l < fog.lights().length; l++) {
            FogLight light = fog.lights()[l];
            out.writeInt(light == null ? 0 : 1);
            if (light != null) {
                out.writeArray(light.visible());
                out.writeFloatArrays(new float[][] {light.parts()});
            }
        }
    }

    /** Writes bounced rays; camera rays follow from the scene. */
    private static void writeRays(FogRays rays, ColumnWriter out) throws IOException {
        switch (rays) {
            case FogGrid _ -> out.writeInt(0);
            case BounceRays bounced -> {
                out.writeInt(1);
                out.writeArray(bounced.gridRay());
                out.writeArray(bounced.path());
                out.writeArray(bounced.material());
                out.writeFloatArrays(bounced.lines());
            }
        }
    }

    private static FogRays readRays(FogGrid grid, ColumnReader in) throws IOException {
        return in.readInt() == 0 ? grid
                : new BounceRays(grid, in.readInts(), in.readInts(), in.readInts(), requireNonNull(in.readOptionalFloatArrays()));
    }

    static @Nullable PictureFog read(Scene scene, ColumnReader in) throws IOException {
        if (in.readInt() == 0) {
            return null;
        }
        List<Light> lights = scene.rig().effectiveLights();
        FogMedium medium = requireNonNull(FogMedium.of(scene));
        float[] depths = requireNonNull(in.readOptionalFloatArrays())[0];
        FogRays rays = readRays(new FogGrid(scene.camera(), scene.picture()), in);
        @Nullable
        FogLight[] read = new FogLight[lights.size()];
        for (int l = 0; l < read.length; l++) {
            if (in.readInt() != 0) {
                read[l] = new FogLight(lights.get(l), medium, scene.world().fog().anisotropy(), depths, in.readInts(),
                        requireNonNull(in.readOptionalFloatArrays())[0]);
            }
        }
        return new PictureFog(rays, medium, depths, read);
    }

    static void write(@Nullable FogTile tile, ColumnWriter out) throws IOException {
        out.writeInt(tile == null ? 0 : 1);
        if (tile != null) {
            out.writeFloatArrays(new float[][] {tile.transmittance()});
            for (float[] column : tile.scattered()) {
                out.writeFloatArrays(column == null ? null : new float[][] {column});
            }
        }
    }

    static @Nullable FogTile read(@Nullable PictureFog fog, ColumnReader in) throws IOException {
        if (in.readInt() == 0) {
            return null;
        }
        FogLight[] lights = requireNonNull(fog).lights();
        float[] transmittance = requireNonNull(in.readOptionalFloatArrays())[0];
        float[] @Nullable [] scattered = new float[lights.length][];
        @Nullable
        FogLight[] sources = new FogLight[lights.length];
        for (int l = 0; l < lights.length; l++) {
            float[][] column = in.readOptionalFloatArrays();
            scattered[l] = column == null ? null : column[0];
            sources[l] = column == null ? null : lights[l];
        }
        return new FogTile(fog.medium(), transmittance, sources, scattered);
    }
}
