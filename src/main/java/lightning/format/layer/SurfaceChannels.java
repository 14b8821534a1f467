package lightning.format.layer;

import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.node.Shape;
import tools.jackson.databind.json.JsonMapper;

/**
 * Surface data at the pixels' centers; not averaged over samples, because means of positions, directions or ids are
 * meaningless. The header contains the names of shapes and materials by id.
 */
final class SurfaceChannels implements ChannelSource {
    /** Normal, position, depth, shape id, material id and color. */
    private static final List<String> CHANNELS =
            List.of("N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "Z", "shape.id", "material.id", "albedo.R", "albedo.G", "albedo.B");
    /** Depth of the background, as in Blender. */
    private static final float BACKGROUND_DEPTH = 1e10f;

    private final PixelCache cache;
    private final ExrType normalType;
    private final PixelRays eye;
    private final Geometry geometry;
    private final Vec3 viewDirection;

    /** @param normalType type of normals and colors; all other channels are FLOAT */
    SurfaceChannels(PixelCache cache, ExrType normalType) {
        this.cache = cache;
        this.normalType = normalType;
        eye = new PixelRays(cache.scene());
        geometry = cache.geometry();
        viewDirection = cache.scene().camera().to().minus(cache.scene().camera().from()).normalized();
    }

    @Override
    public List<ExrChannel> channels() {
        return CHANNELS.stream()
                .map(name -> new ExrChannel(name, name.startsWith("N.") || name.startsWith("albedo.") ? normalType : ExrType.FLOAT))
                .toList();
    }

    @Override
    public Map<String, ExrAttribute> attributes() {
        JsonMapper json = new JsonMapper();
        List<String> shapes = cache.scene().stage().shapes().stream().map(Shape::name).toList();
        List<String> materials =
                IntStream.range(0, geometry.materials().count()).mapToObj(m -> geometry.materials().material(m).name()).toList();
        return Map.of("lightning/shapes", new ExrAttribute.Text(json.writeValueAsString(shapes)), "lightning/materials",
                new ExrAttribute.Text(json.writeValueAsString(materials)));
    }

    @Override
    public TileWriter writer(Engine engine) {
        float[] values = new float[CHANNELS.size()];
        return (_, _, sink) -> sink.forEachPixel((x, y, _) -> {
            sample(x, y, values);
            for (int i = 0; i < values.length; i++) {
                sink.put(i, x, y, values[i]);
            }
        });
    }

    /** Writes the values of a pixel, in the order of {@link #CHANNELS}; all except the depth are 0 for the background. Faces of lights have no
     * ids. */
    private void sample(int x, int y, float[] out) {
        Ray ray = eye.ray(x, y);
        int primitive = geometry.nearest(ray);
        if (primitive < 0) {
            java.util.Arrays.fill(out, 0);
            out[6] = BACKGROUND_DEPTH;
            return;
        }
        SurfacePoint surface = geometry.surface(primitive, ray);
        Vec3 position = new Vec3(surface.px(), surface.py(), surface.pz());
        Vec3 point = geometry.toScene(position);
        out[0] = surface.nx();
        out[1] = surface.ny();
        out[2] = surface.nz();
        out[3] = (float) point.x();
        out[4] = (float) point.y();
        out[5] = (float) point.z();
        out[6] = (float) position.minus(ray.origin()).dot(viewDirection);
        boolean isObject = !geometry.isLightFace(primitive);
        out[7] = isObject ? geometry.owner(primitive) + 1 : 0;
        out[8] = isObject ? surface.material() + 1 : 0;
        for (int c = 0; c < 3; c++) {
            out[9 + c] = isObject ? Math.min(1, surface.diffuse()[c] + surface.specular()[c]) : 0;
        }
    }
}
